// A small sheet as one block: its lists, velocities, fold angles and targets lie in the memory of the workgroup too, and each
// invocation has one of its nodes.

@group(0) @binding(25) var<storage, read> blocks: array<u32>;
@group(0) @binding(27) var<storage, read> targets: array<vec2<f32>>;

override STEPS: u32;
override CHECK_INTERVAL: u32;
override LIST_WORDS: u32;

var<workgroup> list: array<u32, LIST_WORDS>;
var<workgroup> velocities: array<f32, POSITION_WORDS>;
var<workgroup> angles_now: array<f32, MOMENTS>;
var<workgroup> targets_now: array<vec2<f32>, MOMENTS>;
// What the next step does: STOPS, or GOES with what else there is to be done.
var<workgroup> next: u32;

const STOPS: u32 = 0u;
const GOES: u32 = 1u;
const CHECKS: u32 = 2u;
const RENEWS: u32 = 4u;

var<private> mine: Node;

fn word(i: u32) -> u32 {
    return list[i];
}

fn velocity_at(instance: u32, n: u32) -> vec3<f32> {
    return vec3<f32>(velocities[3u * n], velocities[3u * n + 1u], velocities[3u * n + 2u]);
}

fn angle_before(instance: u32, c: u32) -> f32 {
    return angles_now[c];
}

fn target_angle(instance: u32, c: u32, share: f32) -> f32 {
    return targets_now[c].x * (1.0 - share) + targets_now[c].y * share;
}

fn put_angle(instance: u32, c: u32, angle: f32) {
    angles_now[c] = angle;
}

// Shows the others where the node of this invocation is now.
fn show_mine(local: u32) {
    if (local < NODES) {
        put_position(local, SplitVector(mine.high, mine.low));
        for (var i = 0u; i < 3u; i++) {
            velocities[3u * local + i] = mine.velocity[i];
        }
    }
    workgroupBarrier();
}

fn open_sheet(instance: u32, local: u32) {
    for (var i = local; i < LIST_WORDS; i += WORKGROUP) {
        list[i] = blocks[i];
    }
    for (var c = local; c < CREASES; c += WORKGROUP) {
        angles_now[c] = angles[instance * CREASES + c];
        targets_now[c] = targets[instance * CREASES + c];
    }
    if (local < NODES) {
        mine = nodes[instance * NODES + local];
    }
    workgroupBarrier();
    open_block(0u);
    show_mine(local);
}

fn close_sheet(instance: u32, local: u32) {
    for (var c = local; c < CREASES; c += WORKGROUP) {
        angles[instance * CREASES + c] = angles_now[c];
    }
    if (local < NODES) {
        nodes[instance * NODES + local] = mine;
    }
}

// The springs' forces, and the loads, on the node of this invocation.
fn force_on_mine(instance: u32, local: u32) -> vec3<f32> {
    springs_of_block(instance, local);
    if (local < NODES) {
        return felt(mine.held, summed_force(local) + load_on(instance, local));
    }
    return vec3<f32>(0.0);
}

// The row sum of the same node, once its force has been summed.
fn row_sum_of_mine(instance: u32, local: u32) -> f32 {
    row_sums_of_block(instance, local);
    if (local < NODES) {
        return summed_row(local);
    }
    return 0.0;
}

// The stopping rule, where the node of this invocation feels `force`.
fn check_sheet(instance: u32, local: u32, force: vec3<f32>) {
    var own = vec4<f32>(0.0);
    if (local < NODES && ramp_is_done(instance) && window_ends(instance)) {
        own = next_window(instance * NODES + local, mine, force);
    }
    let found = workgroup_maxima_and_sums(local, own);
    if (local == 0u && ramp_is_done(instance)) {
        decide_at_window(instance, found);
    }
    storageBarrier();
}

// What a running sheet does at its step of now, of which some are for renewal.
fn next_step(instance: u32, renews: bool) -> u32 {
    let step = control[instance].step;
    if (control[instance].stop != RUNNING || step >= control[instance].limit) {
        return STOPS;
    }
    return GOES | select(0u, CHECKS, step % CHECK_INTERVAL == 0u) | select(0u, RENEWS, renews);
}
