// Fifth pass: moves every node by its new velocity, and takes note where it leaves all bounds.

@compute @workgroup_size(WORKGROUP)
fn positions(@builtin(global_invocation_id) id: vec3<u32>) {
    let n = id.x;
    if (n >= NODES || control[0].stop != RUNNING) {
        return;
    }
    let velocity = next_velocities[n].xyz;
    let moved = settings.time_step * velocity;
    let displacement = motions[n].displacement + moved;
    motions[n] = Motion(displacement, velocity);
    let position = nodes[n].rest + displacement;
    if (beyond(dot(position, position), FARTHEST * FARTHEST) || beyond(dot(moved, moved), LONGEST_MOVE * LONGEST_MOVE)) {
        atomicMin(&control[0].bad_node, n);
    }
}
