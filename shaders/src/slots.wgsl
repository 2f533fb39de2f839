// Where the passes leave forces for the nodes to sum.

// Force on a node from one of its triangles; the last number is what that triangle adds to the row sum of the node's
// stiffness.
@group(0) @binding(5) var<storage, read_write> slots: array<vec4<f32>>;

fn put_force(instance: u32, slot: u32, force: vec3<f32>) {
    slots[instance * SLOTS + slot] = vec4<f32>(force, 0.0);
}

fn put_row_sum(instance: u32, slot: u32, sum: f32) {
    slots[instance * SLOTS + slot].w = sum;
}
