// A triangle of the sheet and its sides.

struct Face {
    nodes: array<u32, 3>,
    // Where the force on each corner is written.
    slots: array<u32, 3>,
    // The crease on each side, from corner i to the next, with flags; side i lies opposite to corner i + 2.
    sides: array<u32, 3>,
    // The squares of the rest lengths, in two parts: see `excess`.
    rest_high: array<i32, 3>,
    rest_low: array<f32, 3>,
}

// No other face has the side: its beam is this face's alone.
const ALONE: u32 = 0x80000000u;
// This face is the one to the right of its crease.
const RIGHT: u32 = 0x40000000u;
const CREASE: u32 = 0x3fffffffu;

// A side's part of its beam: half, where another face does the other half.
fn part(side: u32) -> f32 {
    return select(0.5, 1.0, (side & ALONE) != 0u);
}

struct Triangle {
    // Sides 0-1, 1-2 and 2-0.
    sides: array<vec3<f32>, 3>,
    squares: vec3<f32>,
    // By how much the squares exceed those at rest.
    excess: vec3<f32>,
    // At each corner, the product of its two sides.
    dots: vec3<f32>,
    // As long as twice the area.
    normal: vec3<f32>,
    normal_squared: f32,
}

fn triangle(instance: u32, f: Face) -> Triangle {
    let a = position_at(instance, f.nodes[0]);
    let b = position_at(instance, f.nodes[1]);
    let c = position_at(instance, f.nodes[2]);
    let d_ab = difference(a, b);
    let d_bc = difference(b, c);
    let d_ca = difference(c, a);
    let ab = vector(d_ab);
    let bc = vector(d_bc);
    let ca = vector(d_ca);
    var t: Triangle;
    t.sides = array<vec3<f32>, 3>(ab, bc, ca);
    t.squares = vec3<f32>(dot(ab, ab), dot(bc, bc), dot(ca, ca));
    t.excess = vec3<f32>(
        excess(d_ab, f.rest_high[0], f.rest_low[0]),
        excess(d_bc, f.rest_high[1], f.rest_low[1]),
        excess(d_ca, f.rest_high[2], f.rest_low[2]),
    );
    t.dots = -vec3<f32>(dot(ab, ca), dot(ab, bc), dot(bc, ca));
    t.normal = cross_product(d_ca, d_ab);
    t.normal_squared = dot(t.normal, t.normal);
    return t;
}
