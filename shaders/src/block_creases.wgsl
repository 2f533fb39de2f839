// The state of a block's creases; the ramp leads between two target angles.

@group(0) @binding(27) var<storage, read> targets: array<vec2<f32>>;

// The fold angle of the evaluation before.
fn angle_before(instance: u32, c: u32) -> f32 {
    return angles[instance * CREASES + block.first_crease + c];
}

fn target_angle(instance: u32, c: u32, share: f32) -> f32 {
    let ends = targets[instance * CREASES + block.first_crease + c];
    return ends.x * (1.0 - share) + ends.y * share;
}

fn put_angle(instance: u32, c: u32, angle: f32) {
    angles[instance * CREASES + block.first_crease + c] = angle;
}
