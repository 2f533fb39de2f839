// The safe time step: SAFE_SHARE of the longest for which K dt^2 + 2 D dt < 4, renewed as the geometry changes. It takes the
// fastest node no farther than SAFE_MOVE, and is little longer than the step before.

override SAFE_SHARE: f32;
override SAFE_MOVE: f32;
override SAFE_GROWTH: f32;

fn renew_time_step(instance: u32) {
    let stiffness = bitcast<f32>(atomicExchange(&control[instance].stiffness_max, 0u));
    let damping = control[instance].damping_sum;
    let velocity = sqrt(bitcast<f32>(atomicExchange(&control[instance].speed_squared_max, 0u)));
    var next = SAFE_SHARE * 4.0 / (damping + sqrt(damping * damping + 4.0 * stiffness));
    if (next * velocity > SAFE_MOVE) {
        next = SAFE_MOVE / velocity;
    }
    if (control[instance].step > 0u) {
        next = min(next, SAFE_GROWTH * control[instance].next_step);
    }
    control[instance].next_step = next;
}

// Notes the row sum of a node and its velocity.
fn note_stiffness(instance: u32, row_sum: f32, velocity: vec3<f32>) {
    // The order of positive floats is that of their bits, and a maximum does not depend on the order of arrival.
    atomicMax(&control[instance].stiffness_max, bitcast<u32>(row_sum));
    atomicMax(&control[instance].speed_squared_max, bitcast<u32>(dot(velocity, velocity)) & 0x7fffffffu);
}
