// The safe time step: SAFE_SHARE of the longest for which K dt^2 + 2 D dt < 4, renewed as the geometry changes. It takes the
// fastest node no farther than SAFE_MOVE, and is little longer than the step before.

override SAFE_SHARE: f32;
override SAFE_MOVE: f32;
override SAFE_GROWTH: f32;

@compute @workgroup_size(1)
fn safe_time_step(@builtin(workgroup_id) id: vec3<u32>) {
    if (control[id.y].stop != RUNNING) {
        return;
    }
    let stiffness = bitcast<f32>(atomicExchange(&control[id.y].stiffness_max, 0u));
    let damping = control[id.y].damping_sum;
    let velocity = sqrt(bitcast<f32>(atomicExchange(&control[id.y].speed_squared_max, 0u)));
    var next = SAFE_SHARE * 4.0 / (damping + sqrt(damping * damping + 4.0 * stiffness));
    if (next * velocity > SAFE_MOVE) {
        next = SAFE_MOVE / velocity;
    }
    if (control[id.y].step > 0u) {
        next = min(next, SAFE_GROWTH * control[id.y].next_step);
    }
    control[id.y].next_step = next;
}
