// A sheet of which no area resists: its material's `collapse` is 0.

fn area_spring(instance: u32, f: u32, own: Face, doubled_area: f32) -> vec2<f32> {
    return vec2<f32>(0.0);
}
