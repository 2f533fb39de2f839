// Dynamics: one thread keeps the time between the passes that read it.

fn advance_clock(instance: u32) {
    if (atomicLoad(&control[instance].bad_node) != NONE) {
        control[instance].stop = DIVERGED;
        return;
    }
    control[instance].step += 1u;
    control[instance].ramp_before = control[instance].ramp_step;
    control[instance].ramp_step = min(control[instance].ramp_step + 1u, control[instance].ramp_length);
    control[instance].previous_step = control[instance].time_step;
    control[instance].time_step = control[instance].next_step;
    atomicStore(&control[instance].distance_squared_max, 0u);
    atomicStore(&control[instance].move_squared_max, 0u);
}
