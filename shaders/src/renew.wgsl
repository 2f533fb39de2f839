// The safe time step: 0.9 of the longest for which K dt^2 + 2 D dt < 4, renewed as the geometry changes.

@compute @workgroup_size(1)
fn renew(@builtin(workgroup_id) id: vec3<u32>) {
    if (control[id.y].stop != RUNNING) {
        return;
    }
    let stiffness = bitcast<f32>(atomicExchange(&control[id.y].stiffest, 0u));
    let damping = control[id.y].damping_sum;
    control[id.y].next_step = 0.9 * 4.0 / (damping + sqrt(damping * damping + 4.0 * stiffness));
}
