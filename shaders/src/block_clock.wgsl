// Before each step of dynamics in blocks: one thread an instance keeps the time.

@compute @workgroup_size(1)
fn block_clock(@builtin(workgroup_id) id: vec3<u32>) {
    if (control[id.y].stop == RUNNING) {
        advance_clock(id.y);
    }
}
