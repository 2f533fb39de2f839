// After an odd number of steps in blocks: copies the nodes to the half of their buffer where all others look for them.

@compute @workgroup_size(WORKGROUP)
fn bring_home(@builtin(global_invocation_id) id: vec3<u32>) {
    let home = id.y * NODES + id.x;
    if (id.x < NODES && (control[id.y].step & 1u) != 0u) {
        nodes[home] = nodes[home + arrayLength(&nodes) / 2u];
    }
}
