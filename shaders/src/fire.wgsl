// FIRE on row-sum masses (Bitzek et al., Phys. Rev. Lett. 97, 170201, 2006): every node moves at its own local step.

override FIRE_RENEWAL: u32;
override LONGEST_STEP: f32;
override SHORTEST_STEP: f32;
override LONGER: f32;
override SHORTER: f32;
override MIXING: f32;
override LESS_MIXING: f32;
override PATIENCE: u32;

// Whether this evaluation renews the masses.
fn renews(instance: u32) -> bool {
    return control[instance].step % FIRE_RENEWAL == 0u;
}

// Stores the force on a node and, now and then, its mass, both from `sum`; returns the node's part of power, speed and pull.
fn reduce_node(instance: u32, n: u32, sum: vec4<f32>) -> vec4<f32> {
    let node = instance * NODES + n;
    if (renews(instance)) {
        nodes[node].mass = sum.w;
    }
    nodes[node].force = sum.xyz;
    return fire_sums(nodes[node]);
}

// A node's part of power, speed and pull.
fn fire_sums(node: Node) -> vec4<f32> {
    let power = dot(node.force, node.velocity);
    let speed = node.mass * dot(node.velocity, node.velocity);
    return vec4<f32>(power, speed, dot(node.force, node.force) / node.mass, 0.0);
}

// Decides, from the sums over all nodes, how they move; keeps count and leads the ramp.
fn update_fire(instance: u32, sums: vec4<f32>) {
    let power = sums.x;
    let speed = sums.y;
    let pull = sums.z;
    var step = control[instance].fire_step;
    var mixing = control[instance].mixing;
    let uphill = power < 0.0;
    if (uphill) {
        step = max(SHORTER * step, SHORTEST_STEP);
        mixing = MIXING;
        control[instance].downhill = 0u;
    } else {
        let downhill = control[instance].downhill + 1u;
        control[instance].downhill = downhill;
        if (downhill > PATIENCE) {
            step = min(LONGER * step, LONGEST_STEP);
            mixing *= LESS_MIXING;
        }
    }
    var turn = 0.0;
    if (pull > 0.0) {
        turn = mixing * sqrt(speed / pull);
    }
    control[instance].fire_step = step;
    control[instance].mixing = mixing;
    control[instance].keep = select(1.0 - mixing, 0.0, uphill);
    control[instance].towards_force = select(turn + step, step, uphill);
    control[instance].back = select(0.0, -0.5 * step, uphill);

    control[instance].step += 1u;
    // The ramp waits while a crease turns too fast.
    let waits = atomicExchange(&control[instance].too_fast, 0u);
    control[instance].ramp_waits = waits;
    control[instance].ramp_before = control[instance].ramp_step;
    // A soft sheet becomes as stiff as its material only where its masses are renewed.
    let arrives = control[instance].ramp_step + 1u == control[instance].ramp_length && softens(instance);
    if (waits == 0u && !(arrives && !renews(instance))) {
        control[instance].ramp_step = min(control[instance].ramp_step + 1u, control[instance].ramp_length);
    }
    atomicStore(&control[instance].distance_squared_max, 0u);
    atomicStore(&control[instance].move_squared_max, 0u);
}

// Where a node is to go, and how fast.
struct Aim {
    velocity: vec3<f32>,
    displacement: vec3<f32>,
}

// What was decided, for one node.
fn aimed(instance: u32, node: Node) -> Aim {
    let step = control[instance].fire_step;
    let force = node.force * (control[instance].towards_force / node.mass);
    let velocity = node.velocity * control[instance].keep + force;
    return Aim(velocity, velocity * step + node.velocity * control[instance].back);
}

// Node `n` after it has moved as was decided.
fn turned(instance: u32, n: u32, node: Node) -> Node {
    let aim = aimed(instance, node);
    var there = node;
    there.velocity = aim.velocity;
    let position = moved(instance, n, SplitVector(node.high, node.low), aim.displacement);
    there.high = position.high;
    there.low = position.low;
    return there;
}
