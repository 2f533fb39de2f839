// What all kernels share: the scene as constants, what lies where, and positions finer than f32.
//
// Every kernel works on all instances of an ensemble at once: `instance` is the second coordinate of its workgroup. One
// sheet is an ensemble of one.

// Sizes of one instance.
override NODES: u32 = 1u;
override CREASES: u32 = 0u;
override FACES: u32 = 0u;
override LOOSE_BEAMS: u32 = 0u;
override SLOTS: u32 = 0u;
// Invocations of a workgroup, and how many workgroups the nodes of one instance fill.
override WORKGROUP: u32 = 64u;
override GROUPS: u32 = 1u;

// What this scene and this solver need.
override RELAXING: bool = false;
override DAMPED: bool = false;
override VERLET: bool = false;
override FIXED: bool = false;

// Constants of the core, by the names that they have there.
override DEGENERATE: f32 = 1e-6;
override HOLD: f32 = 0.1;
override FARTHEST: f32 = 100.0;
override LONGEST_MOVE: f32 = 1.0;

const NONE: u32 = 0xffffffffu;
// Why an instance stands still.
const RUNNING: u32 = 0u;
const SETTLED: u32 = 1u;
const DIVERGED: u32 = 2u;
const LIMITED: u32 = 3u;

// A position is high * QUANTUM + low. Differences are taken part by part, the high ones between integers: no compiler may
// reassociate those away, and two nodes that lie near each other keep all digits of what lies between them.
const QUANTUM: f32 = 0.000244140625;
const PER_QUANTUM: f32 = 4096.0;

struct Node {
    high: vec3<i32>,
    fixed_in_place: u32,
    low: vec3<f32>,
    mass: f32,
    velocity: vec3<f32>,
    softness: f32,
    // In a relaxation the force; in velocity Verlet the acceleration of the step before.
    force: vec3<f32>,
    unused: f32,
}

struct CreaseState {
    angle: f32,
    moment: f32,
    // The target angles between which the ramp leads.
    start: f32,
    goal: f32,
}

struct Control {
    stop: u32,
    step: u32,
    limit: u32,
    bad_node: atomic<u32>,
    ramp_step: u32,
    ramp_length: u32,
    held: atomic<u32>,
    // Settling, in ticks of the shortest window.
    tick: u32,
    window_end: u32,
    settled_windows: u32,
    stops_when_settled: u32,
    distance: f32,
    tolerance: f32,
    // FIRE.
    fire_step: f32,
    mixing: f32,
    downhill: u32,
    keep: f32,
    towards_force: f32,
    back: f32,
    // Dynamics.
    time_step: f32,
    previous_step: f32,
    next_step: f32,
    damping_sum: f32,
    stiffest: atomic<u32>,
    swiftest: atomic<u32>,
    // The last state that was good.
    farthest: atomic<u32>,
    fastest: atomic<u32>,
    kept_step: u32,
    // Material, read where instances differ in it.
    ea: f32,
    k_fold: f32,
    k_facet: f32,
    k_face: f32,
    zeta: f32,
}

@group(0) @binding(0) var<storage, read_write> control: array<Control>;
@group(0) @binding(1) var<storage, read_write> nodes: array<Node>;
@group(0) @binding(2) var<storage, read_write> crease_states: array<CreaseState>;
// Force on a node from one of its faces; the last is what that face adds to the node's row sum of the stiffness.
@group(0) @binding(5) var<storage, read_write> slots: array<vec4<f32>>;

struct Place {
    high: vec3<i32>,
    low: vec3<f32>,
}

fn place(node: u32) -> Place {
    return Place(nodes[node].high, nodes[node].low);
}

// From one place to another, in the same two parts.
fn between(start: Place, end: Place) -> Place {
    return Place(end.high - start.high, end.low - start.low);
}

fn vector(way: Place) -> vec3<f32> {
    return vec3<f32>(way.high) * QUANTUM + way.low;
}

// By how much the square of a way exceeds that at rest, which is given as integer times QUANTUM^2 and the rest. What makes
// forces is this small difference of large squares: their high parts are subtracted as integers. (They hold up to 11 radii,
// five times the largest sheet.)
fn excess(way: Place, rest_high: i32, rest_low: f32) -> f32 {
    let square = way.high * way.high;
    let whole = square.x + square.y + square.z - rest_high;
    let mixed = 2.0 * QUANTUM * dot(vec3<f32>(way.high), way.low) + dot(way.low, way.low);
    return f32(whole) * (QUANTUM * QUANTUM) + (mixed - rest_low);
}

// The cross product: in a thin triangle it is such a difference too.
fn cross_product(a: Place, b: Place) -> vec3<f32> {
    let whole = a.high.yzx * b.high.zxy - a.high.zxy * b.high.yzx;
    let mixed = cross(vec3<f32>(a.high), b.low) + cross(a.low, vec3<f32>(b.high));
    return vec3<f32>(whole) * (QUANTUM * QUANTUM) + (mixed * QUANTUM + cross(a.low, b.low));
}

// The distance at rest.
fn rest_length(rest_high: i32, rest_low: f32) -> f32 {
    return sqrt(f32(rest_high) * (QUANTUM * QUANTUM) + rest_low);
}

// The share of the way that the target angles have come.
fn ramp_share(instance: u32) -> f32 {
    let length = control[instance].ramp_length;
    if (length == 0u) {
        return 1.0;
    }
    return f32(control[instance].ramp_step) / f32(length);
}

// Whether |x| > limit. Compared as bits, since a compiler may take NaN for impossible: its bits are the largest.
fn beyond(x: f32, limit: f32) -> bool {
    return (bitcast<u32>(x) & 0x7fffffffu) > bitcast<u32>(limit);
}

// Moves a node, and takes note where it leaves all bounds.
fn advance(instance: u32, n: u32, way: vec3<f32>) {
    let node = instance * NODES + n;
    let fine = nodes[node].low + way;
    let shift = round(fine * PER_QUANTUM);
    let high = nodes[node].high + vec3<i32>(shift);
    let low = fine - shift * QUANTUM;
    nodes[node].high = high;
    nodes[node].low = low;
    let position = vec3<f32>(high) * QUANTUM + low;
    if (beyond(dot(position, position), FARTHEST * FARTHEST) || beyond(dot(way, way), LONGEST_MOVE * LONGEST_MOVE)) {
        atomicMin(&control[instance].bad_node, n);
    }
}
