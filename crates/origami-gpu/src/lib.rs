//! Bar-and-hinge origami simulation on the GPU: the solvers of `origami_core` in WGSL compute shaders, through wgpu.
#![forbid(unsafe_code)]

mod device;
mod error;
mod solver;

pub use device::Gpu;
pub use error::GpuError;
pub use solver::OnGpu;
