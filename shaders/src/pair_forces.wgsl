// Third pass under contact: the gap of each pair, how it pushes its four nodes, and what that adds to their masses.

// A curvature is bounded by that at this share of the gap.
override NEARER: f32;
// A gap below this share of the width pushes as that does.
const NEAREST: f32 = 1e-3;

@group(0) @binding(32) var<storage, read_write> pushes: array<vec4<f32>>;

fn pair_force(instance: u32, number: u32) {
    let pair = pairs[number];
    let p = position_at(instance, pair.nodes.x);
    let q = position_at(instance, pair.nodes.y);
    let r = position_at(instance, pair.nodes.z);
    let s = position_at(instance, pair.nodes.w);
    var nearest: Nearest;
    if (pair.split == 1u) {
        nearest = of_point_and_triangle(p, q, r, s);
    } else {
        nearest = of_edges(p, q, r, s);
    }
    let distance = sqrt(dot(nearest.apart, nearest.apart));
    let normal = nearest.apart / max(distance, 1e-30);
    let gap = distance - closed_at(pair);
    nears[number] = vec4<f32>(normal, gap);
    if (gap >= pair.width) {
        pushes[pair.slots.x] = vec4<f32>(0.0);
        pushes[pair.slots.y] = vec4<f32>(0.0);
        pushes[pair.slots.z] = vec4<f32>(0.0);
        pushes[pair.slots.w] = vec4<f32>(0.0);
        return;
    }
    let at = max(gap, NEAREST * pair.width);
    let push = barrier(at, pair.width);
    let curvature = barrier(NEARER * at, pair.width).curvature;
    var eased = Eased(1.0, vec3<f32>(0.0), vec3<f32>(0.0));
    if (pair.split == 2u) {
        let u = difference(p, q);
        let v = difference(r, s);
        eased = mollifier(vector(u), vector(v), cross_product(u, v), pair.eased);
    }
    let force = -eased.factor * push.slope * normal;
    let masses = 2.0 * eased.factor * curvature * abs(nearest.weights);
    let by_first = push.energy * eased.by_first;
    let by_second = push.energy * eased.by_second;
    pushes[pair.slots.x] = vec4<f32>(nearest.weights.x * force + by_first, masses.x);
    pushes[pair.slots.y] = vec4<f32>(nearest.weights.y * force - by_first, masses.y);
    pushes[pair.slots.z] = vec4<f32>(nearest.weights.z * force + by_second, masses.z);
    pushes[pair.slots.w] = vec4<f32>(nearest.weights.w * force - by_second, masses.w);
}

@compute @workgroup_size(WORKGROUP)
fn pair_forces(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < pair_count() && control[id.y].stop == RUNNING) {
        pair_force(id.y, id.x);
    }
}
