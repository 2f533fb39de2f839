//! The solvers of the core, computed on a GPU.

use crate::device::Gpu;

/// A solver of the core that computes on a GPU.
#[derive(Clone, Debug)]
pub struct OnGpu<S> {
    pub(crate) gpu: Gpu,
    pub(crate) method: S,
}
