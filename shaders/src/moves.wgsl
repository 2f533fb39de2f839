// Last pass of a relaxation: moves every node as was decided.

@compute @workgroup_size(WORKGROUP)
fn move_nodes(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < NODES && control[id.y].stop == RUNNING) {
        fire_step(id.y, id.x);
    }
}
