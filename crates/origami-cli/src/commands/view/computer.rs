//! What folds behind the page: the processor, or a GPU where that is asked for.

use std::sync::Arc;

use origami::scene::Scene;
use origami::solve::{Failed, State};
use origami::{Model, session};
use session::message::SolverWish;
use session::{Computer, Mover, Processor};

use crate::args::BackendName;

/// The backend of the command line.
#[derive(Clone)]
pub(super) enum Chosen {
    Processor,
    #[cfg(feature = "gpu")]
    Gpu(origami::gpu::Gpu),
}

impl Chosen {
    /// Opens the GPU if that is what is wanted.
    ///
    /// # Errors
    /// Why there is none.
    #[cfg(feature = "gpu")]
    pub(super) fn new(wanted: BackendName, adapter: Option<&str>) -> Result<Self, String> {
        use origami::gpu::{AdapterChoice, Gpu};
        if wanted != BackendName::Gpu {
            return Ok(Self::Processor);
        }
        let named = adapter.map(str::trim).filter(|name| !name.is_empty());
        let choice = named.map_or(AdapterChoice::Any, |name| AdapterChoice::Named(name.to_owned()));
        Gpu::open(&choice).map(Self::Gpu).map_err(|error| format!("--backend gpu: {error}"))
    }

    /// The processor.
    ///
    /// # Errors
    /// That another is wanted.
    #[cfg(not(feature = "gpu"))]
    pub(super) fn new(wanted: BackendName, adapter: Option<&str>) -> Result<Self, String> {
        crate::backend::Backend::new(wanted, adapter).map(|_| Self::Processor)
    }
}

impl Computer for Chosen {
    fn mover(
        &self,
        wish: &SolverWish,
        model: Arc<Model>,
        scene: &Scene,
        start: State,
    ) -> Result<Box<dyn Mover>, Failed> {
        match self {
            Self::Processor => Processor.mover(wish, model, scene, start),
            #[cfg(feature = "gpu")]
            Self::Gpu(gpu) => {
                use origami::solve::Simulation;
                use session::computer::{dynamics, relax};
                use session::message::SolverName;
                Ok(match wish.name {
                    SolverName::Relax => {
                        let relax = gpu.with(relax(wish, &model, &start));
                        Box::new(Simulation::in_scene(model, relax, scene, start)?)
                    }
                    SolverName::Dynamics => {
                        Box::new(Simulation::in_scene(model, gpu.with(dynamics(wish)), scene, start)?)
                    }
                })
            }
        }
    }

    fn name(&self) -> String {
        match self {
            Self::Processor => Processor.name(),
            #[cfg(feature = "gpu")]
            Self::Gpu(gpu) => gpu.adapter().to_string(),
        }
    }
}
