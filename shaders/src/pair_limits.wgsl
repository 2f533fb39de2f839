// Under contact, before nodes move: the share of its move that each node of a pair may make. A plane divides the two things, and
// no node goes beyond its side (`limit.rs` of the core).
//
// How much lies between them is measured along the normal, corner by corner, so that the way is free however well the normal is
// known: two things with a slab between them do not touch, whichever way it is turned.

// The share of what lies between that one move may use up.
override USABLE: f32;
// A pair is looked at if its gap is below so many times what both of its things may move.
override WITHIN: f32;
// The share of a pair's width that is never used up; in f32 more than in f64.
const FLOOR: f32 = 2e-2;
// Of the pair's extent, what rounding may take from it: four units in the last place.
const ROUNDING: f32 = 4.0 * 1.1920929e-7;

@group(0) @binding(34) var<storage, read_write> shares: array<f32>;

fn most(x: vec4<f32>) -> f32 {
    return max(max(x.x, x.y), max(x.z, x.w));
}

// A number for each node of the first thing, or for each of the second; `other` in the place of the others.
fn of_first(first: vec4<bool>, own: vec4<f32>, other: f32) -> vec4<f32> {
    return select(vec4<f32>(other), own, first);
}

fn of_second(first: vec4<bool>, own: vec4<f32>, other: f32) -> vec4<f32> {
    return select(own, vec4<f32>(other), first);
}

// `places` along the normal and what the moves add to them, by node.
fn allowed(pair: Pair, first: vec4<bool>, places: vec4<f32>, moved: vec4<f32>, extent: f32) -> vec4<f32> {
    let lowest = -most(of_first(first, -places, -1e30));
    let highest = most(of_second(first, places, -1e30));
    // How far each is behind the front of its thing, and how far it would come forward.
    let room = select(highest - places, places - lowest, first);
    let advance = select(moved, -moved, first);
    let beyond_front = max(advance - room, vec4<f32>(0.0));
    let one = most(of_first(first, beyond_front, 0.0));
    let other = most(of_second(first, beyond_front, 0.0));
    let all = one + other;
    if (all <= 0.0) {
        return vec4<f32>(1.0);
    }
    let between = lowest - highest - closed_at(pair) - FLOOR * pair.width - ROUNDING * extent;
    let usable = USABLE * max(between, 0.0);
    let reach = room + usable * select(vec4<f32>(other / all), vec4<f32>(one / all), first);
    return select(vec4<f32>(1.0), max(reach / advance, vec4<f32>(0.0)), advance > reach);
}

fn pair_limit(instance: u32, number: u32) {
    let pair = pairs[number];
    let near = nears[number];
    let first = instance * NODES;
    let p = moves[first + pair.nodes.x].by;
    let q = moves[first + pair.nodes.y].by;
    let r = moves[first + pair.nodes.z].by;
    let s = moves[first + pair.nodes.w].by;
    let lengths = sqrt(vec4<f32>(dot(p, p), dot(q, q), dot(r, r), dot(s, s)));
    let is_first = vec4<bool>(true, pair.split == 2u, false, false);
    let longest = most(of_first(is_first, lengths, 0.0)) + most(of_second(is_first, lengths, 0.0));
    var own = vec4<f32>(1.0);
    if (near.w < WITHIN * longest) {
        let start = position_at(instance, pair.nodes.x);
        let to_q = vector(difference(start, position_at(instance, pair.nodes.y)));
        let to_r = vector(difference(start, position_at(instance, pair.nodes.z)));
        let to_s = vector(difference(start, position_at(instance, pair.nodes.w)));
        let normal = near.xyz;
        let places = vec4<f32>(0.0, dot(to_q, normal), dot(to_r, normal), dot(to_s, normal));
        let moved = vec4<f32>(dot(p, normal), dot(q, normal), dot(r, normal), dot(s, normal));
        let extent = sqrt(max(dot(to_q, to_q), max(dot(to_r, to_r), dot(to_s, to_s))));
        own = allowed(pair, is_first, places, moved, extent);
    }
    shares[pair.slots.x] = own.x;
    shares[pair.slots.y] = own.y;
    shares[pair.slots.z] = own.z;
    shares[pair.slots.w] = own.w;
}

@compute @workgroup_size(WORKGROUP)
fn pair_limits(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < pair_count() && control[id.y].stop == RUNNING) {
        pair_limit(id.y, id.x);
    }
}
