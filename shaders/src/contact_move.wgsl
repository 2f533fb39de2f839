// Under contact in the place of fire_move: moves every node by the share of its move that all of its pairs allow.

@group(0) @binding(34) var<storage, read> shares: array<f32>;
// By node: its way since the pairs were listed.
@group(0) @binding(35) var<storage, read_write> ways: array<vec4<f32>>;

@compute @workgroup_size(WORKGROUP)
fn contact_move(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x >= NODES || control[id.y].stop != RUNNING) {
        return;
    }
    let node = id.y * NODES + id.x;
    var share = 1.0;
    for (var s = pair_rows[id.x]; s < pair_rows[id.x + 1u]; s++) {
        share = min(share, shares[s]);
    }
    let by = share * moves[node].by;
    let there = moved(id.y, id.x, position_of(node), by);
    nodes[node].high = there.high;
    nodes[node].low = there.low;
    if (share < 1.0) {
        nodes[node].velocity *= share;
        atomicMax(&touch[id.y].limited_now, 1u);
    }
    let way = ways[node].xyz + by;
    ways[node] = vec4<f32>(way, 0.0);
    let lasts = touch[id.y].lasts;
    if (beyond(dot(way, way), lasts * lasts)) {
        atomicMax(&touch[id.y].spent, 1u);
    }
}
