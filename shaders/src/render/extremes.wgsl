// The nodes that lie farthest in each of some directions: all that a camera needs to find its place. One workgroup a
// direction.

const WIDTH: u32 = 256u;

struct Search {
    // Of positions.
    count: u32,
}

@group(0) @binding(0) var<uniform> search: Search;
@group(0) @binding(1) var<storage, read> positions: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read> directions: array<vec4<f32>>;
// Positions, by direction.
@group(0) @binding(3) var<storage, read_write> extremes: array<vec4<f32>>;

struct Candidate {
    reach: f32,
    node: u32,
}

var<workgroup> candidates: array<Candidate, WIDTH>;

// Of nodes that lie equally far the first counts.
fn farther(a: Candidate, b: Candidate) -> Candidate {
    if (b.reach > a.reach || (b.reach == a.reach && b.node < a.node)) {
        return b;
    }
    return a;
}

@compute @workgroup_size(WIDTH)
fn find(@builtin(local_invocation_index) lane: u32, @builtin(workgroup_id) group: vec3<u32>) {
    let direction = directions[group.x].xyz;
    var best = Candidate(-3e38, 0u);
    for (var node = lane; node < search.count; node += WIDTH) {
        best = farther(best, Candidate(dot(positions[node].xyz, direction), node));
    }
    candidates[lane] = best;
    for (var half = WIDTH / 2u; half > 0u; half /= 2u) {
        workgroupBarrier();
        if (lane < half) {
            candidates[lane] = farther(candidates[lane], candidates[lane + half]);
        }
    }
    if (lane == 0u) {
        extremes[group.x] = positions[candidates[0].node];
    }
}
