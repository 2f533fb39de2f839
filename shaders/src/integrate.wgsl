// Third pass of dynamics: sums the forces on every node and moves it (paper 2.5), masses 1.

// `v += dt F`, `x += dt v` with the new v.
fn euler(instance: u32, n: u32) {
    let node = instance * NODES + n;
    let dt = control[instance].time_step;
    let velocity = nodes[node].velocity + dt * gathered(instance, n).xyz;
    nodes[node].velocity = velocity;
    advance(instance, n, dt * velocity);
}

// Velocity Verlet. The velocity that is stored, and that the damping acts on, is the one extrapolated by the acceleration
// before to the end of the step: so the error of the damping is of second order too.
fn verlet(instance: u32, n: u32) {
    let node = instance * NODES + n;
    let dt = control[instance].time_step;
    let force = gathered(instance, n).xyz;
    let arrived = nodes[node].velocity + 0.5 * control[instance].previous_step * (force - nodes[node].force);
    let midway = arrived + 0.5 * dt * force;
    nodes[node].velocity = midway + 0.5 * dt * force;
    nodes[node].force = force;
    advance(instance, n, dt * midway);
}

fn integrate_node(instance: u32, n: u32) {
    if (VERLET) {
        verlet(instance, n);
    } else {
        euler(instance, n);
    }
}

@compute @workgroup_size(WORKGROUP)
fn integrate(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < NODES && control[id.y].stop == RUNNING) {
        integrate_node(id.y, id.x);
    }
}
