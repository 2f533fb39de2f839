//! Which of the core's solvers a GPU can compute.

use std::ops::ControlFlow;

use origami_core::model::Model;
use origami_core::solve::{Dynamics, Failed, Folded, Instance, Progress, Relax, Solver};

use crate::engine::Engine;
use crate::purpose::{Dispatch, Purpose};
use crate::{dynamics, relax};

/// A solver of the core that a GPU can compute: [`Relax`] or [`Dynamics`]. No other type can have this trait.
pub trait GpuMethod: Solver + sealed::Sealed {}

impl GpuMethod for Relax {}
impl GpuMethod for Dynamics {}

mod sealed {
    use super::{Dynamics, Method, Relax};

    pub trait Sealed {
        fn method(&self) -> Method<'_>;
    }

    impl Sealed for Relax {
        fn method(&self) -> Method<'_> {
            Method::Relax(self)
        }
    }

    impl Sealed for Dynamics {
        fn method(&self) -> Method<'_> {
            Method::Dynamics(self)
        }
    }
}

/// The solvers of the core that a GPU can compute, with their settings.
#[derive(Clone, Copy, Debug)]
pub enum Method<'a> {
    /// Relaxation to the folded state.
    Relax(&'a Relax),
    /// The paper's motion.
    Dynamics(&'a Dynamics),
}

impl Method<'_> {
    /// What an engine for `models` has to do.
    pub(crate) fn purpose<'m>(self, dispatch: Dispatch, mut models: impl Iterator<Item = &'m Model>) -> Purpose {
        match self {
            Self::Relax(_) => relax::purpose(dispatch),
            Self::Dynamics(method) => {
                dynamics::purpose(method, models.any(|model| model.material.zeta > 0.0), dispatch)
            }
        }
    }

    /// Runs instances, no more than the engine was built for, to their ends; results in their order.
    pub(crate) fn run(
        self,
        engine: &mut Engine,
        instances: &[Instance<'_>],
        observe: &mut dyn FnMut(usize, Progress) -> ControlFlow<()>,
    ) -> Vec<Result<Folded, Failed>> {
        match self {
            Self::Relax(method) => relax::run(method, engine, instances, observe),
            Self::Dynamics(method) => dynamics::run(method, engine, instances, observe),
        }
    }
}
