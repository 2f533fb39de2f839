// The springs' forces on the nodes and the row sums of their stiffness, a block each workgroup: what the stopping rule, the
// masses of a relaxation and the safe time step are made of.

@group(0) @binding(5) var<storage, read_write> slots: array<vec4<f32>>;

@compute @workgroup_size(WORKGROUP)
fn block_forces(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let instance = group.y;
    if (!open_with_springs(instance, group.x, control[instance].step, local)) {
        return;
    }
    for (var n = local; n < block.own; n += WORKGROUP) {
        let node = in_sheet(n);
        let force = felt(nodes[nodes_now + node].held, summed_force(n) + load_on(instance, node));
        slots[instance * NODES + node] = vec4<f32>(force, 0.0);
    }
    row_sums_of_block(instance, local);
    for (var n = local; n < block.own; n += WORKGROUP) {
        slots[instance * NODES + in_sheet(n)].w = summed_row(n);
    }
}
