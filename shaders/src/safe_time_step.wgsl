// The safe time step, per instance.

@compute @workgroup_size(1)
fn safe_time_step(@builtin(workgroup_id) id: vec3<u32>) {
    if (control[id.y].stop == RUNNING) {
        renew_time_step(id.y);
    }
}
