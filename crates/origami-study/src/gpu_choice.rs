//! Where a study repeats its runs: on a GPU, or nowhere.

use origami_core::Solver;

/// The GPU on which runs are repeated, or none. Without the feature `gpu` it is always none.
#[derive(Clone, Debug, Default)]
pub struct GpuChoice {
    #[cfg(feature = "gpu")]
    gpu: Option<origami_gpu::Gpu>,
}

impl GpuChoice {
    /// Runs are repeated on this GPU.
    #[cfg(feature = "gpu")]
    #[must_use]
    pub fn new(gpu: origami_gpu::Gpu) -> Self {
        Self { gpu: Some(gpu) }
    }

    /// The adapter's name, for tables and plots.
    #[must_use]
    pub fn name(&self) -> Option<String> {
        #[cfg(feature = "gpu")]
        return self.gpu.as_ref().map(|gpu| gpu.adapter().to_string());
        #[cfg(not(feature = "gpu"))]
        None
    }

    /// Whether a GPU was chosen.
    pub(crate) fn is_there(&self) -> bool {
        self.name().is_some()
    }

    /// `solver` on the chosen GPU, or on the processor if none was chosen.
    pub(crate) fn with(&self, solver: OnEither) -> Box<dyn Solver> {
        #[cfg(feature = "gpu")]
        if let Some(gpu) = &self.gpu {
            return match solver {
                OnEither::Relax(relax) => Box::new(gpu.with(relax)),
                OnEither::Dynamics(dynamics) => Box::new(gpu.with(dynamics)),
            };
        }
        solver.on_cpu()
    }
}

/// A solver that runs on both backends.
#[derive(Clone, Debug)]
pub(crate) enum OnEither {
    Relax(origami_core::Relax),
    Dynamics(origami_core::Dynamics),
}

impl OnEither {
    /// The solver on the processor.
    pub(crate) fn on_cpu(self) -> Box<dyn Solver> {
        match self {
            Self::Relax(relax) => Box::new(relax),
            Self::Dynamics(dynamics) => Box::new(dynamics),
        }
    }
}
