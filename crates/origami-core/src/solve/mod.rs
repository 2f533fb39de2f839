//! Solvers: from a sheet at rest to the folded one.
//!
//! [`Relax`] gives the folded state, [`Dynamics`] the paper's motion. Both are deterministic: the same input gives the
//! same bits.
//!
//! A large sheet takes as many threads as rayon's global pool has, if that is faster, and the same bits come out. A fold
//! that is itself on a thread of a pool, as those of a batch are, takes that one alone.

pub mod dynamics;
mod ensemble;
mod failed;
pub mod fire;
pub mod guard;
mod motion;
#[cfg(feature = "newton")]
pub mod newton;
mod path;
mod perturb;
mod precision;
mod ramp;
pub mod relax;
pub mod row_sums;
mod session;
pub mod settle;
mod state;
mod sweep;
pub mod threads;
pub mod time_step;

pub use dynamics::{Dynamics, Integrator};
pub use ensemble::Instance;
pub use failed::Failed;
pub use guard::{Diverged, Quantity};
#[cfg(feature = "newton")]
pub use newton::Newton;
pub use path::{PathFailed, fold_path, frame_percents};
pub use precision::Precision;
pub use relax::{Relax, default_ramp};
pub use session::Session;
pub use state::State;
pub use sweep::{Point, Sweep};
pub use time_step::TimeStep;

use glam::DVec3;

use crate::model::{Inventory, Model};

/// A fold angle past this many degrees means that layers have gone through each other and the state is tangled.
pub const TANGLED_DEGREES: f64 = 200.0;

/// How many steps a solver takes before it gives up, unless told otherwise.
pub const DEFAULT_MAX_STEPS: u64 = 100_000;

/// Default tolerance: a distance from the equilibrium, in radii of the sheet.
pub const DEFAULT_TOLERANCE: f64 = 1e-4;

/// Force evaluations between two reports of progress.
const REPORT: u64 = 50;

/// What folds a model.
pub trait Solver: Send + Sync {
    /// Takes the sheet from `start` to `percent` of the pattern's fold angles. `observe` is told now and then how far
    /// it has come.
    ///
    /// # Errors
    /// [`Failed::Diverged`] where the state stops being finite or grows beyond any sense; [`Failed::Backend`] where what
    /// computes gives up, which the processor does not.
    fn fold(
        &self,
        model: &Model,
        start: &State,
        percent: f64,
        observe: &mut dyn FnMut(Progress),
    ) -> Result<Folded, Failed>;

    /// Folds `model` more than once: to one percentage after the other.
    fn session<'a>(&'a self, model: &'a Model) -> Box<dyn Session + 'a> {
        Box::new(session::Direct { solver: self, model })
    }

    /// Folds many sheets at once, each as [`Solver::fold`] would; the results come in the order of `instances`. On the
    /// processor one takes a thread. `observe` is told the place of an instance and how far it has come.
    fn fold_all(
        &self,
        instances: &[Instance<'_>],
        observe: &(dyn Fn(usize, Progress) + Sync),
    ) -> Vec<Result<Folded, Failed>> {
        ensemble::over_threads(self, instances, observe)
    }

    /// What the model holds and leaves out, and what of its own this solver adds or does without.
    fn inventory(&self, model: &Model) -> Inventory {
        model.inventory.clone()
    }
}

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
pub enum Stop {
    /// The state is within the tolerance of the equilibrium.
    Converged,
    /// The number of steps asked for has been run.
    StepsDone,
    /// The step limit came first.
    StepLimit,
}

/// A state that a solver arrived at, and how.
#[derive(Clone, Debug)]
pub struct Folded {
    /// The state.
    pub state: State,
    /// Percentage of the pattern's fold angles.
    pub percent: f64,
    /// Why it stopped.
    pub stop: Stop,
    /// Force evaluations, all attempts together.
    pub steps: u64,
    /// The time step at the end: model time for [`Dynamics`], in units of each node's own step for [`Relax`].
    pub time_step: f64,
    /// Largest force on a node, in the model's unit of force.
    pub residual: f64,
    /// Estimated distance of the farthest vertex from the equilibrium, in radii of the sheet; infinite where there is
    /// no estimate yet.
    pub distance: f64,
    /// Attempts made: 2 or 3 where the first ended tangled and the sheet was folded again in another way.
    pub attempts: u32,
}

impl Folded {
    /// Whether the state is within the tolerance of the equilibrium.
    #[must_use]
    pub fn converged(&self) -> bool {
        self.stop == Stop::Converged
    }
}

/// The largest force, in the model's unit of force.
fn largest(forces: &[DVec3]) -> f64 {
    forces.iter().map(|f| f.length()).fold(0.0, f64::max)
}
