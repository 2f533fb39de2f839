// The force on a node: that of its springs.

fn force_on(instance: u32, n: u32) -> vec3<f32> {
    return gathered(instance, n).xyz;
}
