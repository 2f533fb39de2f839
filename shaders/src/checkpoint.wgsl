// Copies the state while it is good: the copy is what comes back where the instance diverges later.

override GOOD_POSITION: f32;
override GOOD_MOVE: f32;

@group(0) @binding(12) var<storage, read_write> checkpoint_nodes: array<Node>;
@group(0) @binding(13) var<storage, read_write> checkpoint_angles: array<f32>;

@compute @workgroup_size(WORKGROUP)
fn checkpoint(@builtin(global_invocation_id) id: vec3<u32>) {
    let instance = id.y;
    let distance = bitcast<f32>(atomicLoad(&control[instance].distance_squared_max));
    let moved = bitcast<f32>(atomicLoad(&control[instance].move_squared_max));
    let good = !beyond(distance, GOOD_POSITION * GOOD_POSITION) && !beyond(moved, GOOD_MOVE * GOOD_MOVE);
    if (control[instance].stop != RUNNING || !good) {
        return;
    }
    if (id.x < NODES) {
        checkpoint_nodes[instance * NODES + id.x] = nodes[instance * NODES + id.x];
    }
    if (id.x < CREASES) {
        checkpoint_angles[instance * CREASES + id.x] = angle_of_crease(instance * CREASES + id.x);
    }
    if (id.x == 0u) {
        control[instance].checkpoint_step = control[instance].step;
    }
}
