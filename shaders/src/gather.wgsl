// Sums what lies in the slots of a node, in fixed order: the same bits in every run.

// The first slot of each node, and the end of the last.
@group(0) @binding(6) var<storage, read> rows: array<u32>;

fn gathered(instance: u32, n: u32) -> vec4<f32> {
    let first = instance * SLOTS;
    var sum = vec4<f32>(0.0);
    for (var s = rows[n]; s < rows[n + 1u]; s++) {
        sum += slots[first + s];
    }
    if (FIXED && nodes[instance * NODES + n].fixed_in_place != 0u) {
        return vec4<f32>(0.0, 0.0, 0.0, sum.w);
    }
    return sum;
}
