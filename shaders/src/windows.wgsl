// The stopping rule's memory: positions of the nodes, and forces on them, when the window began.

override WINDOWS: u32;
override SHARE: f32;
override SMALL_SHARE: f32;
override LEAST_CHECKS: u32;
override SHARE_OF_PAST: f32;

struct Before {
    high: vec3<i32>,
    unused: u32,
    low: vec3<f32>,
    unused_too: f32,
    force: vec3<f32>,
    unused_as_well: f32,
}

@group(0) @binding(11) var<storage, read_write> windows: array<Before>;

// Whether a window of the stopping rule ends at this check.
fn window_ends(instance: u32) -> bool {
    return control[instance].checks == control[instance].window_end;
}

// Whether the target angles have come to the end of the ramp: windows begin only then.
fn ramp_is_done(instance: u32) -> bool {
    return control[instance].ramp_step >= control[instance].ramp_length;
}
