// First pass: the fold angle of every crease and the moment of its spring (paper 2.3).

fn fold_angle(instance: u32, c: u32) {
    let h = hinge_at(c);
    let s = hinge_shape(instance, h);
    if (s.degenerate) {
        // A degenerate crease keeps its angle and pulls at nothing until it opens again.
        put_moment(instance, c, 0.0);
        return;
    }
    let previous = angle_before(instance, c);
    // As good in thin triangles as in others, since the normals are.
    let y = dot(s.along, cross(s.normal_two, s.normal_one)) / sqrt(s.along_squared);
    let angle = unwrapped(angle_of(y, dot(s.normal_one, s.normal_two)), previous);
    if (RELAXING && abs(angle - previous) > HOLD) {
        atomicMax(&control[instance].too_fast, 1u);
    }
    put_angle(instance, c, angle);
    let target_now = target_angle(instance, c, ramp_share(instance));
    let back = wrong_side(instance, angle, target_now) * angle;
    put_moment(instance, c, crease_stiffness(instance, h) * (target_now - angle - back));
}

@compute @workgroup_size(WORKGROUP)
fn fold_angles(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < CREASES && control[id.y].stop == RUNNING) {
        fold_angle(id.y, id.x);
    }
}
