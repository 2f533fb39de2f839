// The largest row sum of an instance and the square of its largest velocity, for the safe time step.

@compute @workgroup_size(WORKGROUP)
fn stiffness_max(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < NODES && control[id.y].stop == RUNNING) {
        note_stiffness(id.y, gathered(id.y, id.x).w, nodes[id.y * NODES + id.x].velocity);
    }
}
