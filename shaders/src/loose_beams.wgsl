// Beams on edges outside any triangle: a pass that most sheets do not have.

struct LooseBeam {
    nodes: array<u32, 2>,
    slots: array<u32, 2>,
    // As in `Face`.
    rest_high: i32,
    rest_low: f32,
    // 0 stands for the material's.
    rigidity: f32,
}

@group(0) @binding(8) var<storage, read> loose_beams: array<LooseBeam>;

fn loose_beam(instance: u32, b: u32) {
    let own = loose_beams[b];
    let base = instance * NODES;
    let displacement = difference(position_of(base + own.nodes[0]), position_of(base + own.nodes[1]));
    let along = vector(displacement);
    let length = sqrt(dot(along, along));
    let rest = rest_length(own.rest_high, own.rest_low);
    let k = select(ea(instance), own.rigidity, own.rigidity > 0.0) / rest;
    var force = vec3<f32>(0.0);
    if (length > 0.0) {
        let longer = excess(displacement, own.rest_high, own.rest_low);
        force = along * (k * longer / ((length + rest) * length));
    }
    if (DAMPED) {
        let velocity_difference = nodes[base + own.nodes[1]].velocity - nodes[base + own.nodes[0]].velocity;
        force += velocity_difference * (2.0 * zeta(instance) * sqrt(k));
    }
    let first = instance * SLOTS;
    slots[first + own.slots[0]] = vec4<f32>(force, 2.0 * k);
    slots[first + own.slots[1]] = vec4<f32>(-force, 2.0 * k);
}

@compute @workgroup_size(WORKGROUP)
fn loose_beams_of_sheet(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < LOOSE_BEAMS && control[id.y].stop == RUNNING) {
        loose_beam(id.y, id.x);
    }
}
