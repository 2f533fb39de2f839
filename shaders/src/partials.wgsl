// What the workgroups hand to the one that adds it up.

// How many sums FIRE gets for an instance.
override SUMS: u32;

@group(0) @binding(10) var<storage, read_write> partials: array<vec4<f32>>;
