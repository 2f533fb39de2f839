// An evaluation of a relaxation, a block each workgroup: the forces from the positions, and what FIRE needs of them.

@group(0) @binding(5) var<storage, read_write> slots: array<vec4<f32>>;

// The sum of `own` over the workgroup, in fixed order. It takes the place of the forces.
fn sum_over_block(local: u32, own: vec3<f32>) -> vec3<f32> {
    workgroupBarrier();
    put_force(0u, local, own);
    workgroupBarrier();
    for (var half = WORKGROUP / 2u; half > 0u; half /= 2u) {
        if (local < half) {
            put_force(0u, local, force_in(local) + force_in(local + half));
        }
        workgroupBarrier();
    }
    return force_in(0u);
}

@compute @workgroup_size(WORKGROUP)
fn block_relax(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let instance = group.y;
    if (!open_with_springs(instance, group.x, control[instance].step, local)) {
        return;
    }
    var own = vec4<f32>(0.0);
    for (var n = local; n < block.own; n += WORKGROUP) {
        let i = in_sheet(n);
        let force = felt(nodes[nodes_now + i].held, summed_force(n) + load_on(instance, i));
        var mass = 0.0;
        if (renews(instance)) {
            mass = slots[instance * NODES + i].w;
        }
        own += reduce_node(instance, i, vec4<f32>(force, mass));
    }
    let sum = sum_over_block(local, own.xyz);
    if (local == 0u) {
        partials[instance * SUMS + group.x] = vec4<f32>(sum, 0.0);
    }
}
