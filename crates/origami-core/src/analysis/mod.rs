//! Structural analysis: folded sheets as structures of bars and hinges that are held, loaded and followed through
//! snap-through.
//!
//! A [`Structure`] says what there is, in the caller's own units; [`Structure::of`] makes one of a sheet, [`job`] of a file. From
//! there:
//!
//! | what is asked | call |
//! |---|---|
//! | the path of its states as the load grows | [`Structure::trace`] |
//! | states without load, and barriers between them | [`Trace::equilibria`] |
//! | one state under a load | [`Structure::equilibrium`] |
//! | its answer to the first bit of load | [`Structure::first_order`] |
//! | at which load it buckles, by linear analysis | [`Structure::buckling`] |
//! | the moduli of a sheet that repeats itself | [`Structure::moduli`] |
//! | how it vibrates | [`Structure::modes`] |
//! | how a result changes with what it is made of | [`Structure::gradient`] |
//! | of what it must be made so that a result is as wanted | [`Structure::design`] |
//! | its stiffness in one state, factorised | [`Structure::tangent`] |

mod adjoint;
mod buckling;
mod check;
mod compliance;
mod configuration;
mod design;
mod dof;
mod eigen;
mod elements;
mod equations;
mod equilibria;
pub mod job;
mod laws;
mod matrix;
mod modes;
mod moduli;
mod pressure;
mod refused;
mod rows;
mod structure;
mod tangent;
mod trace;

pub use adjoint::Gradient;
pub use buckling::Buckling;
pub use compliance::FirstOrder;
pub use configuration::Configuration;
pub use design::{Designed, Effort, Goal, Judgement, Members, Progress, Variable, Watched};
pub use dof::{Axis, Dof};
pub use elements::Energies;
pub use equilibria::Equilibrium;
pub use laws::{BarLaw, HingeLaw, Response};
pub use modes::{Mode, ModeKind};
pub use moduli::Moduli;
pub use refused::Refused;
pub use structure::{Bar, Corners, Hinge, HingeKind, Loads, Structure, Supports};
pub use tangent::{Inertia, Tangent};
pub use trace::{Control, Ended, Event, Onward, Path, Point, Start, Trace, Until};
