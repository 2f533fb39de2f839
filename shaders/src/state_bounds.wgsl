// Before a checkpoint: how far out the nodes are, and how far they move in a step.

@compute @workgroup_size(WORKGROUP)
fn state_bounds(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < NODES && control[id.y].stop == RUNNING) {
        let node = id.y * NODES + id.x;
        let position = vec3<f32>(nodes[node].high) * QUANTUM + nodes[node].low;
        let step = select(control[id.y].time_step, control[id.y].fire_step, RELAXING);
        let displacement = nodes[node].velocity * step;
        atomicMax(&control[id.y].distance_squared_max, bitcast<u32>(dot(position, position)) & 0x7fffffffu);
        atomicMax(&control[id.y].move_squared_max, bitcast<u32>(dot(displacement, displacement)) & 0x7fffffffu);
    }
}
