// Sums what lies in the slots of a node, in fixed order: the same bits in every run. Along the axes that hold it a node feels
// nothing. The last slot of a loaded node is its load, which no pass writes.

// The first slot of each node, and the end of the last.
@group(0) @binding(6) var<storage, read> rows: array<u32>;

fn gathered(instance: u32, n: u32) -> vec4<f32> {
    let first = instance * SLOTS;
    var sum = vec4<f32>(0.0);
    for (var s = rows[n]; s < rows[n + 1u]; s++) {
        sum += slots[first + s];
    }
    if (FIXED) {
        return vec4<f32>(felt(nodes[instance * NODES + n].held, sum.xyz), sum.w);
    }
    return sum;
}
