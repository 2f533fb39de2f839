//! What a run came to, in the core's words.

use std::sync::Arc;

use glam::DVec3;
use origami_core::forces::{Forces, damping};
use origami_core::ids::NodeId;
use origami_core::model::Model;
use origami_core::scene::{Held, Refusal};
use origami_core::solve::{Diverged, Failed, Folded, Instance, Progress, State, Stop};

use crate::error::{GPU, GpuError};
use crate::layout::{Control, CreaseState, NONE, Node, SETTLED, vector};
use crate::run::Ending;
use crate::single;
use crate::variant::Scheme;

/// A device that gave up, with the last state that is known.
pub(crate) fn backend(error: GpuError, last: &State, step: u64) -> Failed {
    Failed::Backend { source: Arc::new(error), last_read: Box::new(last.clone()), last_read_step: step }
}

/// The targets of an instance, where a GPU can run its scene.
pub(crate) fn checked(instance: &Instance<'_>) -> Result<Vec<f64>, Refusal> {
    let Instance { model, scene, start } = instance;
    scene.check(model)?;
    if !scene.forces.is_empty() {
        let expected = "the same solver on the CPU, or loads and supports in their place";
        return Err(Refusal::Unsupported { what: "forces", backend: GPU, expected });
    }
    let targets = scene.targets.of(model)?;
    single::check_model(model)?;
    single::check_scene(scene, &targets)?;
    single::check_start(start)?;
    Ok(targets)
}

/// Where an instance begins: its start, with the nodes of supports where they are held.
pub(crate) fn placed(instance: &Instance<'_>) -> State {
    let mut state = instance.start.clone();
    instance.scene.place_supports(&mut state.positions);
    state
}

/// How far an instance has come.
pub(crate) fn progress(control: &Control) -> Progress {
    Progress { step: u64::from(control.step), ramp: ramp_share(control), distance: distance(control) }
}

/// The share of the way to the target angles that the last evaluation was at.
pub(crate) fn ramp_share(control: &Control) -> f64 {
    match control.ramp_length {
        0 => 1.0,
        length => f64::from(control.ramp_before) / f64::from(length),
    }
}

/// The estimated distance from the equilibrium in radii; infinite where there is none.
pub(crate) fn distance(control: &Control) -> f64 {
    match f64::from(control.distance) {
        // The shaders write so where they have no estimate.
        none if none >= 1e30 => f64::INFINITY,
        distance => distance,
    }
}

/// The time step of the last move, or FIRE's step.
fn time_step(control: &Control, scheme: Scheme) -> f64 {
    f64::from(match scheme {
        Scheme::Relax => control.fire_step,
        Scheme::Dynamics { .. } => control.time_step,
    })
}

/// What lies in the buffers, in double precision.
pub(crate) fn state(nodes: &[Node], creases: &[CreaseState], targets: Vec<f64>) -> State {
    State {
        positions: nodes.iter().map(Node::position).collect(),
        velocities: nodes.iter().map(|n| vector(n.velocity)).collect(),
        fold_angles: creases.iter().map(|c| f64::from(c.angle)).collect(),
        targets,
    }
}

/// What an instance came to, with these nodes held. `steps_asked`: it was to run so many steps, and not to stop before.
pub(crate) fn folded(
    instance: &Instance<'_>,
    held: Held,
    targets: Vec<f64>,
    steps_asked: bool,
    ending: &Ending,
    scheme: Scheme,
) -> Result<Folded, Failed> {
    let (model, scene, control) = (instance.model, &instance.scene, &ending.control);
    if control.bad_node != NONE {
        return Err(diverged(model, ending, targets, scheme).into());
    }
    let time_step = time_step(control, scheme);
    let mut state = state(&ending.nodes, &ending.creases, targets);
    // Measured in double precision, at the state as it was read.
    let mut forces = Forces::holding(model, scene, held);
    let values = forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles);
    let residual = values.iter().map(|f| f.length()).fold(0.0, f64::max);
    let reactions = forces.reactions().to_vec();
    match scheme {
        Scheme::Relax => state.velocities.fill(DVec3::ZERO),
        Scheme::Dynamics { verlet, .. } if !verlet || control.step == 0 => {}
        Scheme::Dynamics { .. } => {
            // The velocity that was stored is the one extrapolated by the acceleration before.
            let held = forces.held().clone();
            let values = forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles);
            damping::add(model, &state.velocities, values);
            held.clear(values);
            for ((v, f), node) in state.velocities.iter_mut().zip(values).zip(&ending.nodes) {
                *v += (*f - vector(node.force)) * (0.5 * time_step);
            }
        }
    }
    let stop = match control.stop {
        SETTLED => Stop::Converged,
        _ if ending.cancelled => Stop::Cancelled,
        _ if steps_asked => Stop::StepsDone,
        _ => Stop::StepLimit,
    };
    let steps = u64::from(control.step);
    let (targets, distance) = (scene.targets.clone(), distance(control));
    Ok(Folded {
        state,
        targets,
        stop,
        steps,
        time_step,
        residual,
        distance,
        attempts: 1,
        saddles: 0,
        factorisations: 0,
        reactions,
    })
}

/// An instance of which a node left all bounds.
pub(crate) fn diverged(model: &Model, ending: &Ending, targets: Vec<f64>, scheme: Scheme) -> Diverged {
    let control = &ending.control;
    let node = control.bad_node as usize;
    let state = state(&ending.nodes, &ending.creases, targets);
    let (time_step, verlet) = (time_step(control, scheme), matches!(scheme, Scheme::Dynamics { verlet: true, .. }));
    let last_good = match &ending.checkpoint {
        Some((nodes, angles)) => State {
            positions: nodes.iter().map(Node::position).collect(),
            velocities: nodes.iter().map(|n| vector(n.velocity)).collect(),
            fold_angles: angles.iter().map(|a| f64::from(*a)).collect(),
            targets: state.targets.clone(),
        },
        None => State::at_rest(model),
    };
    // Velocity Verlet moves by the velocity in the middle of a step, and keeps the one at its end.
    let half_a_step = if verlet { vector(ending.nodes[node].force) * (0.5 * time_step) } else { DVec3::ZERO };
    let moved = (state.velocities[node] - half_a_step) * time_step;
    let place = (NodeId::new(node), state.positions[node], moved);
    Diverged::new(model, place, u64::from(control.step), Box::new(last_good), u64::from(control.checkpoint_step))
}
