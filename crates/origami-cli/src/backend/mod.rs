//! What computes: the processor, or a GPU where this build has one.

#[cfg(not(feature = "gpu"))]
mod absent;
#[cfg(feature = "gpu")]
mod gpu;

#[cfg(not(feature = "gpu"))]
pub(crate) use absent::{Backend, adapters, none};
#[cfg(feature = "gpu")]
pub(crate) use gpu::{Backend, adapters, none};

use origami::Warning;
use origami::solve::{Dynamics, Relax, Solver};

use crate::report::Adapter;

/// The solver, wherever it runs.
pub(crate) enum Method {
    Relax(Relax),
    Dynamics(Dynamics),
}

/// Where one sheet is folded.
pub(crate) struct Place {
    /// The solver there.
    pub(crate) solver: Box<dyn Solver>,
    /// The GPU; `None` is the processor.
    pub(crate) adapter: Option<Adapter>,
    /// Why it is not where the command line has it.
    pub(crate) warning: Option<Warning>,
}

impl Place {
    fn processor(method: &Method) -> Self {
        let solver: Box<dyn Solver> = match method {
            Method::Relax(relax) => Box::new(relax.clone()),
            Method::Dynamics(dynamics) => Box::new(dynamics.clone()),
        };
        Self { solver, adapter: None, warning: None }
    }
}
