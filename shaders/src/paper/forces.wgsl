// Fourth pass: the forces on every node, and the velocity that they give it (paper 2.2 to 2.5), masses 1.

// Beams: k (l - l0) along them, and their damping.
fn beam_forces(n: u32) -> vec3<f32> {
    var sum = vec3<f32>(0.0);
    for (var i = nodes[n].beams.x; i < nodes[n].beams.y; i++) {
        let b = beam_ends[i];
        let moved = motions[b.other].displacement - motions[n].displacement;
        let along = b.rest + moved;
        let length = length(along);
        if (length > 0.0) {
            // l^2 - l0^2 over l + l0: no difference of nearly equal numbers.
            let longer = dot(2.0 * b.rest + moved, moved) / (length + b.rest_length);
            sum += along * (b.stiffness * longer / length);
        }
        sum += b.damping * (motions[b.other].velocity - motions[n].velocity);
    }
    return sum;
}

// How the fold angle changes as one of the crease's nodes moves; `one` and `two` are the normals over the heights.
fn gradient(place: u32, one: vec3<f32>, two: vec3<f32>, foot: vec2<f32>) -> vec3<f32> {
    switch (place) {
        case 0u: {
            return one;
        }
        case 1u: {
            return two;
        }
        case 2u: {
            return -(1.0 - foot.x) * one - (1.0 - foot.y) * two;
        }
        default: {
            return -foot.x * one - foot.y * two;
        }
    }
}

fn crease_forces(n: u32) -> vec3<f32> {
    var sum = vec3<f32>(0.0);
    for (var i = nodes[n].creases.x; i < nodes[n].creases.y; i++) {
        let role = roles[i];
        let s = springs[role.element];
        let one = face_normals[role.triangle_one].xyz * s.per_height.x;
        let two = face_normals[role.triangle_two].xyz * s.per_height.y;
        sum += s.stiffness * (s.target_angle - s.angle) * gradient(role.place, one, two, s.foot);
    }
    return sum;
}

// The angle at a corner less that at rest, by turning its cosine and sine back.
fn deviation(rest: vec2<f32>, doubled_area: f32, along: f32) -> f32 {
    return angle_of(doubled_area * rest.x - along * rest.y, along * rest.x + doubled_area * rest.y);
}

// Corner angles: both corners on a side pull along `normal x side / side^2`, one against the other.
fn corner_forces(n: u32) -> vec3<f32> {
    var sum = vec3<f32>(0.0);
    for (var i = nodes[n].corners.x; i < nodes[n].corners.y; i++) {
        let role = roles[i];
        let t = triangles[role.element];
        let normal = face_normals[role.element];
        if (normal.w == 0.0) {
            continue;
        }
        let ab = difference(t.sides[0], t.nodes[0], t.nodes[1]);
        let bc = difference(t.sides[1], t.nodes[1], t.nodes[2]);
        let ca = difference(t.sides[2], t.nodes[2], t.nodes[0]);
        let at_a = deviation(t.angles.xy, normal.w, -dot(ab, ca));
        let at_b = deviation(t.angles.zw, normal.w, -dot(ab, bc));
        let at_c = -(at_a + at_b);
        let along_ab = (at_b - at_a) / dot(ab, ab) * cross(normal.xyz, ab);
        let along_bc = (at_c - at_b) / dot(bc, bc) * cross(normal.xyz, bc);
        let along_ca = (at_a - at_c) / dot(ca, ca) * cross(normal.xyz, ca);
        var pulls = array<vec3<f32>, 3>(along_ab - along_ca, along_bc - along_ab, along_ca - along_bc);
        sum += k_face(0u) * pulls[role.place];
    }
    return sum;
}

@compute @workgroup_size(WORKGROUP)
fn forces(@builtin(global_invocation_id) id: vec3<u32>) {
    let n = id.x;
    if (n >= NODES) {
        return;
    }
    var force = vec3<f32>(0.0);
    if (nodes[n].fixed_in_place == 0u) {
        force = beam_forces(n) + crease_forces(n) + corner_forces(n);
    }
    // Neighbours still read the velocity before.
    next_velocities[n] = vec4<f32>(motions[n].velocity + settings.time_step * force, 0.0);
}
