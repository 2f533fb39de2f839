// Relaxation of a small sheet: one workgroup an instance makes many evaluations, with barriers where the passes would be.

override STEPS: u32;

var<workgroup> goes_on: u32;

@compute @workgroup_size(WORKGROUP)
fn workgroup_relax(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let instance = group.y;
    for (var s = 0u; s < STEPS; s++) {
        if (local == 0u) {
            if (control[instance].stop == RUNNING && atomicLoad(&control[instance].bad_node) != NONE) {
                control[instance].stop = DIVERGED;
            }
            goes_on = u32(control[instance].stop == RUNNING && control[instance].step < control[instance].limit);
        }
        if (workgroupUniformLoad(&goes_on) == 0u) {
            break;
        }
        for (var c = local; c < CREASES; c += WORKGROUP) {
            fold_angle(instance, c);
        }
        storageBarrier();
        let renewal = renews(instance);
        for (var f = local; f < FACES; f += WORKGROUP) {
            forces_of_triangle(instance, f);
            if (renewal) {
                face_sums(instance, f);
            }
        }
        storageBarrier();
        var own = vec4<f32>(0.0);
        for (var n = local; n < NODES; n += WORKGROUP) {
            own += reduce_node(instance, n, gathered(instance, n));
        }
        let sums = workgroup_sum(local, own);
        if (local == 0u) {
            update_fire(instance, sums);
        }
        storageBarrier();
        for (var n = local; n < NODES; n += WORKGROUP) {
            move_node(instance, n);
        }
        storageBarrier();
    }
}
