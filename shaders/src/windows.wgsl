// The stopping rule's memory: positions of the nodes, and forces on them, when the window began.

override WINDOWS: u32;
override SHARE: f32;
override SMALL_SHARE: f32;
override LEAST_CHECKS: u32;
override SHARE_OF_PAST: f32;

struct Before {
    high: vec3<i32>,
    unused: u32,
    low: vec3<f32>,
    unused_too: f32,
    force: vec3<f32>,
    unused_as_well: f32,
}

@group(0) @binding(11) var<storage, read_write> windows: array<Before>;

// Whether a window of the stopping rule ends at this check.
fn window_ends(instance: u32) -> bool {
    return control[instance].checks == control[instance].window_end;
}

// Whether the target angles have come to the end of the ramp: windows begin only then.
fn ramp_is_done(instance: u32) -> bool {
    return control[instance].ramp_step >= control[instance].ramp_length;
}

// Begins a window of a node that lies there and feels `force`; returns what the one before has seen: the square of the move,
// the least distance; force along the move, its change along the move.
fn next_window(at: u32, node: Node, force: vec3<f32>) -> vec4<f32> {
    let before = windows[at];
    let position = SplitVector(node.high, node.low);
    let way = vector(difference(SplitVector(before.high, before.low), position));
    windows[at] = Before(node.high, 0u, node.low, 0.0, force, 0.0);
    return vec4<f32>(dot(way, way), sqrt(dot(force, force)) * node.softness, dot(force, way), dot(force - before.force, way));
}
