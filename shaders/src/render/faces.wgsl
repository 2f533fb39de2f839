// The paper: flat triangles, lit on both sides alike, darker where other paper keeps light from them.

struct Corners {
    @builtin(position) position: vec4<f32>,
    // The paper's colour or its value's, in linear light, and the light that reaches it with nothing before it.
    @location(0) @interpolate(flat) paper: vec4<f32>,
    // Shares of the second and the third corner, and of the colour map.
    @location(1) shares: vec3<f32>,
    // Where the values of openness begin, into how many parts sides are cut, and which side is seen.
    @location(2) @interpolate(flat) lattice: vec3<u32>,
}

// How much light a flat piece of paper has, whose normal on the side that is seen this is.
fn lit(normal: vec3<f32>) -> f32 {
    let key = 0.5 + 0.5 * dot(normal, frame.light);
    let around = 0.5 + 0.5 * dot(normal, frame.up);
    return AMBIENT + KEY * key * key + SKY * around;
}

// How bright paper is that is lit so and open to so much of the light from all around.
fn brightness(lit: f32, open: f32) -> f32 {
    return 1.0 + (lit * (1.0 - SHADE * (1.0 - open)) - 1.0) * frame.shading;
}

// The value at a place of a triangle's lattice: `i` steps towards its second corner, `j` towards its third.
fn value(lattice: vec3<u32>, i: u32, j: u32) -> f32 {
    // For i = 0 the product is 0, whatever i - 1 becomes.
    let row = i * (lattice.y + 1u) - i * (i - 1u) / 2u;
    let sides = openness[lattice.x + row + j];
    return select(sides.x, sides.y, lattice.z == 1u);
}

// How open the place with these shares of the second and the third corner is.
fn open_at(lattice: vec3<u32>, shares: vec2<f32>) -> f32 {
    if (lattice.y == 0u) {
        return 1.0;
    }
    // A pixel's middle may lie beside a triangle that covers a part of it.
    let along = clamp(shares, vec2<f32>(0.0), vec2<f32>(1.0));
    let steps = along / max(along.x + along.y, 1.0) * f32(lattice.y);
    let i = min(u32(steps.x), lattice.y - 1u);
    let j = min(u32(steps.y), lattice.y - 1u - i);
    let part = steps - vec2<f32>(f32(i), f32(j));
    let sum = part.x + part.y;
    if (sum > 1.0 && i + j + 2u <= lattice.y) {
        return (1.0 - part.y) * value(lattice, i + 1u, j) + (1.0 - part.x) * value(lattice, i, j + 1u)
            + (sum - 1.0) * value(lattice, i + 1u, j + 1u);
    }
    let inner = part / max(sum, 1.0);
    return (1.0 - inner.x - inner.y) * value(lattice, i, j) + inner.x * value(lattice, i + 1u, j)
        + inner.y * value(lattice, i, j + 1u);
}

@vertex
fn face_corner(@builtin(vertex_index) index: u32) -> Corners {
    let number = index / 3u;
    let which = index % 3u;
    let face = triangles[number];
    var seen = array<Corner, 3>(corner(face.nodes.x), corner(face.nodes.y), corner(face.nodes.z));
    var out: Corners;
    if (behind_the_viewer(seen[0]) || behind_the_viewer(seen[1]) || behind_the_viewer(seen[2])) {
        out.position = nowhere();
        return out;
    }
    let front = doubled_area(seen[0].place, seen[1].place, seen[2].place) < 0.0;
    let p = positions[face.nodes.x].xyz;
    let across = cross(positions[face.nodes.y].xyz - p, positions[face.nodes.z].xyz - p);
    let normal = select(-across, across, front) / max(length(across), 1e-30);

    var paper = select(frame.back, frame.front, front);
    out.shares = vec3<f32>(f32(which == 1u), f32(which == 2u), 0.0);
    if (frame.mapped == NODES) {
        out.shares.z = shares[face.nodes[which]];
    } else if (frame.mapped == TRIANGLES) {
        paper = map_colour(shares[number]);
    }
    out.paper = vec4<f32>(paper, lit(normal));
    out.lattice = vec3<u32>(face.start, face.parts, u32(!front));
    out.position = in_tile(seen[which].place, seen[which].depth - face.lifts[which], seen[which].w);
    return out;
}

@fragment
fn face_colour(here: Corners) -> @location(0) vec4<f32> {
    var paper = here.paper.xyz;
    if (frame.mapped == NODES) {
        paper = map_colour(here.shares.z);
    }
    return vec4<f32>(paper * brightness(here.paper.w, open_at(here.lattice, here.shares.xy)), 1.0);
}
