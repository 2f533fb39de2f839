//! Bar-and-hinge origami simulation on the CPU.
//!
//! Data flows one way: [`fold`] document → [`pattern::CreasePattern`] → [`mesh::Mesh`] → [`model::Model`] →
//! [`solve`] → [`measure`] → [`export`]. [`generate`] makes patterns without a file.
//!
//! # Features
//! - `files` (default): reading from and writing to paths. Without it streams and slices are read and written.
//! - `parallel` (default): threads. Without it one thread does everything, and the same bits come out.
//! - `serde`: `Serialize` and `Deserialize` for settings, ids and vectors.
//! - `newton`: the solver `Newton`, which needs sparse factorisations.
//!
//! Without its default features the crate uses no thread, no file and no clock, and builds for `wasm32-unknown-unknown`.
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
pub mod solve;

pub use error::{Error, Warning};
/// The vector crate whose types stand in this one's interface.
pub use glam;
pub use model::{Material, Model};
pub use pattern::CreasePattern;
#[cfg(feature = "newton")]
pub use solve::Newton;
pub use solve::{Dynamics, Folded, Relax, Solver, State};
