//! A build without the feature `gpu`.

use origami::solve::{ContactRelax, Touching};

use super::{Computer, Method};
use crate::args::BackendName;
use crate::report::{AdapterDetails, By};

const ABSENT: &str = "this build has no GPU backend (feature `gpu`)";

/// The processor.
pub(crate) struct Backend(By);

impl Backend {
    /// Whatever else is wanted is refused.
    ///
    /// # Errors
    /// How to build a program that has it.
    pub(crate) fn new(wanted: BackendName, _adapter: Option<&str>) -> Result<Self, String> {
        match wanted {
            BackendName::Auto => Ok(Self(By::Only)),
            BackendName::Cpu => Ok(Self(By::Asked)),
            BackendName::Gpu => Err(format!(
                "--backend gpu: {ABSENT}; expected auto or cpu, or a build without --no-default-features or with \
                 --features gpu"
            )),
        }
    }

    /// The processor, whatever the size.
    pub(crate) fn choose(&self, method: &Method, _nodes: usize) -> Computer {
        Computer::processor(method, self.0)
    }

    /// What folds under contact.
    pub(crate) fn in_contact(&self, solver: ContactRelax) -> Box<dyn Touching> {
        Box::new(solver)
    }

    /// No GPU.
    #[cfg(feature = "study")]
    pub(crate) fn studied(&self) -> origami::study::GpuChoice {
        origami::study::GpuChoice::default()
    }

    /// Nothing but the processor draws.
    #[cfg(feature = "render")]
    pub(crate) fn renderer(&self) -> Option<Result<Box<dyn origami::picture::Renderer>, String>> {
        None
    }
}

/// None can be used.
pub(crate) fn may_have_hardware() -> bool {
    false
}

/// None can be seen.
///
/// # Errors
/// Always.
pub(crate) fn adapters() -> Result<Vec<AdapterDetails>, String> {
    Err(ABSENT.to_owned())
}

/// What to do where there is none.
pub(crate) fn none() -> String {
    ABSENT.to_owned()
}
