// First pass: the normal of every triangle.

// One thread counts the steps, and stops the sheet after one that led out of bounds.
fn count_step() {
    if (atomicLoad(&control[0].bad_node) != NONE) {
        control[0].stop = DIVERGED;
    } else {
        control[0].step += 1u;
    }
}

@compute @workgroup_size(WORKGROUP)
fn normals(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x == 0u) {
        count_step();
    }
    if (id.x >= FACES) {
        return;
    }
    let t = triangles[id.x];
    let ab = difference(t.sides[0], t.nodes[0], t.nodes[1]);
    let ca = difference(t.sides[2], t.nodes[2], t.nodes[0]);
    let normal = cross(ca, ab);
    let doubled_area = length(normal);
    if (doubled_area > 0.0) {
        face_normals[id.x] = vec4<f32>(normal / doubled_area, doubled_area);
    } else {
        face_normals[id.x] = vec4<f32>(0.0);
    }
}
