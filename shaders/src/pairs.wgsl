// Contact: the pairs of a point and a triangle, or of two edges, that may touch, as the host has listed them. They are of one
// sheet, and no ensemble has them.

struct Pair {
    // The point and the corners, or the ends of both edges.
    nodes: vec4<u32>,
    // Where each of these finds what the pair does to it.
    slots: vec4<u32>,
    // How many of the nodes the first thing has: 1 of a point and a triangle, 2 of two edges.
    split: u32,
    // The distance at which it is closed.
    closed: f32,
    // The gap from which it pushes.
    width: f32,
    // Of two edges what `mollifier` wants.
    eased: f32,
}

@group(0) @binding(29) var<storage, read> pairs: array<Pair>;
// By pair: from the second thing to the first, of length 1; the gap.
@group(0) @binding(31) var<storage, read_write> nears: array<vec4<f32>>;

// Pairs in the list: each has four slots.
fn pair_count() -> u32 {
    return pair_rows[NODES] / 4u;
}
