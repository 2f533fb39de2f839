// The force on a node: that of its springs and of the layers next to it.

fn force_on(instance: u32, n: u32) -> vec3<f32> {
    return gathered(instance, n).xyz + pushed(instance, n).xyz;
}
