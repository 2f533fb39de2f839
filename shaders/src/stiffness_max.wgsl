// The largest row sum of an instance and the square of its largest velocity, for the safe time step.

@compute @workgroup_size(WORKGROUP)
fn stiffness_max(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < NODES && control[id.y].stop == RUNNING) {
        // The order of positive floats is that of their bits, and a maximum does not depend on the order of arrival.
        atomicMax(&control[id.y].stiffness_max, bitcast<u32>(gathered(id.y, id.x).w));
        let velocity = nodes[id.y * NODES + id.x].velocity;
        atomicMax(&control[id.y].speed_squared_max, bitcast<u32>(dot(velocity, velocity)) & 0x7fffffffu);
    }
}
