// Under contact, after fire_update: the move of every node that FIRE has decided on, not farther than lists of pairs allow.

override CONTACT_LONGEST: f32;

@compute @workgroup_size(WORKGROUP)
fn contact_aim(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < NODES && control[id.y].stop == RUNNING) {
        let node = id.y * NODES + id.x;
        let aim = aimed(id.y, nodes[node]);
        let length = sqrt(dot(aim.displacement, aim.displacement));
        var share = 1.0;
        if (length > CONTACT_LONGEST) {
            share = CONTACT_LONGEST / length;
        }
        moves[node].by = share * aim.displacement;
        nodes[node].velocity = share * aim.velocity;
    }
}
