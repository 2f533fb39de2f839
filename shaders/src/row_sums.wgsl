// A bound on the stiffness that each node feels: with J the gradient of an element's length or angle at a node,
// `K_i = sum over elements e at i of k_e |J_ei| sum_j |J_ej|`. Every face writes its part beside the forces in its slots:
// its part of each beam (2k at both ends), the apex and half of the ends of each crease, its corner angles and its area.

// The lengths of a hinge's gradient at the apexes and the ends, in the order of `Hinge`.
fn hinge_gradient(s: HingeShape) -> vec4<f32> {
    let length = sqrt(s.along_squared);
    let one = s.normal_one * (length / s.squared_one);
    let two = s.normal_two * (length / s.squared_two);
    let foot_one = dot(s.to_one, s.along) / s.along_squared;
    let foot_two = dot(s.to_two, s.along) / s.along_squared;
    let at_end_two = one * foot_one + two * foot_two;
    let at_end_one = one + two - at_end_two;
    return vec4<f32>(
        sqrt(dot(one, one)),
        sqrt(dot(two, two)),
        sqrt(dot(at_end_one, at_end_one)),
        sqrt(dot(at_end_two, at_end_two)),
    );
}

// What the crease on a side adds at the side's start, its end and the corner opposite to it.
fn crease_sums(instance: u32, side: u32) -> vec3<f32> {
    let crease = side & CREASE;
    if (crease == CREASE) {
        return vec3<f32>(0.0);
    }
    let h = hinge_at(crease);
    let s = hinge_shape(instance, h);
    if (s.degenerate) {
        return vec3<f32>(0.0);
    }
    let gradient = hinge_gradient(s);
    let stiffness = crease_stiffness(instance, h) * (1.0 + more_stiffness(instance, crease));
    let sums = stiffness * (gradient.x + gradient.y + gradient.z + gradient.w) * gradient;
    // The face to the left runs from the first end to the second, that to the right the other way.
    if ((side & RIGHT) == 0u) {
        return vec3<f32>(0.5 * sums.z, 0.5 * sums.w, sums.x);
    }
    return vec3<f32>(0.5 * sums.w, 0.5 * sums.z, sums.y);
}

fn face_sums(instance: u32, f: u32) {
    let own = face_at(f);
    var sums: array<f32, 3>;
    for (var i = 0u; i < 3u; i++) {
        let next = (i + 1u) % 3u;
        let rest = rest_length(own.rest_high[i], own.rest_low[i]);
        let beam = part(own.sides[i]) * 2.0 * side_stiffness(instance, f, i, rest);
        let crease = crease_sums(instance, own.sides[i]);
        sums[i] += beam + crease.x;
        sums[next] += beam + crease.y;
        sums[(i + 2u) % 3u] += crease.z;
    }
    let t = triangle(instance, own);
    if (has_corners(f) && t.normal_squared > 0.0) {
        // The gradient of an angle at its corner's neighbours is as long as 1 / side.
        let inverse = 1.0 / sqrt(t.squares);
        let k = corner_share(instance) * k_face(instance);
        for (var i = 0u; i < 3u; i++) {
            let next = (i + 1u) % 3u;
            let before = (i + 2u) % 3u;
            let turn = t.sides[i] / t.squares[i] + t.sides[before] / t.squares[before];
            let own_gradient = sqrt(dot(turn, turn));
            let total = k * (own_gradient + inverse[i] + inverse[before]);
            sums[i] += total * own_gradient;
            sums[next] += total * inverse[i];
            sums[before] += total * inverse[before];
        }
    }
    // The gradient of twice the area at a corner is as long as the side opposite to it.
    let opposite = sqrt(t.squares.yzx);
    let curvature = area_spring(instance, f, own, sqrt(t.normal_squared)).y;
    let of_area = curvature * (opposite.x + opposite.y + opposite.z) * opposite;
    for (var i = 0u; i < 3u; i++) {
        put_row_sum(instance, own.slots[i], sums[i] + of_area[i]);
    }
}

@compute @workgroup_size(WORKGROUP)
fn row_sums(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < FACES && control[id.y].stop == RUNNING) {
        face_sums(id.y, id.x);
    }
}
