// Dead loads on the nodes.

@group(0) @binding(28) var<storage, read> loads: array<vec4<f32>>;

fn load_on(instance: u32, n: u32) -> vec3<f32> {
    return loads[instance * NODES + n].xyz;
}
