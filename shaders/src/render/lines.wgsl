// Lines of constant width, round at their ends, so that joints are round too.
//
// A line lies on paper, and would be half swallowed by it where the paper slopes. So each of its points takes the depth of
// its own faces there, a little nearer: just enough to win against them, and too little to win against a layer in front.

// All but `place` is the same over the whole line.
struct Stroke {
    @builtin(position) position: vec4<f32>,
    // From the line's first end, in pixels: looked at in every sample, not only in the middle of the pixel.
    @location(0) @interpolate(linear, sample) place: vec2<f32>,
    // The way to its other end in pixels; one over its square, or 0.
    @location(1) @interpolate(flat) way: vec3<f32>,
    // Depths at both ends.
    @location(2) @interpolate(flat) ends: vec2<f32>,
    // Of both faces: depth at the first end, and how it changes over a pixel to the right and down.
    @location(3) @interpolate(flat) one: vec3<f32>,
    @location(4) @interpolate(flat) two: vec3<f32>,
    // Along the chain at both ends, in radii.
    @location(5) @interpolate(flat) along: vec2<f32>,
    @location(6) @interpolate(flat) kind: u32,
}

// Farther than everything: a face that is not there.
const NO_FACE: vec3<f32> = vec3<f32>(1e9, 0.0, 0.0);

// The plane of a triangle's depths, as seen from a place.
fn face_plane(number: u32, place: vec2<f32>) -> vec3<f32> {
    if (number == NONE) {
        return NO_FACE;
    }
    let face = triangles[number];
    let a = corner(face.nodes.x);
    let b = corner(face.nodes.y);
    let c = corner(face.nodes.z);
    let area = doubled_area(a.place, b.place, c.place);
    if (behind_the_viewer(a) || behind_the_viewer(b) || behind_the_viewer(c) || area == 0.0) {
        return NO_FACE;
    }
    let depth = a.depth - face.lifts.x;
    let to_b = b.depth - face.lifts.y - depth;
    let to_c = c.depth - face.lifts.z - depth;
    let ab = b.place - a.place;
    let ac = c.place - a.place;
    let slope = vec2<f32>(to_b * ac.y - to_c * ab.y, to_c * ab.x - to_b * ac.x) / area;
    if (!(length(slope) < frame.edge_on * frame.depth_of_pixel)) {
        return NO_FACE;
    }
    return vec3<f32>(depth + dot(slope, place - a.place), slope);
}

fn plane_depth(plane: vec3<f32>, place: vec2<f32>) -> f32 {
    return plane.x + dot(plane.yz, place);
}

@vertex
fn line_corner(@builtin(vertex_index) index: u32) -> Stroke {
    let line = lines[index / 6u];
    let a = corner(line.nodes.x);
    let b = corner(line.nodes.y);
    var out: Stroke;
    if (behind_the_viewer(a) || behind_the_viewer(b)) {
        out.position = nowhere();
        return out;
    }
    let way = b.place - a.place;
    let square = dot(way, way);
    out.way = vec3<f32>(way, select(0.0, 1.0 / square, square > 0.0));
    out.one = face_plane(line.triangles.x, a.place);
    out.two = face_plane(line.triangles.y, a.place);
    // The nearest of its faces at each end: layers are a part of their depths, not of the nodes'.
    let nearest = vec2<f32>(
        min(plane_depth(out.one, vec2<f32>()), plane_depth(out.two, vec2<f32>())),
        min(plane_depth(out.one, way), plane_depth(out.two, way)),
    );
    let own = vec2<f32>(a.depth, b.depth);
    out.ends = max(min(nearest, own), own - frame.depth_of_radius);
    out.along = line.along;
    out.kind = line.kind;

    // A rectangle around it.
    let reach = frame.styles[line.kind].half_width + 1.0;
    let forward = select(vec2<f32>(1.0, 0.0), way * inverseSqrt(square), square > 0.0);
    let sideways = vec2<f32>(-forward.y, forward.x);
    let turn = array<u32, 6>(0u, 1u, 2u, 2u, 1u, 3u)[index % 6u];
    let end = select(-reach * forward, way + reach * forward, (turn & 1u) == 1u);
    out.place = end + select(-reach, reach, turn >= 2u) * sideways;
    out.position = in_tile(a.place + out.place, 0.5, 1.0);
    return out;
}

// Whether a dash covers this place along the chain.
fn drawn(style: Style, along: f32) -> bool {
    if (style.on == 0.0) {
        return true;
    }
    // A chain begins in the middle of a dash.
    let period = style.on + style.off;
    let place = along + 0.5 * style.on;
    let rest = place - floor(place / period) * period;
    return rest <= style.on || abs(rest - style.on - 0.5 * style.off) < 0.5 * style.dot_length;
}

struct Sample {
    @location(0) colour: vec4<f32>,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn line_colour(here: Stroke) -> Sample {
    let style = frame.styles[here.kind];
    let share = clamp(dot(here.place, here.way.xy) * here.way.z, 0.0, 1.0);
    let off = here.place - share * here.way.xy;
    if (dot(off, off) > style.half_width * style.half_width || !drawn(style, mix(here.along.x, here.along.y, share))) {
        discard;
    }
    let own = mix(here.ends.x, here.ends.y, share);
    var depth = min(plane_depth(here.one, here.place), plane_depth(here.two, here.place));
    if (here.one.x == NO_FACE.x && here.two.x == NO_FACE.x) {
        depth = own;
    }
    depth = max(depth, own - frame.steep * style.half_width * frame.depth_of_pixel) - style.bias;
    return Sample(vec4<f32>(style.colour, 1.0), clamp(stored_depth(depth), 0.0, 1.0));
}
