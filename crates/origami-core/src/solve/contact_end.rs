//! What a relaxation under contact has come to, wherever it ran: measured by the plain forces and those of contact.

use glam::DVec3;

use super::touch::{Touch, is_held_up, residual};
use super::{Folded, State, Stop};
use crate::contact::{Contact, Layers};
use crate::model::Model;
use crate::scene::{Held, Scene};

pub use super::touch::patience;

/// Why a solver has made no more evaluations.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// The stopping rule is content.
    Settled,
    /// Contact has held it up for longer than its [`patience`].
    HeldUp,
    /// It has come to its limit. Whether its targets had arrived, and whether a move was shortened lately.
    Limit(bool, bool),
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
        let counted = Touch { first_limited, limited, most_pairs, ..Touch::default() };
        let touch = counted.at_end(model, &layers, &state);
        let held_up = is_held_up(&layers, &state.fold_angles, &state.targets);
        let held = Held::new(model, scene);
        state.velocities.fill(DVec3::ZERO);
        let (residual, reactions) = residual((model, scene), &held, &layers, &mut state);
        let stop = match ended {
            Ended::Settled if !held_up => Stop::Converged,
            Ended::Settled | Ended::HeldUp => Stop::Blocked,
            Ended::Limit(true, lately) if lately || held_up => Stop::Blocked,
            Ended::Limit(..) => Stop::StepLimit,
            Ended::StepsDone => Stop::StepsDone,
            Ended::Cancelled => Stop::Cancelled,
        };
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
}
