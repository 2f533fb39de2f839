// Dynamics of a small sheet: one workgroup an instance takes many steps, with barriers where the passes would be.

// Steps between two renewals of the time step; 0 where it stays.
override SAFE_RENEWAL: u32;

@compute @workgroup_size(WORKGROUP)
fn workgroup_dynamics(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let instance = group.y;
    open_sheet(instance, local);
    for (var s = 0u; s < STEPS; s++) {
        if (local == 0u) {
            let step = control[instance].step;
            next = next_step(instance, SAFE_RENEWAL > 0u && step > 0u && step % max(SAFE_RENEWAL, 1u) == 0u);
        }
        let does = workgroupUniformLoad(&next);
        if (does == STOPS) {
            break;
        }
        if (does != GOES) {
            damps = false;
            let force = force_on_mine(instance, local);
            damps = true;
            if ((does & RENEWS) != 0u) {
                let sum = row_sum_of_mine(instance, local);
                if (local < NODES) {
                    note_stiffness(instance, sum, mine.velocity);
                }
            }
            if ((does & CHECKS) != 0u) {
                check_sheet(instance, local, force);
            }
            storageBarrier();
            if ((does & RENEWS) != 0u && local == 0u) {
                renew_time_step(instance);
            }
            storageBarrier();
        }
        let force = force_on_mine(instance, local);
        if (local == 0u && control[instance].stop == RUNNING) {
            advance_clock(instance);
        }
        storageBarrier();
        if (local < NODES && control[instance].stop == RUNNING) {
            mine = stepped(instance, local, mine, force);
        }
        show_mine(local);
        storageBarrier();
    }
    close_sheet(instance, local);
}
