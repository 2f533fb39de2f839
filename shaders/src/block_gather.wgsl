// What `block_forces` has left for each node.

@group(0) @binding(5) var<storage, read_write> slots: array<vec4<f32>>;

fn gathered(instance: u32, n: u32) -> vec4<f32> {
    return slots[instance * NODES + n];
}
