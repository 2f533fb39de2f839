// A step of dynamics, a block each workgroup: the forces from the positions, then the nodes after the step.

// The clock has gone on before: this step began where the ramp was then.
fn ramp_share(instance: u32) -> f32 {
    let length = control[instance].ramp_length;
    if (length == 0u) {
        return 1.0;
    }
    return f32(control[instance].ramp_before) / f32(length);
}

@compute @workgroup_size(WORKGROUP)
fn block_dynamics(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let instance = group.y;
    let step = control[instance].step;
    if (!open_with_springs(instance, group.x, step - 1u, local)) {
        return;
    }
    let there = nodes_after(instance, step);
    for (var n = local; n < block.own; n += WORKGROUP) {
        let i = in_sheet(n);
        let node = nodes[nodes_now + i];
        let force = felt(node.held, summed_force(n) + load_on(instance, i));
        nodes[there + i] = stepped(instance, i, node, force);
    }
}
