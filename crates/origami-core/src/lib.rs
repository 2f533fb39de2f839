//! Bar-and-hinge origami simulation on the CPU, after Ghassaei, Demaine and Gershenfeld (2018): FOLD files, crease patterns,
//! springs, solvers and measures. Programs that want a GPU or pictures too depend on the facade `origami`, which re-exports
//! this crate.
//!
//! ```
//! use origami_core::{CreasePattern, Material, Model, Relax, Solver, fold::Document, measure::Strain};
//!
//! // A square with a vertex in the middle, to be folded in four: three valleys and a mountain.
//! let document = Document::from_slice(
//!     br#"{
//!         "vertices_coords": [[0,0], [1,0], [2,0], [2,1], [2,2], [1,2], [0,2], [0,1], [1,1]],
//!         "edges_vertices": [[0,1], [1,2], [2,3], [3,4], [4,5], [5,6], [6,7], [7,0], [8,1], [8,3], [8,5], [8,7]],
//!         "edges_assignment": ["B", "B", "B", "B", "B", "B", "B", "B", "V", "V", "M", "V"]
//!     }"#,
//! )?;
//! let pattern = CreasePattern::from_document(&document, document.pattern_frame()?)?;
//! assert_eq!(pattern.faces.len(), 4, "the file has no faces, they were found");
//!
//! let model = Model::new(&pattern, &Material::default())?;
//! let folded = Relax::default().fold_from_rest(&model, 100.0)?;
//! assert!(folded.converged());
//! assert!(Strain::of(&model, &folded.state.positions).beams.max < 1e-6, "it folds flat without being stretched");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Modules
//!
//! Data flows one way, from top to bottom; no step changes what an earlier one made.
//!
//! | module | what it holds |
//! |---|---|
//! | [`fold`] | FOLD documents as written |
//! | [`generate`] | patterns from parameters, |
//! | [`rigid`] | closed forms of rigid folding |
//! | [`flat`] | whether a pattern can lie flat, and the flat-folded sheet by reflection |
//! | [`pattern`] | [`CreasePattern`]: letters, fold angles and faces, with warnings of what was put right |
//! | [`mesh`] | the faces cut into triangles: topology without positions |
//! | [`model`] | [`Model`]: beams, creases and corner angles, scaled to radius 1, with a [`Material`] |
//! | [`forces`] | the formulas: energies, forces and second derivatives, one kind of spring a file |
//! | [`scene`] | [`Scene`]: target angles, supports, loads, forces of one's own |
//! | [`sequence`] | folding step by step: which creases fold when |
//! | [`solve`] | [`Simulation`], which can be stepped and steered; the drivers [`Relax`], [`Dynamics`] and `Newton`; many sheets at once |
//! | `analysis` | structures of bars and hinges: supports, loads, paths through snap-through (feature `analysis`) |
//! | [`contact`] | where paper goes through paper |
//! | [`layers`] | which layer lies on which where a sheet is folded flat |
//! | [`measure`] | strain, angle errors, distance between states, warnings of scenes that go wrong |
//! | [`export`] | FOLD, OBJ and STL |
//! | [`error`], [`ids`] | errors and warnings that name a place; typed indices |
//!
//! Lengths are in radii of the sheet, angles in radians, masses are 1. `docs/METHOD.md` in the repository has all formulas.
//!
//! # Features
//!
//! - `files` (default): reading from and writing to paths. Without it streams and slices are read and written.
//! - `parallel` (default): threads. Without it one thread does everything, and the same bits come out.
//! - `serde`: `Serialize` and `Deserialize` for settings, scenes, saved simulations, ids and vectors.
//! - `newton`: the solver `Newton`, which needs sparse factorisations.
//! - `analysis`: the module `analysis`, which needs them too.
//!
//! Without its default features the crate uses no thread, no file and no clock, and builds for `wasm32-unknown-unknown`.
#![forbid(unsafe_code)]

#[cfg(feature = "analysis")]
pub mod analysis;
pub mod contact;
pub mod csr;
pub mod error;
pub mod export;
pub mod flat;
pub mod fold;
pub mod forces;
pub mod generate;
pub mod ids;
mod kernel;
pub mod layers;
pub mod measure;
pub mod mesh;
pub mod model;
mod parallel;
pub mod pattern;
pub mod rigid;
pub mod scene;
pub mod sequence;
pub mod solve;
#[doc(hidden)]
pub mod twins;

pub use error::{Error, Warning};
/// The vector crate whose types stand in this one's interface.
pub use glam;
pub use model::{Material, Model};
pub use pattern::CreasePattern;
pub use scene::{Scene, Targets};
#[cfg(feature = "newton")]
pub use solve::Newton;
pub use solve::{Dynamics, Folded, Relax, Simulation, Solver, State};
