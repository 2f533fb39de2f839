// The safe time step: SAFE_SHARE of the longest for which K dt^2 + 2 D dt < 4, renewed as the geometry changes; no longer than
// what takes the swiftest node SAFE_MOVE far, and little longer than the one before.

override SAFE_SHARE: f32 = 0.9;
override SAFE_MOVE: f32 = 0.1;
override SAFE_GROWTH: f32 = 1.025;

@compute @workgroup_size(1)
fn renew(@builtin(workgroup_id) id: vec3<u32>) {
    if (control[id.y].stop != RUNNING) {
        return;
    }
    let stiffness = bitcast<f32>(atomicExchange(&control[id.y].stiffest, 0u));
    let damping = control[id.y].damping_sum;
    let velocity = sqrt(bitcast<f32>(atomicExchange(&control[id.y].swiftest, 0u)));
    var next = SAFE_SHARE * 4.0 / (damping + sqrt(damping * damping + 4.0 * stiffness));
    if (next * velocity > SAFE_MOVE) {
        next = SAFE_MOVE / velocity;
    }
    if (control[id.y].step > 0u) {
        next = min(next, SAFE_GROWTH * control[id.y].next_step);
    }
    control[id.y].next_step = next;
}
