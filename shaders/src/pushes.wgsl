// Sums what pairs do to a node, in fixed order: force, and what is added to its mass.

@group(0) @binding(32) var<storage, read> pushes: array<vec4<f32>>;

fn pushed(instance: u32, n: u32) -> vec4<f32> {
    var sum = vec4<f32>(0.0);
    for (var s = pair_rows[n]; s < pair_rows[n + 1u]; s++) {
        sum += pushes[s];
    }
    return vec4<f32>(felt(nodes[instance * NODES + n].held, sum.xyz), sum.w);
}
