//! What all solvers are: drivers that take a sheet from a state to the one that a scene asks for.

mod ensemble;
mod session;

pub use ensemble::Instance;
pub use session::Session;

use std::ops::ControlFlow;

use super::{Failed, State};
use crate::model::{Inventory, Model};
use crate::scene::{Reaction, Scene, Targets};
use ensemble::{collected, over_threads};
use session::Direct;

/// What folds a model.
pub trait Solver: Send + Sync {
    /// Takes the sheet from `start` to the targets of `scene`, under its supports, loads and forces. `observe` is told now
    /// and then how far it has come; where it breaks, the state at hand comes back with [`Stop::Cancelled`]. [`unwatched`]
    /// lets it go on.
    ///
    /// # Errors
    /// [`Failed::Refused`] before any work where the scene does not fit the model, or has a force that lacks what the solver
    /// needs; [`Failed::Diverged`] where the state stops being finite or grows beyond any sense; [`Failed::Backend`] where
    /// what computes gives up, which the CPU does not.
    fn fold(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed>;

    /// From the sheet at rest to `percent` of the pattern's fold angles.
    ///
    /// # Errors
    /// As [`Solver::fold`].
    fn fold_from_rest(&self, model: &Model, percent: f64) -> Result<Folded, Failed> {
        self.fold(model, &State::at_rest(model), &Scene::percent(percent), &mut unwatched)
    }

    /// Folds `model` more than once: from one state to the next. The sheet is perturbed at most once.
    fn session<'a>(&'a self, model: &'a Model) -> Box<dyn Session + 'a> {
        Box::new(Direct { solver: self, model })
    }

    /// Folds many sheets at once, each as [`Solver::fold`] would; the results come in the order of `instances`. On the
    /// processor one takes a thread. `observe` is told the place of an instance and how far it has come.
    fn fold_all(
        &self,
        instances: &[Instance<'_>],
        observe: &(dyn Fn(usize, Progress) -> ControlFlow<()> + Sync),
    ) -> Vec<Result<Folded, Failed>> {
        collected(self, instances, observe)
    }

    /// The same with each result handed to `take` as soon as there is one, with the place of its instance: the others still
    /// run. Each instance comes once, in whatever order; where `take` breaks, what has not begun is not begun, and what
    /// runs may not come.
    fn fold_each(
        &self,
        instances: &[Instance<'_>],
        observe: &(dyn Fn(usize, Progress) -> ControlFlow<()> + Sync),
        take: &(dyn Fn(usize, Result<Folded, Failed>) -> ControlFlow<()> + Sync),
    ) {
        over_threads(self, instances, observe, take);
    }

    /// What the model holds and leaves out, and what of its own this solver adds or does without.
    fn inventory(&self, model: &Model) -> Inventory {
        model.inventory.clone()
    }
}

/// Lets a solver go on, whatever it says.
pub fn unwatched(_: Progress) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// Force evaluations between two reports of progress.
pub(super) const REPORT: u64 = 50;

/// How far a solver has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Force evaluations so far, all attempts together.
    pub step: u64,
    /// The share of the way to the target angles at which the springs now pull, 0 to 1.
    pub ramp: f64,
    /// Estimated distance from the equilibrium in radii; infinite until there is an estimate.
    pub distance: f64,
}

/// Why a solver stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Stop {
    /// The state is within the tolerance of the equilibrium.
    Converged,
    /// The number of steps asked for has been run.
    StepsDone,
    /// The step limit came first.
    StepLimit,
    /// A triangle has been crushed to a line and stayed so ([`crushed_triangles`](super::crushed_triangles) names it): more
    /// steps would not bring the sheet to rest.
    Crushed,
    /// Layers press on each other, and keep creases from the angles asked of them: the sheet is at rest, or no longer comes nearer.
    Blocked,
    /// Who watched it broke it off: the state is the one at that moment.
    Cancelled,
}

/// A state that a solver arrived at, and how.
#[derive(Clone, Debug)]
pub struct Folded {
    /// The state.
    pub state: State,
    /// What was asked of the creases.
    pub targets: Targets,
    /// Why it stopped.
    pub stop: Stop,
    /// Force evaluations, all attempts together.
    pub steps: u64,
    /// The time step at the end: model time for [`Dynamics`](super::Dynamics), in units of each node's own step for [`Relax`](super::Relax).
    pub time_step: f64,
    /// Largest force on a node, in the model's unit of force.
    pub residual: f64,
    /// Estimated distance of the farthest vertex from the equilibrium, in radii of the sheet; infinite where there is
    /// no estimate yet.
    pub distance: f64,
    /// Attempts made: 2 or 3 where the first ended tangled, with a triangle crushed or out of bounds, and the sheet was
    /// folded again in another way.
    pub attempts: u32,
    /// Saddles that it had settled on and left: where forces vanish and the energy falls to both sides all the same.
    pub saddles: u32,
    /// Factorisations of the Hessian, all attempts together: of `Newton`, and where [`Relax`](super::Relax) handed over to its
    /// method.
    pub factorisations: u32,
    /// What the supports do to the held nodes, in the order of the nodes.
    pub reactions: Vec<Reaction>,
}

impl Folded {
    /// The percentage that was asked for, where it was one.
    #[must_use]
    pub fn percent(&self) -> Option<f64> {
        self.targets.label()
    }

    /// Whether the state is within the tolerance of the equilibrium.
    #[must_use]
    pub fn converged(&self) -> bool {
        self.stop == Stop::Converged
    }
}
