//! Structural analysis: folded sheets as structures of bars and hinges that are held, loaded and followed through
//! snap-through.
//!
//! A [`Structure`] says what there is, in the caller's own units; [`Structure::of`] makes one of a sheet. [`Tangent`] is its
//! stiffness in one state, [`Trace`] the path of its states as the load grows.

mod adjoint;
mod check;
mod compliance;
mod configuration;
mod dof;
mod eigen;
mod elements;
mod equations;
mod equilibria;
pub mod job;
mod laws;
mod matrix;
mod modes;
mod pressure;
mod refused;
mod rows;
mod structure;
mod tangent;
mod trace;

pub use adjoint::Gradient;
pub use compliance::FirstOrder;
pub use configuration::Configuration;
pub use dof::{Axis, Dof};
pub use elements::Energies;
pub use equilibria::Equilibrium;
pub use laws::{BarLaw, HingeLaw, Response};
pub use modes::{Mode, ModeKind};
pub use refused::Refused;
pub use structure::{Bar, Corners, Hinge, HingeKind, Loads, Structure, Supports};
pub use tangent::{Inertia, Tangent};
pub use trace::{Control, Ended, Event, Onward, Path, Point, Start, Trace, Until};
