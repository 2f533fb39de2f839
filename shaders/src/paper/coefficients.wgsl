// Third pass: how the fold angle of every crease changes with its nodes (paper 2.3), but for the normals.

@compute @workgroup_size(WORKGROUP)
fn coefficients(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x >= CREASES) {
        return;
    }
    let c = creases[id.x];
    let along = difference(c.along, c.nodes[2], c.nodes[3]);
    let to_one = difference(c.to_one, c.nodes[2], c.nodes[0]);
    let to_two = difference(c.to_two, c.nodes[2], c.nodes[1]);
    let areas = vec2<f32>(face_normals[c.triangle_one].w, face_normals[c.triangle_two].w);
    if (too_thin(length(along), areas.x, areas.y)) {
        // It pulls at nothing until it opens again.
        springs[id.x].per_height = vec2<f32>(0.0);
        springs[id.x].foot = vec2<f32>(0.0);
        return;
    }
    springs[id.x].per_height = length(along) / areas;
    springs[id.x].foot = vec2<f32>(dot(to_one, along), dot(to_two, along)) / dot(along, along);
}
