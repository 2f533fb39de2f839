// Third pass of dynamics: sums the forces on every node and moves it.

@compute @workgroup_size(WORKGROUP)
fn integrate(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < NODES && control[id.y].stop == RUNNING) {
        let node = id.y * NODES + id.x;
        nodes[node] = stepped(id.y, id.x, nodes[node], gathered(id.y, id.x).xyz);
    }
}
