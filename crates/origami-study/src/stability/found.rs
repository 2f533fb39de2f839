//! What a case is given, and what is found of it.

use origami_core::scene::Scene;
use origami_core::solve::unwatched;
use origami_core::twins::safe_time_step::SAFE_SHARE;
use std::panic::{AssertUnwindSafe, catch_unwind};

use origami_core::solve::{Failed, Integrator, time_step};
use origami_core::{Folded, Model, Relax, Solver, State};

use super::cases::{Case, Size};
use super::limit::{Effort, largest};
use super::motion::Outcome;

/// How many steps, evaluations and trials a case is given.
#[derive(Clone, Copy, Debug)]
pub(super) struct Budget {
    /// Steps of each motion of a small sheet.
    pub(super) steps: u64,
    /// Steps of each motion of a large sheet.
    pub(super) steps_of_large: u64,
    /// Evaluations that a relaxation of a small sheet may take.
    pub(super) relaxation: u64,
    /// Evaluations that a relaxation of a large sheet may take: too few to arrive.
    pub(super) relaxation_of_large: u64,
    /// How hard the largest step that holds is sought on a small sheet.
    pub(super) effort: Effort,
    /// The same on a large sheet.
    pub(super) effort_of_large: Effort,
}

impl Budget {
    pub(super) fn new(quick: bool) -> Self {
        let small = Self {
            steps: 400,
            steps_of_large: 50,
            relaxation: 20_000,
            relaxation_of_large: 60,
            effort: Effort { half: 150, precision: 0.02 },
            effort_of_large: Effort { half: 25, precision: 0.1 },
        };
        let whole = Self { steps: 3000, relaxation: 100_000, effort: Effort { half: 400, precision: 0.005 }, ..small };
        if quick { small } else { whole }
    }

    /// Steps of a motion and evaluations of a relaxation.
    pub(super) fn of(self, size: Size) -> (u64, u64) {
        match size {
            Size::Small => (self.steps, self.relaxation),
            Size::Large => (self.steps_of_large, self.relaxation_of_large),
        }
    }
}

/// A bound and the largest step that was seen to hold, in units of model time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limit {
    pub(super) bound: f64,
    pub(super) largest: Option<f64>,
}

impl Limit {
    /// The bound as a share of the largest step that holds: at most 1 if it is one.
    pub(super) fn ratio(self) -> Option<f64> {
        self.largest.map(|largest| self.bound / largest)
    }

    pub(super) fn find(model: &Model, state: &State, integrator: Integrator, effort: Effort) -> Self {
        let bound = time_step::safe(model, &state.positions, integrator) / SAFE_SHARE;
        Self { bound, largest: largest(model, state, integrator, bound, effort) }
    }
}

/// Where a relaxation ended.
#[derive(Clone, Debug)]
pub(super) enum Relaxed {
    /// The solver returned a state.
    Ended {
        /// The state it ended in.
        folded: Box<Folded>,
        /// Largest distance of a node, in radii, from the equilibrium that Newton's method refines that state to, where one
        /// was found.
        distance: Option<f64>,
        /// How many saddles Newton's method left on its way to the equilibrium.
        saddles: Option<u32>,
    },
    /// The solver returned no state, or one that is not finite.
    Failed(Outcome),
}

impl Relaxed {
    pub(super) fn folded(&self) -> Option<&Folded> {
        match self {
            Self::Ended { folded, .. } => Some(folded),
            Self::Failed(_) => None,
        }
    }

    pub(super) fn converged(&self) -> bool {
        self.folded().is_some_and(Folded::converged)
    }

    /// Whether it said rightly that it is within the tolerance; `None` where it did not say so or nobody knows.
    pub(super) fn claim_is_true(&self) -> Option<bool> {
        match self {
            Self::Ended { distance: Some(distance), folded, .. } if folded.converged() => {
                Some(*distance <= Relax::default().tolerance)
            }
            _ => None,
        }
    }
}

/// What was found of a case in 64 bits.
#[derive(Clone, Debug)]
pub(super) struct Found {
    pub(super) model: Model,
    /// The paper's time step, in units of model time.
    pub(super) paper_step: f64,
    /// How the motion in the paper's steps ended.
    pub(super) paper: Outcome,
    /// How the motion in safe steps of Euler's scheme ended.
    pub(super) safe: Outcome,
    /// How the motion in safe steps of Verlet's scheme ended.
    pub(super) safe_verlet: Outcome,
    /// The state after the safe steps of Euler's scheme, where they held.
    pub(super) end: Option<State>,
    /// The limit of Euler's scheme about the flat sheet.
    pub(super) at_rest: Limit,
    /// The limit of Verlet's scheme about the flat sheet, if that is small.
    pub(super) verlet: Option<Limit>,
    /// The limit of Euler's scheme about the folded equilibrium, where that is known.
    pub(super) folded: Option<Limit>,
    /// Where the relaxation ended.
    pub(super) relaxed: Relaxed,
    /// The equilibrium that Newton's method refined the relaxed state to, where it found one.
    pub(super) equilibrium: Option<State>,
}

/// Relaxes the sheet from rest along the case's path; a target that jumps does so without a ramp.
pub(super) fn follow(
    case: &Case,
    model: &Model,
    budget: Budget,
    fold: impl Fn(&Relax) -> Box<dyn Solver>,
) -> Result<Folded, Failed> {
    let (_, max_steps) = budget.of(case.size);
    let ramp = (case.path.len() > 1).then_some(0);
    let solver = fold(&Relax { max_steps, ramp, ..Relax::default() });
    let mut folded = None;
    let mut state = State::at_rest(model);
    for percent in &case.path {
        let reached = solver.fold(model, &state, &Scene::percent(*percent), &mut unwatched)?;
        state.clone_from(&reached.state);
        folded = Some(reached);
    }
    Ok(folded.expect("every scene is sent somewhere"))
}

/// What `run` returns, or the text of its panic: a panic ends a row and not the study.
pub(super) fn unpanicked<T>(run: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(run)).map_err(|panic| {
        let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
        text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default()
    })
}
