//! What a relaxation under contact has come to, wherever it ran: measured by the plain forces and those of contact.

use std::ops::ControlFlow;

use glam::DVec3;

use super::held_up::{farthest, is_held_up};
use super::largest::largest;
use super::relax::default_ramp;
use super::{Failed, Folded, Progress, Solver, State, Stop};
use crate::contact::{Contact, Layers, Pressing, pressing};
use crate::forces::Forces;
use crate::ids::CreaseId;
use crate::model::Model;
use crate::scene::{Held, Reaction, Scene};

/// Ramps for which it goes on at the final targets while contact holds it up.
const PATIENCE: u64 = 10;

/// What contact did on a way to a state.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Touch {
    /// The faces that press at the end, the hardest first.
    pub pressing: Vec<Pressing>,
    /// The share of the way to the targets, 0 to 1, at which a move was first shortened; `None`: nothing was ever in the way.
    pub first_limited: Option<f64>,
    /// Evaluations in which some move was shortened.
    pub limited: u64,
    /// The least gap at the end, in radii; infinite where nothing touches.
    pub least_gap: f64,
    /// The energy of all gaps at the end, in the model's unit.
    pub energy: f64,
    /// The crease that is farthest from the angle asked of it, and how far, in radians.
    pub farthest: Option<(CreaseId, f64)>,
    /// Most pairs that were listed at one time.
    pub most_pairs: usize,
}

/// A solver that keeps paper from going through paper, and tells what that did.
pub trait Touching: Solver {
    /// As [`Solver::fold`], and what contact did.
    ///
    /// # Errors
    /// As [`Solver::fold`]; [`Failed::Refused`] too where the sheet begins crossed or closed, and for settings that are no
    /// lengths or stiffnesses above 0.
    fn fold_touching(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Touch), Failed>;
}

/// Evaluations at the final targets for which a sheet goes on that contact holds up.
#[doc(hidden)]
#[must_use]
pub fn contact_patience(model: &Model) -> u64 {
    PATIENCE * u64::from(default_ramp(model))
}

/// Why a solver has made no more evaluations.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// The stopping rule is content.
    Settled,
    /// Contact has held it up for longer than [`contact_patience`].
    HeldUp,
    /// It has come to its limit. Whether its targets had arrived.
    Limit(bool),
    /// As many evaluations as were asked for.
    StepsDone,
    /// It was broken off.
    Cancelled,
}

/// Where a solver stands that computes contact in its own way.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct Came {
    /// All that has moved, with the targets that were asked for.
    pub state: State,
    pub ended: Ended,
    pub steps: u64,
    /// FIRE's step.
    pub time_step: f64,
    /// As [`Folded::distance`].
    pub distance: f64,
    /// As [`Touch::first_limited`], [`Touch::limited`] and [`Touch::most_pairs`].
    pub first_limited: Option<f64>,
    pub limited: u64,
    pub most_pairs: usize,
}

impl Came {
    /// The state, and what contact did, measured in double precision by the plain forces.
    #[must_use]
    pub fn measured(self, (model, scene): (&Model, &Scene), contact: Contact) -> (Folded, Touch) {
        let Self { mut state, ended, steps, time_step, distance, first_limited, limited, most_pairs } = self;
        let mut layers = Layers::new(&model.mesh, &model.rest, contact, false);
        layers.measure(&state.positions);
        let held_up = || is_held_up((model, scene), &layers, &state);
        let stop = match ended {
            Ended::HeldUp => Stop::Blocked,
            Ended::Settled if held_up() => Stop::Blocked,
            Ended::Settled => Stop::Converged,
            Ended::Limit(true) if held_up() => Stop::Blocked,
            Ended::Limit(_) => Stop::StepLimit,
            Ended::StepsDone => Stop::StepsDone,
            Ended::Cancelled => Stop::Cancelled,
        };
        state.velocities.fill(DVec3::ZERO);
        let counted = Touch { first_limited, limited, most_pairs, ..Touch::default() };
        let end = End { stop, steps, time_step, distance };
        folded((model, scene), (&Held::new(model, scene), &layers), (state, counted), end)
    }
}

/// How a solver has ended.
pub(super) struct End {
    pub(super) stop: Stop,
    pub(super) steps: u64,
    pub(super) time_step: f64,
    pub(super) distance: f64,
}

/// What came of a fold: a state, at which `layers` were last measured, and what contact does there beside what was `counted` on
/// the way.
pub(super) fn folded(
    (model, scene): (&Model, &Scene),
    (held, layers): (&Held, &Layers),
    (mut state, counted): (State, Touch),
    end: End,
) -> (Folded, Touch) {
    let touch = touched(model, layers, &state, counted);
    let (residual, reactions) = residual((model, scene), held, layers, &mut state);
    let End { stop, steps, time_step, distance } = end;
    let folded = Folded {
        targets: scene.targets.clone(),
        stop,
        steps,
        time_step,
        residual,
        distance,
        attempts: 1,
        factorisations: 0,
        saddles: 0,
        reactions,
        state,
    };
    (folded, touch)
}

/// `counted` on the way, and what contact does at the end, where `layers` were last measured.
pub(super) fn touched(model: &Model, layers: &Layers, state: &State, counted: Touch) -> Touch {
    Touch {
        pressing: pressing(&model.mesh, layers, &state.positions),
        least_gap: layers.least_gap(),
        energy: layers.energy(&state.positions),
        farthest: farthest(&state.fold_angles, &state.targets),
        ..counted
    }
}

/// The largest force of springs and contact, and what the supports do. The fold angles are measured anew.
pub(super) fn residual(
    (model, scene): (&Model, &Scene),
    held: &Held,
    layers: &Layers,
    state: &mut State,
) -> (f64, Vec<Reaction>) {
    let mut forces = Forces::holding(model, scene, held.clone());
    let mut all = forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles).to_vec();
    let (mut of_contact, mut sums) = (vec![DVec3::ZERO; all.len()], vec![0.0; all.len()]);
    layers.add(&state.positions, &mut of_contact, &mut sums);
    held.clear(&mut of_contact);
    all.iter_mut().zip(&of_contact).for_each(|(all, own)| *all += *own);
    (largest(&all), forces.reactions().to_vec())
}
