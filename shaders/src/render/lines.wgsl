// Lines of constant width, round at their ends, so that joints are round too.
//
// A line lies on paper, and would be half swallowed by it where the paper slopes. So each of its points takes the depth of
// its own faces there, a little nearer: just enough to win against them, and too little to win against a layer in front.

// All but `place` is the same over the whole line: what a fragment needs of the style is told too, since looking it up is
// slow where it is done for every sample.
struct Stroke {
    @builtin(position) position: vec4<f32>,
    // From the line's first end, in pixels: looked at in every sample, not only in the middle of the pixel.
    @location(0) @interpolate(linear, sample) place: vec2<f32>,
    // The way to its other end in pixels; one over its square, or 0; the square of half the line's width.
    @location(1) @interpolate(flat) way: vec4<f32>,
    // Depths at both ends, already as much nearer as lines are than paper; how much nearer still a face may bring it.
    @location(2) @interpolate(flat) ends: vec3<f32>,
    // Of both faces: depth at the first end, as much nearer; how it changes over a pixel to the right and down.
    @location(3) @interpolate(flat) one: vec3<f32>,
    @location(4) @interpolate(flat) two: vec3<f32>,
    @location(5) @interpolate(flat) colour: vec3<f32>,
    // Along the chain at both ends, in radii; whether there are dashes.
    @location(6) @interpolate(flat) along: vec3<f32>,
    @location(7) @interpolate(flat) kind: u32,
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
    let line = lines[index / 4u];
    let a = corner(line.nodes.x);
    let b = corner(line.nodes.y);
    var out: Stroke;
    if (behind_the_viewer(a) || behind_the_viewer(b)) {
        out.position = nowhere();
        return out;
    }
    let way = b.place - a.place;
    let square = dot(way, way);
    let style = frame.styles[line.kind];
    let half = style.half_width;
    out.way = vec4<f32>(way, select(0.0, 1.0 / square, square > 0.0), half * half);
    out.one = face_plane(line.triangles.x, a.place);
    out.two = face_plane(line.triangles.y, a.place);
    // The nearest of its faces at each end: layers are a part of their depths, not of the nodes'.
    let nearest = vec2<f32>(
        min(plane_depth(out.one, vec2<f32>()), plane_depth(out.two, vec2<f32>())),
        min(plane_depth(out.one, way), plane_depth(out.two, way)),
    );
    let own = vec2<f32>(a.depth, b.depth);
    let ends = max(min(nearest, own), own - frame.depth_of_radius) - style.bias;
    out.ends = vec3<f32>(ends, frame.steep * half * frame.depth_of_pixel);
    // Where no face is, the ends tell.
    let no_face = out.one.x == NO_FACE.x && out.two.x == NO_FACE.x;
    out.ends.z = select(out.ends.z, 0.0, no_face);
    out.one.x = select(out.one.x - style.bias, -NO_FACE.x, no_face);
    out.two.x -= style.bias;
    out.colour = style.colour;
    out.along = vec3<f32>(line.along, style.on);
    out.kind = line.kind;

    // A rectangle around it, with room for what the adapter's grid rounds away.
    let reach = half + 0.05;
    let forward = select(vec2<f32>(1.0, 0.0), way * inverseSqrt(square), square > 0.0);
    let sideways = vec2<f32>(-forward.y, forward.x);
    let end = select(-reach * forward, way + reach * forward, (index & 1u) == 1u);
    out.place = end + select(-reach, reach, (index & 2u) == 2u) * sideways;
    out.position = in_tile(a.place + out.place, 0.5, 1.0);
    return out;
}

// Whether a dash covers this place along the chain.
fn drawn(kind: u32, along: f32) -> bool {
    let style = frame.styles[kind];
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
    let share = clamp(dot(here.place, here.way.xy) * here.way.z, 0.0, 1.0);
    let off = here.place - share * here.way.xy;
    if (dot(off, off) > here.way.w) {
        discard;
    }
    if (here.along.z > 0.0) {
        if (!drawn(here.kind, mix(here.along.x, here.along.y, share))) {
            discard;
        }
    }
    let own = mix(here.ends.x, here.ends.y, share);
    let nearest = min(plane_depth(here.one, here.place), plane_depth(here.two, here.place));
    let depth = max(nearest, own - here.ends.z);
    return Sample(vec4<f32>(here.colour, 1.0), clamp(stored_depth(depth), 0.0, 1.0));
}
