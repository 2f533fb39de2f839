// Third pass of a relaxation: forces on the nodes, and the sums that FIRE needs of them, a workgroup each.

@compute @workgroup_size(WORKGROUP)
fn reduce_forces(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_index) local: u32,
) {
    var own = vec4<f32>(0.0);
    if (id.x < NODES && control[id.y].stop == RUNNING) {
        own = reduce_node(id.y, id.x, gathered(id.y, id.x));
    }
    let sum = workgroup_sum(local, own);
    if (local == 0u) {
        partials[group.y * SUMS + group.x] = sum;
    }
}
