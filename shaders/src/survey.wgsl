// Before a state is kept: how far out its nodes are, and how fast.

@compute @workgroup_size(WORKGROUP)
fn survey(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < NODES && control[id.y].stop == RUNNING) {
        let node = id.y * NODES + id.x;
        let position = vec3<f32>(nodes[node].high) * QUANTUM + nodes[node].low;
        let step = select(control[id.y].time_step, control[id.y].fire_step, RELAXING);
        let way = nodes[node].velocity * step;
        atomicMax(&control[id.y].farthest, bitcast<u32>(dot(position, position)) & 0x7fffffffu);
        atomicMax(&control[id.y].fastest, bitcast<u32>(dot(way, way)) & 0x7fffffffu);
    }
}
