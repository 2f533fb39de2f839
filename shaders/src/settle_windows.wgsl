// The stopping rule, per node: how far it moved in the window, and how its force changed. The springs' forces lie in the
// slots.

@compute @workgroup_size(WORKGROUP)
fn settle_windows(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_index) local: u32,
) {
    let instance = id.y;
    var own = vec4<f32>(0.0);
    let checks_now = control[instance].stop == RUNNING && ramp_is_done(instance) && window_ends(instance);
    if (id.x < NODES && checks_now) {
        let node = instance * NODES + id.x;
        own = next_window(node, nodes[node], force_on(instance, id.x));
    }
    let both = workgroup_maxima_and_sums(local, own);
    if (local == 0u) {
        partials[group.y * GROUPS + group.x] = both;
    }
}
