// What all kernels share: sizes and settings as constants, and the control block.
//
// Every kernel works on all instances of an ensemble at once: `instance` is the second coordinate of its workgroup. One
// sheet is an ensemble of one.

// Sizes of one instance.
override NODES: u32;
override CREASES: u32;
override FACES: u32;
override LOOSE_BEAMS: u32;
override SLOTS: u32;
// Invocations of a workgroup, and how many workgroups the nodes of one instance fill.
override WORKGROUP: u32;
override GROUPS: u32;

// What this sheet and this solver need.
override RELAXING: bool;
override DAMPED: bool;
override VERLET: bool;
override FIXED: bool;

// Constants of the core, by the names that they have there.
override DEGENERATE: f32;
override HOLD: f32;
override FARTHEST: f32;
override LONGEST_MOVE: f32;

const NONE: u32 = 0xffffffffu;
// Why an instance stands still.
const RUNNING: u32 = 0u;
const SETTLED: u32 = 1u;
const DIVERGED: u32 = 2u;
const LIMITED: u32 = 3u;

struct Control {
    stop: u32,
    step: u32,
    limit: u32,
    bad_node: atomic<u32>,
    // The part of the ramp that the evaluation at hand is at, and that of the evaluation before.
    ramp_step: u32,
    ramp_before: u32,
    ramp_length: u32,
    // Whether a crease turns too fast, and whether the ramp waits because one did in the evaluation before.
    too_fast: atomic<u32>,
    ramp_waits: u32,
    // The stopping rule; time is counted in checks, one every CHECK_INTERVAL evaluations.
    checks: u32,
    window_end: u32,
    settled_windows: u32,
    // The last disturbance, and whether the present window began after it.
    disturbed_at: u32,
    window_is_sound: u32,
    stops_when_settled: u32,
    distance: f32,
    tolerance: f32,
    // FIRE.
    fire_step: f32,
    mixing: f32,
    downhill: u32,
    keep: f32,
    towards_force: f32,
    back: f32,
    // Dynamics.
    time_step: f32,
    previous_step: f32,
    next_step: f32,
    damping_sum: f32,
    stiffness_max: atomic<u32>,
    speed_squared_max: atomic<u32>,
    // How good the state is, and the step of the last good one.
    distance_squared_max: atomic<u32>,
    move_squared_max: atomic<u32>,
    checkpoint_step: u32,
    // Material, read where instances differ in it.
    ea: f32,
    k_fold: f32,
    k_facet: f32,
    k_face: f32,
    zeta: f32,
    // Stiffness against collapse, and how soft the sheet is on its way: the most rigid beam (0: as its material all the
    // way), the share of the corner angles' stiffness, what pulls a crease back.
    k_area: f32,
    soft_ea: f32,
    soft_corners: f32,
    wrong_side: f32,
}

@group(0) @binding(0) var<storage, read_write> control: array<Control>;

// Whether |x| > limit. Compared as bits, since a compiler may take NaN for impossible: its bits are the largest.
fn beyond(x: f32, limit: f32) -> bool {
    return (bitcast<u32>(x) & 0x7fffffffu) > bitcast<u32>(limit);
}
