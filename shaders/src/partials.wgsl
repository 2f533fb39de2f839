// What the workgroups over the nodes hand to the one that adds it up.

@group(0) @binding(10) var<storage, read_write> partials: array<vec4<f32>>;
