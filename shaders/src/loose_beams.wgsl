// Beams on edges outside any triangle: a pass that most sheets do not have.

@group(0) @binding(8) var<storage, read> loose_beams: array<LooseBeam>;

@compute @workgroup_size(WORKGROUP)
fn loose_beams_of_sheet(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < LOOSE_BEAMS && control[id.y].stop == RUNNING) {
        let own = loose_beams[id.x];
        let force = loose_force(id.y, own);
        put_force(id.y, own.slots[0], force);
        put_force(id.y, own.slots[1], -force);
        let sum = 2.0 * loose_stiffness(id.y, own);
        put_row_sum(id.y, own.slots[0], sum);
        put_row_sum(id.y, own.slots[1], sum);
    }
}
