// Last pass of a relaxation: moves every node by the step that FIRE has decided on.

@compute @workgroup_size(WORKGROUP)
fn fire_move(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < NODES && control[id.y].stop == RUNNING) {
        let node = id.y * NODES + id.x;
        let there = turned(id.y, id.x, nodes[node]);
        nodes[node].high = there.high;
        nodes[node].low = there.low;
        nodes[node].velocity = there.velocity;
    }
}
