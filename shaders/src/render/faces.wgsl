// The paper: flat triangles, lit on both sides alike.

struct Corners {
    @builtin(position) position: vec4<f32>,
    // Linear light; under a map by node, what the map's colour is multiplied with.
    @location(0) @interpolate(flat) light: vec3<f32>,
    @location(1) share: f32,
}

// How bright a flat piece of paper is, whose normal on the side that is seen this is.
fn brightness(normal: vec3<f32>) -> f32 {
    let key = max(dot(normal, frame.light), 0.0);
    let around = 0.5 + 0.5 * dot(normal, frame.up);
    let lit = AMBIENT + KEY * key + SKY * around;
    return 1.0 + (lit - 1.0) * frame.shading;
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

    var light = select(frame.back, frame.front, front);
    if (frame.mapped == NODES) {
        light = vec3<f32>(1.0);
        out.share = shares[face.nodes[which]];
    } else if (frame.mapped == TRIANGLES) {
        light = map_colour(shares[number]);
    }
    out.light = light * brightness(normal);
    out.position = in_tile(seen[which].place, seen[which].depth - face.lifts[which], seen[which].w);
    return out;
}

@fragment
fn face_colour(here: Corners) -> @location(0) vec4<f32> {
    if (frame.mapped == NODES) {
        return vec4<f32>(map_colour(here.share) * here.light, 1.0);
    }
    return vec4<f32>(here.light, 1.0);
}
