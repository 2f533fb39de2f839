// Fourth pass of a relaxation, one workgroup an instance: adds up the sums and updates FIRE's step and mixing.

@compute @workgroup_size(WORKGROUP)
fn fire_update(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let instance = group.y;
    var own = vec4<f32>(0.0);
    for (var i = local; i < SUMS; i += WORKGROUP) {
        own += partials[instance * SUMS + i];
    }
    let sums = workgroup_sum(local, own);
    if (local == 0u && control[instance].stop == RUNNING) {
        if (atomicLoad(&control[instance].bad_node) != NONE) {
            control[instance].stop = DIVERGED;
        } else if (control[instance].step >= control[instance].limit) {
            control[instance].stop = LIMITED;
        } else {
            update_fire(instance, sums);
        }
    }
}
