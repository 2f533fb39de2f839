// A scene without loads.

fn load_on(instance: u32, n: u32) -> vec3<f32> {
    return vec3<f32>(0.0);
}
