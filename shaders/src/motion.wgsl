// One step of a node through time (paper 2.5), masses 1.

// `v += dt F`, `x += dt v` with the new v.
fn euler(instance: u32, n: u32, node: Node, force: vec3<f32>) -> Node {
    let dt = control[instance].time_step;
    var next = node;
    next.velocity = node.velocity + dt * force;
    return at(next, moved(instance, n, SplitVector(node.high, node.low), dt * next.velocity));
}

// Velocity Verlet. The velocity that is stored, and that the damping acts on, is the one extrapolated by the acceleration
// before to the end of the step: so the error of the damping is of second order too.
fn verlet(instance: u32, n: u32, node: Node, force: vec3<f32>) -> Node {
    let dt = control[instance].time_step;
    let arrived = node.velocity + 0.5 * control[instance].previous_step * (force - node.force);
    let midway = arrived + 0.5 * dt * force;
    var next = node;
    next.velocity = midway + 0.5 * dt * force;
    next.force = force;
    return at(next, moved(instance, n, SplitVector(node.high, node.low), dt * midway));
}

// The same node elsewhere.
fn at(node: Node, position: SplitVector) -> Node {
    var there = node;
    there.high = position.high;
    there.low = position.low;
    return there;
}

// Node `n` after a step in which it feels `force`.
fn stepped(instance: u32, n: u32, node: Node, force: vec3<f32>) -> Node {
    if (VERLET) {
        return verlet(instance, n, node, force);
    }
    return euler(instance, n, node, force);
}
