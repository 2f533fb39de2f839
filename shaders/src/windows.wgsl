// The stopping rule's memory: where the nodes were, and what pulled them, when its window began.

override WINDOWS: u32 = 5u;
override SHARE: f32 = 0.3;
override SMALL_SHARE: f32 = 0.03;
override LEAST_TICKS: u32 = 8u;
override SHARE_OF_PAST: f32 = 0.05;

struct Before {
    high: vec3<i32>,
    unused: u32,
    low: vec3<f32>,
    unused_too: f32,
    force: vec3<f32>,
    unused_as_well: f32,
}

@group(0) @binding(11) var<storage, read_write> windows: array<Before>;

// The ramp has come to its end, and a window with it or after it.
fn window_ends(instance: u32) -> bool {
    return control[instance].tick == control[instance].window_end;
}

fn ramp_is_done(instance: u32) -> bool {
    return control[instance].ramp_step >= control[instance].ramp_length;
}
