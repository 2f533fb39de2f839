//! Bar-and-hinge origami simulation on the GPU: the solvers of `origami_core` in WGSL compute shaders, through wgpu.
#![forbid(unsafe_code)]

mod adapter;
#[cfg(test)]
mod buffer_table;
mod device;
mod dynamics;
mod engine;
mod ensemble;
mod error;
mod inventory;
mod kernels;
mod layout;
mod limits;
mod mapped;
mod method;
mod outcome;
mod outside;
mod paper;
mod pipeline;
mod plan;
mod positions_buffer;
mod purpose;
mod relax;
#[cfg(feature = "render")]
pub mod render;
mod run;
#[cfg(test)]
mod shader_checks;
mod sheet_arrays;
mod simulation;
mod solver;
mod steering;
#[cfg(test)]
mod testing;
mod traffic;
mod variant;

pub use adapter::{AUTO_NODES, AdapterChoice, AdapterKind, AdapterSummary, adapters};
pub use device::Gpu;
pub use error::GpuError;
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
