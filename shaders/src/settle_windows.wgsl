// The stopping rule, per node: how far it moved in the window, and how its force changed. The springs' forces lie in the
// slots.

@compute @workgroup_size(WORKGROUP)
fn settle_windows(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_index) local: u32,
) {
    let instance = id.y;
    // The square of the move, the least distance; force along the move, its change along the move.
    var own = vec4<f32>(0.0);
    let checks_now = control[instance].stop == RUNNING && ramp_is_done(instance) && window_ends(instance);
    if (id.x < NODES && checks_now) {
        let node = instance * NODES + id.x;
        let force = gathered(instance, id.x).xyz;
        let before = windows[node];
        let moved = vector(difference(SplitVector(before.high, before.low), position_of(node)));
        own = vec4<f32>(
            dot(moved, moved),
            sqrt(dot(force, force)) * nodes[node].softness,
            dot(force, moved),
            dot(force - before.force, moved),
        );
        windows[node].high = nodes[node].high;
        windows[node].low = nodes[node].low;
        windows[node].force = force;
    }
    let both = workgroup_maxima_and_sums(local, own);
    if (local == 0u) {
        partials[group.y * GROUPS + group.x] = both;
    }
}
