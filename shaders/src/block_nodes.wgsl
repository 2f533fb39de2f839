// A block and the nodes of the sheet. A step of dynamics leaves the nodes in the other half of their buffer, since others may
// still read where they were: after an even number of steps they lie in the first, after an odd number in the second.

// Where the nodes of an instance lie after so many steps.
fn nodes_after(instance: u32, step: u32) -> u32 {
    let second = !RELAXING && (step & 1u) != 0u;
    return instance * NODES + select(0u, arrayLength(&nodes) / 2u, second);
}

var<private> nodes_now: u32;

fn velocity_at(instance: u32, n: u32) -> vec3<f32> {
    return nodes[nodes_now + in_sheet(n)].velocity;
}

// Reads the positions as they are after so many steps.
fn read_positions(instance: u32, step: u32, local: u32) {
    nodes_now = nodes_after(instance, step);
    for (var n = local; n < block.nodes; n += WORKGROUP) {
        put_position(n, position_of(nodes_now + in_sheet(n)));
    }
    workgroupBarrier();
}

var<workgroup> goes_on: u32;

// Whether the instance runs; if it does, block `b` is open with the forces of its springs, as the nodes are after so many steps.
fn open_with_springs(instance: u32, b: u32, step: u32, local: u32) -> bool {
    if (local == 0u) {
        goes_on = u32(control[instance].stop == RUNNING);
    }
    if (workgroupUniformLoad(&goes_on) == 0u) {
        return false;
    }
    open_block(b);
    read_positions(instance, step, local);
    springs_of_block(instance, local);
    return true;
}
