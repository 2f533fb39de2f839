//! The solvers of `origami_core` on a GPU: WGSL compute shaders through wgpu, on Vulkan, Metal, DirectX 12 and OpenGL.
//!
//! [`Gpu::open`] opens an adapter, and [`Gpu::with`] makes of a solver's settings one that computes there. It is an
//! [`origami_core::Solver`] like any other, with the same results up to rounding.
//!
//! ```
//! use origami_core::{Material, Model, Relax, Solver, generate::BirdBase};
//! use origami_gpu::{AdapterChoice, Gpu};
//!
//! let pattern = BirdBase::default().pattern()?;
//! let model = Model::new(&pattern, &Material::default())?;
//! match Gpu::open(&AdapterChoice::from_env()) {
//!     Ok(gpu) => {
//!         let folded = gpu.with(Relax::default()).fold_from_rest(&model, 90.0)?;
//!         assert!(folded.converged());
//!     }
//!     // A machine without an adapter: the message says what to install.
//!     Err(error) => eprintln!("{error}"),
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What computes where
//!
//! Positions, fold angles, forces, time steps, the stopping rule and the last good state stay on the GPU; the CPU builds the
//! model, looks at a small control block now and then, and reads the state once at the end. Pipelines are put together for
//! the scene at hand: what it does without is in no shader. Positions are an integer and a remainder, finer than f32; all
//! else is f32. On one adapter equal input gives equal bits.
//!
//! # Parts
//!
//! - [`adapters`] lists what there is; [`AdapterChoice`] says which one to take, [`AUTO_NODES`] from which size a GPU is taken
//!   where none was asked for.
//! - [`OnGpu`] is the solver, [`OnModel`] the same with one model's buffers kept, for more than one fold.
//! - [`GpuEngine`] is what an [`origami_core::Simulation`] of `gpu.with(..)` runs on; [`Gpu::from_device`] shares a device of the
//!   caller's, who can read the positions where they lie ([`PositionsBuffer`]).
//! - [`ContactOnGpu`] folds sheets that cannot go through themselves.
//! - [`PaperDynamics`] is the paper's own five passes, the readable baseline.
//! - [`Traffic`] counts the bytes that a step moves.
//! - [`GpuError`] says what the adapter lacks or refused.
//!
//! The shaders are the crate `origami_shaders`, whose README lists every buffer.
//!
//! # Features
//!
//! `render` (off by default) adds the module `render`, which draws the pictures of `origami_picture` on the GPU.
#![forbid(unsafe_code)]

mod adapter;
mod blocks;
#[cfg(test)]
mod buffer_table;
mod contact;
mod device;
mod dynamics;
mod engine;
mod ensemble;
mod error;
mod inventory;
mod kernels;
mod layout;
mod leaving;
mod limits;
mod mapped;
mod method;
mod outcome;
mod outside;
mod pair_arrays;
mod paper;
mod pipeline;
mod plan;
mod positions_buffer;
mod purpose;
mod relax;
#[cfg(feature = "render")]
pub mod render;
mod route;
mod run;
#[cfg(test)]
mod shader_checks;
mod sheet_arrays;
mod simulation;
mod single;
mod solver;
mod steering;
mod stream;
#[cfg(test)]
mod testing;
mod traffic;
mod variant;

pub use adapter::{AUTO_NODES, AUTO_NODES_MEASURED, AdapterChoice, AdapterKind, AdapterSummary, adapters};
pub use contact::{ContactOnGpu, ContactOnModel};
pub use device::Gpu;
pub use error::{Details, GpuError};
pub use limits::{AdapterLimits, Lack};
pub use method::GpuMethod;
pub use paper::PaperDynamics;
pub use positions_buffer::PositionsBuffer;
pub use purpose::{Dispatch, WORKGROUP_NODES};
pub use simulation::GpuEngine;
pub use solver::{OnGpu, OnModel};
pub use traffic::{BufferSize, PassTraffic, Traffic};
/// What devices, queues and buffers that are shared with the caller are.
pub use wgpu;
