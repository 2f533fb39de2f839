//! The adapter of a study, if there is one.

use origami_core::Solver;

/// None, or the GPU on which runs are repeated. Without the feature `gpu` it is always none.
#[derive(Clone, Debug, Default)]
pub struct Gpus {
    #[cfg(feature = "gpu")]
    gpu: Option<origami_gpu::Gpu>,
}

impl Gpus {
    /// This one.
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

    /// Whether there is one.
    pub(crate) fn is_there(&self) -> bool {
        self.name().is_some()
    }

    /// `solver` on it; on the processor where there is none.
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
    /// On the processor.
    pub(crate) fn on_cpu(self) -> Box<dyn Solver> {
        match self {
            Self::Relax(relax) => Box::new(relax),
            Self::Dynamics(dynamics) => Box::new(dynamics),
        }
    }
}
