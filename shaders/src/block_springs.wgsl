// All springs of a block: the moments of its creases, then the forces of its triangles and loose beams.

fn springs_of_block(instance: u32, local: u32) {
    for (var c = local; c < block.creases; c += WORKGROUP) {
        fold_angle(instance, c);
    }
    workgroupBarrier();
    for (var f = local; f < block.faces; f += WORKGROUP) {
        forces_of_triangle(instance, f);
    }
    for (var l = local; l < block.loose; l += WORKGROUP) {
        let own = loose_at(l);
        let force = loose_force(instance, own);
        put_force(instance, own.slots[0], force);
        put_force(instance, own.slots[1], -force);
    }
    workgroupBarrier();
}
