// The parts of the row sums, once the forces have been summed.

fn row_sums_of_block(instance: u32, local: u32) {
    workgroupBarrier();
    for (var f = local; f < block.faces; f += WORKGROUP) {
        face_sums(instance, f);
    }
    for (var l = local; l < block.loose; l += WORKGROUP) {
        let own = loose_at(l);
        let sum = 2.0 * loose_stiffness(instance, own);
        put_row_sum(instance, own.slots[0], sum);
        put_row_sum(instance, own.slots[1], sum);
    }
    workgroupBarrier();
}
