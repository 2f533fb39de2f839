// Dynamics of a small sheet: one workgroup an instance takes many steps, with barriers where the passes would be.

override STEPS: u32;

var<workgroup> goes_on: u32;

@compute @workgroup_size(WORKGROUP)
fn workgroup_dynamics(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let instance = group.y;
    for (var s = 0u; s < STEPS; s++) {
        if (local == 0u) {
            goes_on = u32(control[instance].stop == RUNNING && control[instance].step < control[instance].limit);
        }
        if (workgroupUniformLoad(&goes_on) == 0u) {
            break;
        }
        for (var c = local; c < CREASES; c += WORKGROUP) {
            fold_angle(instance, c);
        }
        storageBarrier();
        for (var f = local; f < FACES; f += WORKGROUP) {
            forces_of_triangle(instance, f);
        }
        if (local == 0u) {
            advance_clock(instance);
        }
        storageBarrier();
        if (control[instance].stop == RUNNING) {
            for (var n = local; n < NODES; n += WORKGROUP) {
                let node = instance * NODES + n;
                nodes[node] = stepped(instance, n, nodes[node], gathered(instance, n).xyz);
            }
        }
        storageBarrier();
    }
}
