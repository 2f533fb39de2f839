// Under contact in the place of reduce_forces: forces of springs and layers on the nodes, with masses that follow the layers from one
// evaluation to the next, and the sums that FIRE needs of them, a workgroup each.

@compute @workgroup_size(WORKGROUP)
fn contact_reduce(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_index) local: u32,
) {
    var own = vec4<f32>(0.0);
    if (id.x < NODES && control[id.y].stop == RUNNING) {
        let node = id.y * NODES + id.x;
        let springs = gathered(id.y, id.x);
        let layers = pushed(id.y, id.x);
        if (renews(id.y)) {
            moves[node].springs = springs.w;
        }
        nodes[node].mass = moves[node].springs + layers.w;
        nodes[node].force = springs.xyz + layers.xyz;
        own = fire_sums(nodes[node]);
    }
    let sum = workgroup_sum(local, own);
    if (local == 0u) {
        partials[group.y * SUMS + group.x] = sum;
    }
}
