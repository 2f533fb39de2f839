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
mod mapped;
mod paper;
mod pipeline;
mod plan;
mod relax;
#[cfg(feature = "render")]
pub mod render;
mod run;
#[cfg(test)]
mod shader_checks;
mod sheet_arrays;
mod solver;
#[cfg(test)]
mod testing;
mod traffic;
mod variant;

pub use adapter::{AUTO_NODES, AdapterChoice, AdapterKind, AdapterLimits, AdapterSummary, Lack, adapters};
pub use device::Gpu;
pub use engine::{Dispatch, WORKGROUP_NODES};
pub use error::GpuError;
pub use paper::PaperDynamics;
pub use solver::{OnGpu, OnModel};
pub use traffic::{BufferSize, PassTraffic, Traffic};
