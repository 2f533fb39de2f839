// A beam on an edge outside any triangle.

struct LooseBeam {
    nodes: array<u32, 2>,
    slots: array<u32, 2>,
    // As in `Face`.
    rest_high: i32,
    rest_low: f32,
    // 0 stands for the material's.
    rigidity: f32,
}

// k = EA / l0 (paper 2.2).
fn loose_stiffness(instance: u32, own: LooseBeam) -> f32 {
    let rigidity = rigidity_now(instance, select(ea(instance), own.rigidity, own.rigidity > 0.0));
    return rigidity / rest_length(own.rest_high, own.rest_low);
}

// The force on its first end; its second feels the opposite.
fn loose_force(instance: u32, own: LooseBeam) -> vec3<f32> {
    let displacement = difference(position_at(instance, own.nodes[0]), position_at(instance, own.nodes[1]));
    let along = vector(displacement);
    let length = sqrt(dot(along, along));
    let rest = rest_length(own.rest_high, own.rest_low);
    let k = loose_stiffness(instance, own);
    var force = vec3<f32>(0.0);
    if (length > 0.0) {
        let longer = excess(displacement, own.rest_high, own.rest_low);
        force = along * (k * longer / ((length + rest) * length));
    }
    if (DAMPED && damps) {
        let velocity_difference = velocity_at(instance, own.nodes[1]) - velocity_at(instance, own.nodes[0]);
        force += velocity_difference * (2.0 * zeta(instance) * sqrt(k));
    }
    return force;
}
