// The last pass under contact, one invocation an instance: keeps count of shortened moves, and lets the sheet stand still where its
// list of pairs is spent, or where layers have held it up for too long.

// Evaluations for which it goes on at the final targets while it is held up, and for which a shortened move is recent.
override HELD_UP_AFTER: u32;
override RECENT: u32;

// Why an instance stands still: it waits for a list of pairs, or comes no nearer.
const SPENT: u32 = 4u;
const HELD_UP: u32 = 5u;

@compute @workgroup_size(1)
fn contact_clock(@builtin(workgroup_id) group: vec3<u32>) {
    let instance = group.y;
    if (control[instance].stop != RUNNING) {
        return;
    }
    let is_limited = atomicExchange(&touch[instance].limited_now, 0u) != 0u;
    let is_spent = atomicExchange(&touch[instance].spent, 0u) != 0u;
    let step = control[instance].step;
    if (control[instance].ramp_before < control[instance].ramp_length) {
        touch[instance].arrived = step;
    }
    let has_arrived = control[instance].ramp_step >= control[instance].ramp_length;
    if (is_limited) {
        if (touch[instance].limited == 0u) {
            touch[instance].first_limited = control[instance].ramp_before;
        }
        touch[instance].limited += 1u;
        touch[instance].last_limited = step;
        if (has_arrived) {
            // What the sheet looked like before counts no more: `Windows::disturb` of the core.
            let checks = control[instance].checks;
            control[instance].settled_windows = 0u;
            control[instance].window_is_sound = 0u;
            control[instance].disturbed_at = checks;
            control[instance].window_end = min(control[instance].window_end, checks + 1u);
            control[instance].distance = 1e30;
        }
    }
    let recently = touch[instance].limited > 0u && step - touch[instance].last_limited <= RECENT;
    let waited = has_arrived && step - touch[instance].arrived > HELD_UP_AFTER;
    if (waited && recently && control[instance].stops_when_settled != 0u) {
        control[instance].stop = HELD_UP;
    } else if (is_spent) {
        control[instance].stop = SPENT;
    }
}
