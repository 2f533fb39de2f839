//! What computes: the processor, or a GPU where this build has one.

#[cfg(not(feature = "gpu"))]
mod absent;
#[cfg(feature = "gpu")]
mod gpu;

#[cfg(not(feature = "gpu"))]
pub(crate) use absent::{Backend, adapters, may_have_hardware, none};
#[cfg(feature = "gpu")]
pub(crate) use gpu::{Backend, adapters, may_have_hardware, none};

use origami::Warning;
#[cfg(feature = "newton")]
use origami::solve::Newton;
use origami::solve::{Dynamics, Reflect, Relax, Solver};

use crate::report::{Adapter, By};

/// The solver, wherever it runs.
pub(crate) enum Method {
    Relax(Relax),
    Dynamics(Dynamics),
    #[cfg(feature = "newton")]
    Newton(Newton),
    Reflect(Reflect),
}

impl Method {
    /// On the processor.
    fn solver(&self) -> Box<dyn Solver> {
        match self {
            Self::Relax(relax) => Box::new(relax.clone()),
            Self::Dynamics(dynamics) => Box::new(dynamics.clone()),
            #[cfg(feature = "newton")]
            Self::Newton(newton) => Box::new(newton.clone()),
            Self::Reflect(reflect) => Box::new(reflect.clone()),
        }
    }
}

/// Where one sheet is folded.
pub(crate) struct Computer {
    /// The solver there.
    pub(crate) solver: Box<dyn Solver>,
    /// The GPU; `None` is the processor.
    pub(crate) adapter: Option<Adapter>,
    /// What decided that.
    pub(crate) by: By,
    /// Why it is not where the command line has it.
    pub(crate) warning: Option<Warning>,
}

impl Computer {
    fn processor(method: &Method, by: By) -> Self {
        Self { solver: method.solver(), adapter: None, by, warning: None }
    }
}
