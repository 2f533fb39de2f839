//! Which of the core's solvers a GPU can compute.

use origami_core::model::{Model, Softening};
use origami_core::scene::{Refusal, Scene};
use origami_core::solve::{Dynamics, Instance, Relax, Solver, State, TimeStep};

use crate::engine::Engine;
use crate::purpose::{Dispatch, Purpose};
use crate::run::Beginning;
use crate::stream::Asked;
use crate::{dynamics, relax, single};

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

/// The same, kept.
#[derive(Clone, Debug)]
pub(crate) enum Settings {
    Relax(Relax),
    Dynamics(Dynamics),
}

impl Settings {
    pub(crate) fn of(method: Method<'_>) -> Self {
        match method {
            Method::Relax(relax) => Self::Relax(relax.clone()),
            Method::Dynamics(dynamics) => Self::Dynamics(dynamics.clone()),
        }
    }

    pub(crate) fn method(&self) -> Method<'_> {
        match self {
            Self::Relax(relax) => Method::Relax(relax),
            Self::Dynamics(dynamics) => Method::Dynamics(dynamics),
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

impl<'r> Method<'r> {
    /// What an engine for `models` has to do.
    pub(crate) fn purpose<'m>(self, dispatch: Dispatch, mut models: impl Iterator<Item = &'m Model>) -> Purpose {
        match self {
            Self::Relax(method) => relax::purpose(method, dispatch, models),
            Self::Dynamics(method) => {
                dynamics::purpose(method, models.any(|model| model.material.zeta > 0.0), dispatch)
            }
        }
    }

    /// Whether a GPU can compute with the settings.
    pub(crate) fn check_settings(self) -> Result<(), Refusal> {
        match self {
            Self::Relax(method) => single::check("tolerance", method.tolerance),
            Self::Dynamics(method) => {
                let fixed = if let TimeStep::Fixed(length) = method.time_step { length } else { 0.0 };
                single::check("tolerance", method.tolerance)?;
                single::check("time step", fixed)
            }
        }
    }

    /// Whether this can run an instance to its end.
    pub(crate) fn check(self, instance: &Instance<'_>) -> Result<(), Refusal> {
        self.check_settings()?;
        match self {
            Self::Relax(_) => relax::targets(instance),
            Self::Dynamics(method) => dynamics::targets(method, instance),
        }
        .map(|_| ())
    }

    /// Where an instance begins, on the way to `targets`.
    pub(crate) fn beginning<'m>(self, instance: &Instance<'m>, targets: Vec<f64>) -> Beginning<'m> {
        match self {
            Self::Relax(method) => {
                let attempt = method.first_attempt((instance.model, &instance.scene), &instance.start, &targets);
                relax::beginning(method, instance, &targets, attempt)
            }
            Self::Dynamics(method) => dynamics::beginning(method, instance, targets),
        }
    }

    /// Evaluations of the ramp from the targets of `start` to others, and how soft the sheet is on it.
    pub(crate) fn ramp(
        self,
        (model, scene): (&Model, &Scene),
        start: &State,
        targets: &[f64],
    ) -> (u32, Option<Softening>) {
        match self {
            Self::Relax(method) => {
                let attempt = method.first_attempt((model, scene), start, targets);
                (attempt.ramp, attempt.softening)
            }
            Self::Dynamics(method) => (method.ramp, None),
        }
    }

    /// Runs instances to their ends, as many at once as the engine has room for.
    pub(crate) fn run(self, engine: &Engine, asked: Asked<'r, '_>) {
        match self {
            Self::Relax(method) => relax::run(method, engine, asked),
            Self::Dynamics(method) => dynamics::run(method, engine, asked),
        }
    }
}
