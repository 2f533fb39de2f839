//! Folds origami crease patterns by the bar-and-hinge method of Ghassaei, Demaine and Gershenfeld (2018), with an error
//! estimate on every result.
//!
//! A sheet is a mesh of triangles: their sides are *beams* that resist stretching, the sides between two triangles are
//! *creases* with a spring towards a target angle, and the corners of triangles resist shear. The folded sheet is an
//! equilibrium of these springs.
//!
//! ```
//! use origami::{CreasePattern, Material, Model, Relax, Solver, fold::Document, measure::Strain};
//!
//! let document = Document::read("examples/patterns/bird-base.fold")?;
//! let pattern = CreasePattern::from_document(&document, document.pattern_frame()?)?;
//! let model = Model::new(&pattern, &Material::default())?;
//! let folded = Relax::default().fold_from_rest(&model, 90.0)?;
//! assert!(folded.converged() && folded.distance < 1e-4);
//! let strain = Strain::of(&model, &folded.state.positions).beams;
//! assert!(strain.max < 0.002, "the longest and the shortest beam are within 0.2 % of their lengths at rest");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Without a file, [`generate`] makes patterns from parameters. `examples/embed.rs` goes from file to file.
//!
//! # From a file to numbers
//!
//! Data flows one way:
//!
//! | step | what it is |
//! |---|---|
//! | [`fold::Document`] | a FOLD file as written |
//! | [`CreasePattern`] | what it means: letters, fold angles, faces; its [`warnings`](CreasePattern::warnings) tell what was put right |
//! | [`Model`] | the triangulated sheet with its springs, made of a pattern and a [`Material`] |
//! | [`Scene`] | what is asked of it and done to it: target angles, supports, loads, forces of one's own |
//! | [`Simulation`] | where it is now: it can be stepped, steered, watched and saved |
//! | [`Solver`] | how far it goes: [`Relax`] straight to the folded state, [`Dynamics`] through the motion, `Newton` (feature `newton`) to the equilibrium itself |
//! | [`Folded`] | the [`State`] reached, why the solver stopped, how far it is from the equilibrium |
//! | [`measure`] | strain, angle errors, distance between states, scenes that are known to go wrong |
//! | [`export`] | FOLD, OBJ and STL files, written whole or not at all |
//!
//! # Units
//!
//! Positions in files are in the file's unit of length. The model is scaled to radius 1, the distance of its farthest vertex
//! from the centre of its bounding box: distances, tolerances, forces and energies are in that unit
//! ([`model::Normalisation`] goes back). Angles are in radians here and in degrees in files. Percentages are of the file's
//! fold angles.
//!
//! # What can be relied on
//!
//! Equal input gives equal bits, whatever the number of threads. Errors name the place in the file ([`Error`]). No input
//! makes the library panic. Nothing is printed.
//!
//! # Features
//!
//! | feature | what it adds |
//! |---|---|
//! | `formats` | the module `formats`: crease patterns as CP, OPX, ORI, SVG and others |
//! | `gpu` | the module `gpu`: the same solvers through wgpu; `gpu.with(Relax::default())` is a [`Solver`] like any other |
//! | `render` | the module `picture`: pictures and films on the CPU; with `gpu` also `gpu::render` |
//! | `newton` | `Newton`: equilibria to a residual of 1e-10, the reference that errors are measured against |
//! | `analysis` | the module `analysis`: structures with supports and loads, paths through snap-through |
//! | `session` | the module `session`: what a page asks of a sheet and is told, and the session that answers |
//! | `study` | the module `study`: error against run time, and what holds on stiff and extreme scenes |
//! | `serde` | `Serialize` and `Deserialize` for settings, scenes, states and saved simulations |
//! | `files`, `parallel` | on by default: paths, and threads |
//!
//! This crate is a facade: everything is re-exported from `origami_core`, `origami_formats`, `origami_gpu`, `origami_picture`,
//! `origami_session` and `origami_study`.
pub use origami_core::*;
/// Other formats than FOLD.
#[cfg(feature = "formats")]
pub use origami_formats as formats;
/// The solvers on a GPU, through wgpu.
#[cfg(feature = "gpu")]
pub use origami_gpu as gpu;
/// Pictures of folded sheets.
#[cfg(feature = "render")]
pub use origami_picture as picture;
/// A sheet that a page steers.
#[cfg(feature = "session")]
pub use origami_session as session;
/// Accuracy and stability of the solvers.
#[cfg(feature = "study")]
pub use origami_study as study;
