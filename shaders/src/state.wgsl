// The state of a sheet: what lies where, and positions finer than f32. It comes after control.wgsl.

// A position is high * QUANTUM + low. Differences are taken part by part, the high ones between integers: no compiler may
// reassociate those away, and two nodes that lie near each other keep all digits of what lies between them.
const QUANTUM: f32 = 0.000244140625;
const PER_QUANTUM: f32 = 4096.0;

struct Node {
    high: vec3<i32>,
    // The axes along which it is held: bit 0 for x, 1 for y, 2 for z.
    held: u32,
    low: vec3<f32>,
    mass: f32,
    velocity: vec3<f32>,
    softness: f32,
    // In a relaxation the force; in velocity Verlet the acceleration of the step before.
    force: vec3<f32>,
    unused: f32,
}

@group(0) @binding(1) var<storage, read_write> nodes: array<Node>;

// A position, or the difference of two, in two parts.
struct SplitVector {
    high: vec3<i32>,
    low: vec3<f32>,
}

fn position_of(node: u32) -> SplitVector {
    return SplitVector(nodes[node].high, nodes[node].low);
}

// From one position to another, in the same two parts.
fn difference(start: SplitVector, end: SplitVector) -> SplitVector {
    return SplitVector(end.high - start.high, end.low - start.low);
}

fn vector(split: SplitVector) -> vec3<f32> {
    return vec3<f32>(split.high) * QUANTUM + split.low;
}

// By how much the squared length of a difference exceeds that at rest, which is given as integer times QUANTUM^2 and a
// remainder. Forces come of this small difference of large squares: their high parts are subtracted as integers. (They hold
// up to 11 radii, five times the largest sheet.)
fn excess(apart: SplitVector, rest_high: i32, rest_low: f32) -> f32 {
    let square = apart.high * apart.high;
    let whole = square.x + square.y + square.z - rest_high;
    let mixed = 2.0 * QUANTUM * dot(vec3<f32>(apart.high), apart.low) + dot(apart.low, apart.low);
    return f32(whole) * (QUANTUM * QUANTUM) + (mixed - rest_low);
}

// The cross product: in a thin triangle it is such a difference too.
fn cross_product(a: SplitVector, b: SplitVector) -> vec3<f32> {
    let whole = a.high.yzx * b.high.zxy - a.high.zxy * b.high.yzx;
    let mixed = cross(vec3<f32>(a.high), b.low) + cross(a.low, vec3<f32>(b.high));
    return vec3<f32>(whole) * (QUANTUM * QUANTUM) + (mixed * QUANTUM + cross(a.low, b.low));
}

// The distance at rest.
fn rest_length(rest_high: i32, rest_low: f32) -> f32 {
    return sqrt(f32(rest_high) * (QUANTUM * QUANTUM) + rest_low);
}

// Whether the forces that are computed now have the damping in them, where there is any.
var<private> damps: bool = true;

// What of a force or a sum of forces a node feels: nothing along the axes that hold it.
fn felt(held: u32, force: vec3<f32>) -> vec3<f32> {
    if (FIXED) {
        return select(force, vec3<f32>(0.0), (vec3<u32>(held) & vec3<u32>(1u, 2u, 4u)) != vec3<u32>(0u));
    }
    return force;
}

// Where node `n` comes to from a position; takes note where it leaves all bounds.
fn moved(instance: u32, n: u32, from_here: SplitVector, displacement: vec3<f32>) -> SplitVector {
    let fine = from_here.low + displacement;
    let shift = round(fine * PER_QUANTUM);
    let there = SplitVector(from_here.high + vec3<i32>(shift), fine - shift * QUANTUM);
    let position = vector(there);
    let too_far = beyond(dot(position, position), FARTHEST * FARTHEST);
    if (too_far || beyond(dot(displacement, displacement), LONGEST_MOVE * LONGEST_MOVE)) {
        atomicMin(&control[instance].bad_node, n);
    }
    return there;
}
