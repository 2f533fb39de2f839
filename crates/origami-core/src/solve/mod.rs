//! Where a sheet is now, and how far it is to go.
//!
//! A [`Simulation`] is a sheet in motion: it can be stepped, steered and watched. Drivers go all the way at once: [`Relax`]
//! to the folded state, [`Dynamics`] along the paper's motion, `Newton` to the equilibrium itself, [`Reflect`] to the
//! flat-folded state without a way there. All are deterministic: the same input gives the same bits.
//!
//! A large sheet takes several threads, if that is faster, and the same bits come out: by default as many as rayon's pool
//! has, and one alone for a fold that is itself on a thread of a pool, as those of a batch are. `threads` of the settings
//! says otherwise.

#[doc(hidden)]
pub mod attempt;
mod backwards;
mod bare_kernel;
mod clock;
mod clusters;
mod contact_begin;
mod contact_dynamics;
mod contact_end;
mod contact_relax;
mod crushed;
mod driver;
pub mod dynamics;
mod engine;
mod failed;
mod fire;
mod guard;
mod held_up;
mod integrator;
mod largest;
#[cfg(feature = "newton")]
pub mod newton;
mod path;
mod perturb;
mod positions;
mod precision;
mod ramp;
mod reflect;
pub mod relax;
pub mod row_sums;
mod saddle;
mod saved;
mod sequence;
mod settle;
mod simulation;
mod sparse_hessian;
mod state;
mod stepper;
mod surroundings;
mod sweep;
mod threads;
pub mod time_step;

pub use backwards::{Backwards, Motion, NotBackwards};
#[doc(hidden)]
pub use bare_kernel::BareKernel;
pub use contact_dynamics::ContactDynamics;
#[doc(hidden)]
pub use contact_end::{Came, Ended, contact_patience};
pub use contact_end::{Touch, Touching};
pub use contact_relax::ContactRelax;
pub use crushed::{CRUSHED, crushed_triangles};
use driver::REPORT;
pub use driver::{Folded, Instance, Progress, Session, Solver, Stop, unwatched};
pub use dynamics::Dynamics;
pub use engine::{CpuEngine, Engine, Method, Report};
pub use failed::Failed;
pub use guard::{Diverged, Quantity};
pub use integrator::Integrator;
#[cfg(feature = "newton")]
pub use newton::{ContactNewton, Newton};
pub use path::{PathFailed, fold_path, fold_path_from, frame_percents};
pub use positions::{Positions, Units};
pub use precision::Precision;
pub use reflect::Reflect;
pub use relax::{Relax, default_ramp};
pub use saved::Saved;
pub use sequence::{Reached, SequenceFailed, Steps, fold_sequence};
pub use simulation::{Pin, Simulation};
pub use sparse_hessian::SparseHessian;
pub use state::State;
pub use sweep::{Point, Sweep};
#[doc(hidden)]
pub use threads::NODES_A_THREAD;
pub use time_step::TimeStep;

/// A fold angle past this many degrees means that layers have gone through each other and the state is tangled.
pub const TANGLED_DEGREES: f64 = 200.0;

/// How many steps a solver takes before it gives up, unless told otherwise.
pub const DEFAULT_MAX_STEPS: u64 = 100_000;

/// Default tolerance: a distance from the equilibrium, in radii of the sheet.
pub const DEFAULT_TOLERANCE: f64 = 1e-4;
