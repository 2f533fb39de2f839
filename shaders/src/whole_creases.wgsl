// What the passes over all creases keep of each: by its index in the model.

struct CreaseState {
    angle: f32,
    moment: f32,
    // The target angles between which the ramp leads.
    start_target: f32,
    end_target: f32,
}

@group(0) @binding(2) var<storage, read_write> crease_states: array<CreaseState>;

fn angle_of_crease(crease: u32) -> f32 {
    return crease_states[crease].angle;
}

// The fold angle of the evaluation before.
fn angle_before(instance: u32, c: u32) -> f32 {
    return crease_states[instance * CREASES + c].angle;
}

fn target_angle(instance: u32, c: u32, share: f32) -> f32 {
    let crease = instance * CREASES + c;
    return crease_states[crease].start_target * (1.0 - share) + crease_states[crease].end_target * share;
}

fn put_angle(instance: u32, c: u32, angle: f32) {
    crease_states[instance * CREASES + c].angle = angle;
}

fn put_moment(instance: u32, c: u32, moment: f32) {
    crease_states[instance * CREASES + c].moment = moment;
}

fn moment_at(instance: u32, c: u32) -> f32 {
    return crease_states[instance * CREASES + c].moment;
}
