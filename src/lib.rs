//! Folds origami crease patterns: the bar-and-hinge method of Ghassaei, Demaine and Gershenfeld (2018), with the truth
//! about convergence and error.
//!
//! ```
//! use origami::{Material, Model, Relax, generate::BirdBase};
//!
//! let pattern = BirdBase::default().pattern()?;
//! let model = Model::new(&pattern, &Material::default())?;
//! let folded = Relax::default().fold_from_rest(&model, 90.0)?;
//! assert!(folded.converged());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! `examples/embed.rs` does the same from file to file. Data flows one way: a FOLD [`Document`](fold::Document) becomes a
//! [`CreasePattern`], its [`Model`] the triangulated sheet with its springs; a [`Solver`] ([`Relax`] unless the motion
//! itself is wanted, then [`Dynamics`]) folds it; [`measure`] says how strained it is and [`export`] writes it.
//!
//! With the feature `gpu` (off by default) the module `gpu` computes both solvers on a graphics card: `Gpu::open` takes an
//! adapter, and `gpu.with(Relax::default())` is a [`Solver`] like any other.
//!
//! With the feature `render` (off by default) the module `picture` draws folded sheets on the processor, and with both
//! features `gpu::render` draws the same pictures on a graphics card.
//!
//! With the feature `study` (off by default) the module `study` finds out how far the solvers can be trusted.
//!
//! This crate is a facade: everything is `origami_core`'s, and `origami_gpu`'s in `gpu`. Errors name the place in the file ([`Error`]); what was odd but
//! could be put right is among the pattern's [`warnings`](CreasePattern::warnings). Equal input gives equal bits.
pub use origami_core::*;
/// The solvers on a GPU, through wgpu.
#[cfg(feature = "gpu")]
pub use origami_gpu as gpu;
/// Pictures of folded sheets.
#[cfg(feature = "render")]
pub use origami_picture as picture;
/// Accuracy and stability of the solvers.
#[cfg(feature = "study")]
pub use origami_study as study;
