// Second pass: the forces of beams, creases, corner angles and damping on the corners of every triangle.
//
// Two triangles share the beam on a side: each does half. A crease acts on a triangle along its normal N only: with the
// moment t, the side's length l and g = t / (l |N|^2), the corner opposite to it feels g l^2 N, each end -g N times the dot
// product at the other end (paper 2.3 with cotangents written out). The corner angles (2.4) on a side pull along N x side, and
// so does an area that is nearly lost, at the corner opposite to it. The forces of each triangle sum to zero.

// The moment of the crease on a side; 0 where there is none.
fn moment(instance: u32, side: u32) -> f32 {
    let crease = side & CREASE;
    if (crease == CREASE) {
        return 0.0;
    }
    return moment_at(instance, crease);
}

// Force of a side's beam (2.2) over its length: k (l - l0) / l, with l - l0 = (l^2 - l0^2) / (l + l0).
fn tension(stiffness: f32, length: f32, rest: f32, excess: f32) -> f32 {
    if (length == 0.0) {
        return 0.0;
    }
    return stiffness * excess / ((length + rest) * length);
}

fn forces_of_triangle(instance: u32, f: u32) {
    let own = face_at(f);
    let t = triangle(instance, own);
    let lengths = sqrt(t.squares);
    let doubled_area = sqrt(t.normal_squared);

    // Along each side: what pulls its first end; its second feels the opposite.
    let pulls = corner_pulls(instance, f, doubled_area, t.squares, t.dots);
    var along: array<vec3<f32>, 3>;
    for (var i = 0u; i < 3u; i++) {
        let rest = rest_length(own.rest_high[i], own.rest_low[i]);
        let stiffness = side_stiffness(instance, f, i, rest);
        let beam = part(own.sides[i]) * tension(stiffness, lengths[i], rest, t.excess[i]);
        along[i] = t.sides[i] * beam + cross(t.normal, t.sides[i]) * pulls[i];
        if (DAMPED && damps) {
            let end = own.nodes[(i + 1u) % 3u];
            let velocity_difference = velocity_at(instance, end) - velocity_at(instance, own.nodes[i]);
            // c = 2 zeta sqrt(k) (2.5), masses 1.
            along[i] += velocity_difference * (part(own.sides[i]) * 2.0 * zeta(instance) * sqrt(stiffness));
        }
    }

    // Along the normal: the creases.
    var g = vec3<f32>(0.0);
    for (var i = 0u; i < 3u; i++) {
        let m = moment(instance, own.sides[i]);
        // Where the triangle has collapsed, the moments are 0 and so are these.
        if (m != 0.0 && t.normal_squared > 0.0) {
            g[i] = m / (lengths[i] * t.normal_squared);
        }
    }
    let across = vec3<f32>(
        g.y * t.squares.y - g.x * t.dots.y - g.z * t.dots.z,
        g.z * t.squares.z - g.y * t.dots.z - g.x * t.dots.x,
        g.x * t.squares.x - g.z * t.dots.x - g.y * t.dots.y,
    );

    let squeezed = area_spring(instance, f, own, doubled_area).x;
    for (var i = 0u; i < 3u; i++) {
        let before = (i + 2u) % 3u;
        let of_area = cross(t.normal, t.sides[(i + 1u) % 3u]) * squeezed;
        put_force(instance, own.slots[i], along[i] - along[before] + across[i] * t.normal + of_area);
    }
}

override ADVANCES_CLOCK: bool;

@compute @workgroup_size(WORKGROUP)
fn triangle_forces(@builtin(global_invocation_id) id: vec3<u32>) {
    let running = control[id.y].stop == RUNNING;
    if (id.x < FACES && running) {
        forces_of_triangle(id.y, id.x);
    }
    if (ADVANCES_CLOCK && id.x == 0u && running) {
        advance_clock(id.y);
    }
}
