// The stopping rule, per instance: adds up what the nodes have seen, and decides. One workgroup an instance.

@compute @workgroup_size(WORKGROUP)
fn settle_decide(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let instance = group.y;
    var own = vec4<f32>(0.0);
    for (var i = local; i < GROUPS; i += WORKGROUP) {
        own = maxima_and_sums(own, partials[instance * GROUPS + i]);
    }
    let found = workgroup_maxima_and_sums(local, own);
    if (local == 0u && control[instance].stop == RUNNING && ramp_is_done(instance)) {
        decide_at_window(instance, found);
    }
}
