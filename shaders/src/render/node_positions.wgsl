// Positions of a simulation's nodes in f32, for drawing. It comes after state.wgsl, whose nodes keep more digits than a
// picture needs.

@group(0) @binding(14) var<storage, read_write> positions: array<vec4<f32>>;

@compute @workgroup_size(WORKGROUP)
fn node_positions(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x >= NODES) {
        return;
    }
    let node = position_of(id.x);
    positions[id.x] = vec4<f32>(vec3<f32>(node.high) * QUANTUM + node.low, 0.0);
}
