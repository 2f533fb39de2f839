//! Bar-and-hinge origami simulation on the CPU.
//!
//! Data flows one way: [`fold`] document → [`pattern::CreasePattern`] → [`mesh::Mesh`] → [`model::Model`] →
//! [`solve`] → [`measure`] → [`export`]. [`generate`] makes patterns without a file.
#![forbid(unsafe_code)]

pub mod csr;
pub mod error;
pub mod export;
pub mod fold;
pub mod forces;
pub mod generate;
pub mod ids;
mod kernel;
pub mod measure;
pub mod mesh;
pub mod model;
mod parallel;
pub mod pattern;
pub mod rigid;
pub mod scene;
pub mod solve;
#[doc(hidden)]
pub mod twins;

pub use error::{Error, Warning};
/// The vector crate whose types stand in this one's interface.
pub use glam;
pub use model::{Material, Model};
pub use pattern::CreasePattern;
#[cfg(feature = "newton")]
pub use solve::Newton;
pub use solve::{Dynamics, Folded, Relax, Solver, State};
