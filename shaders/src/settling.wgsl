// The stopping rule, per instance: were the energy a parabola along the window's move, its minimum would lie
// |F.dx| / |dx.dF| moves further on.

// A move by less than this share of the tolerance, which the forces do not feel in f32, is rest.
const STILL: f32 = 1e-3;

fn estimate(found: vec4<f32>, tolerance: f32) -> f32 {
    let largest = sqrt(found.x);
    let least = found.y;
    if (largest == 0.0) {
        return least;
    }
    // No change of force along a move: nothing tells how far the minimum is.
    if (found.w == 0.0) {
        return select(1e30, max(largest, least), largest < STILL * tolerance);
    }
    return max(max(largest, largest * abs(found.z / found.w)), least);
}

fn decide_at_window(instance: u32, found: vec4<f32>) {
    let checks = control[instance].checks;
    if (window_ends(instance)) {
        if (control[instance].window_is_sound != 0u) {
            let distance = estimate(found, control[instance].tolerance);
            control[instance].distance = distance;
            let share = distance / control[instance].tolerance;
            if (share < SMALL_SHARE) {
                control[instance].settled_windows += 2u;
            } else if (share < SHARE) {
                control[instance].settled_windows += 1u;
            } else {
                control[instance].settled_windows = 0u;
            }
        }
        let past = checks - control[instance].disturbed_at;
        control[instance].window_end = checks + max(1u, u32(ceil(SHARE_OF_PAST * f32(past))));
        control[instance].window_is_sound = 1u;
    }
    control[instance].checks = checks + 1u;
    let settled = control[instance].settled_windows >= WINDOWS && checks >= LEAST_CHECKS;
    if (settled && control[instance].stops_when_settled != 0u) {
        control[instance].stop = SETTLED;
        if (RELAXING) {
            control[instance].step += 1u;
        }
    }
}
