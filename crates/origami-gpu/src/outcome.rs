//! What a run came to, in the core's words.

use std::sync::Arc;

use glam::DVec3;
use origami_core::forces::{Forces, damping};
use origami_core::ids::NodeId;
use origami_core::model::Model;
use origami_core::scene::Refusal;
use origami_core::solve::{Diverged, Failed, Folded, Instance, Progress, State, Stop};

use crate::error::GpuError;
use crate::layout::{Control, NONE, Node, SETTLED, vector};
use crate::run::Ending;
use crate::variant::Scheme;

/// A device that gave up, with the last state that is known.
pub(crate) fn backend(error: GpuError, last: &State, step: u64) -> Failed {
    Failed::Backend { source: Arc::new(error), last_read: Box::new(last.clone()), last_read_step: step }
}

/// The targets of an instance, where a GPU can run its scene.
pub(crate) fn checked(instance: &Instance<'_>) -> Result<Vec<f64>, Refusal> {
    let Instance { model, scene, .. } = instance;
    scene.check(model)?;
    let unsupported = |what| Refusal::Unsupported { what, backend: "a GPU", expected: "the CPU for that scene" };
    if !scene.forces.is_empty() {
        return Err(unsupported("forces"));
    }
    if !scene.supports.is_empty() {
        return Err(unsupported("supports"));
    }
    if !scene.loads.is_empty() {
        return Err(unsupported("loads"));
    }
    scene.targets.of(model)
}

/// Instances of which one cannot be run: those that run together are refused together.
pub(crate) fn refused(instances: &[Instance<'_>], refusal: &Refusal) -> Vec<Result<Folded, Failed>> {
    instances.iter().map(|instance| Err(Failed::refused(refusal.clone(), &instance.start))).collect()
}

/// Where an instance begins: its start, with the nodes of supports where they are held.
pub(crate) fn placed(instance: &Instance<'_>) -> State {
    let mut state = instance.start.clone();
    instance.scene.place_supports(&mut state.positions);
    state
}

/// How far an instance has come.
pub(crate) fn progress(control: &Control) -> Progress {
    let ramp = match control.ramp_length {
        0 => 1.0,
        length => f64::from(control.ramp_step) / f64::from(length),
    };
    Progress { step: u64::from(control.step), ramp, distance: distance(control) }
}

fn distance(control: &Control) -> f64 {
    match f64::from(control.distance) {
        // The shaders write so where they have no estimate.
        none if none >= 1e30 => f64::INFINITY,
        distance => distance,
    }
}

/// What an instance came to. `steps_asked`: it was to run so many steps, and not to stop before.
pub(crate) fn folded(
    instance: &Instance<'_>,
    targets: Vec<f64>,
    steps_asked: bool,
    ending: &Ending,
    scheme: Scheme,
) -> Result<Folded, Failed> {
    let (model, scene, control) = (instance.model, &instance.scene, &ending.control);
    let time_step = f64::from(match scheme {
        Scheme::Relax => control.fire_step,
        Scheme::Dynamics { .. } => control.time_step,
    });
    let angles = ending.creases.iter().map(|c| f64::from(c.angle)).collect();
    let mut state = State {
        positions: ending.nodes.iter().map(Node::position).collect(),
        velocities: ending.nodes.iter().map(|n| vector(n.velocity)).collect(),
        fold_angles: angles,
        targets,
    };
    if control.bad_node != NONE {
        return Err(diverged(
            model,
            ending,
            &state,
            time_step,
            matches!(scheme, Scheme::Dynamics { verlet: true, .. }),
        )
        .into());
    }
    // Measured in double precision, at the state as it was read.
    let mut forces = Forces::in_scene(model, scene);
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
    Ok(Folded { state, targets, stop, steps, time_step, residual, distance, attempts: 1, reactions })
}

fn diverged(model: &Model, ending: &Ending, state: &State, time_step: f64, verlet: bool) -> Diverged {
    let control = &ending.control;
    let node = control.bad_node as usize;
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
