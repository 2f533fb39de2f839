// Keeps a copy of the state while it is good: what comes back where it diverges later.

override GOOD_POSITION: f32 = 5.0;
override GOOD_MOVE: f32 = 0.1;

@group(0) @binding(12) var<storage, read_write> kept_nodes: array<Node>;
@group(0) @binding(13) var<storage, read_write> kept_angles: array<f32>;

@compute @workgroup_size(WORKGROUP)
fn keep(@builtin(global_invocation_id) id: vec3<u32>) {
    let instance = id.y;
    let farthest = bitcast<f32>(atomicLoad(&control[instance].farthest));
    let fastest = bitcast<f32>(atomicLoad(&control[instance].fastest));
    let good = !beyond(farthest, GOOD_POSITION * GOOD_POSITION) && !beyond(fastest, GOOD_MOVE * GOOD_MOVE);
    if (control[instance].stop != RUNNING || !good) {
        return;
    }
    if (id.x < NODES) {
        kept_nodes[instance * NODES + id.x] = nodes[instance * NODES + id.x];
    }
    if (id.x < CREASES) {
        kept_angles[instance * CREASES + id.x] = crease_states[instance * CREASES + id.x].angle;
    }
    if (id.x == 0u) {
        control[instance].kept_step = control[instance].step;
    }
}
