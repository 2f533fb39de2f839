// Second pass: the fold angle of every crease (paper 2.3), valley positive.

@compute @workgroup_size(WORKGROUP)
fn fold_angles(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x >= CREASES) {
        return;
    }
    let c = creases[id.x];
    let along = difference(c.along, c.nodes[2], c.nodes[3]);
    let one = face_normals[c.triangle_one];
    let two = face_normals[c.triangle_two];
    if (too_thin(length(along), one.w, two.w)) {
        // It keeps its angle until it opens again.
        return;
    }
    let sine = dot(normalize(along), cross(two.xyz, one.xyz));
    let cosine = dot(one.xyz, two.xyz);
    springs[id.x].angle = unwrapped(angle_of(sine, cosine), springs[id.x].angle);
}
