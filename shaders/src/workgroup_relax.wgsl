// Relaxation of a small sheet: one workgroup an instance makes many evaluations, with barriers where the passes would be.

@compute @workgroup_size(WORKGROUP)
fn workgroup_relax(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let instance = group.y;
    open_sheet(instance, local);
    for (var s = 0u; s < STEPS; s++) {
        if (local == 0u) {
            if (control[instance].stop == RUNNING && atomicLoad(&control[instance].bad_node) != NONE) {
                control[instance].stop = DIVERGED;
            }
            next = next_step(instance, renews(instance));
        }
        let does = workgroupUniformLoad(&next);
        if (does == STOPS) {
            break;
        }
        mine.force = force_on_mine(instance, local);
        if ((does & RENEWS) != 0u) {
            mine.mass = row_sum_of_mine(instance, local);
        }
        if ((does & CHECKS) != 0u) {
            check_sheet(instance, local, mine.force);
        }
        var own = vec4<f32>(0.0);
        if (local < NODES) {
            own = fire_sums(mine);
        }
        let sums = workgroup_sum(local, own);
        if (local == 0u && control[instance].stop == RUNNING) {
            update_fire(instance, sums);
        }
        storageBarrier();
        if (local < NODES && control[instance].stop == RUNNING) {
            mine = turned(instance, local, mine);
        }
        show_mine(local);
        storageBarrier();
    }
    close_sheet(instance, local);
}
