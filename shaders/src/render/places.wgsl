// Where the nodes of a simulation are, for drawing: after state.wgsl, whose nodes keep more digits than a picture needs.

@group(0) @binding(14) var<storage, read_write> places: array<vec4<f32>>;

@compute @workgroup_size(WORKGROUP)
fn place_nodes(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x >= NODES) {
        return;
    }
    let node = place(id.x);
    places[id.x] = vec4<f32>(vec3<f32>(node.high) * QUANTUM + node.low, 0.0);
}
