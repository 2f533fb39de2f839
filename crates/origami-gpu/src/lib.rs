//! Bar-and-hinge origami simulation on the GPU: the solvers of `origami_core` in WGSL compute shaders, through wgpu.
#![forbid(unsafe_code)]

mod adapter;
mod device;
mod error;
mod paper;
#[cfg(test)]
mod shader_checks;
mod solver;
#[cfg(test)]
mod testing;

pub use adapter::{AUTO_NODES, AdapterChoice, AdapterKind, AdapterLimits, AdapterSummary, Lack, adapters};
pub use device::Gpu;
pub use error::GpuError;
pub use paper::PaperDynamics;
pub use solver::OnGpu;
