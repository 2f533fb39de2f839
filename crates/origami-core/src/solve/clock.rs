//! The time step of [`super::Dynamics`], and its renewal.

use std::sync::Arc;

use super::time_step::{self, Safe};
use super::{Integrator, State, TimeStep};
use crate::kernel::{Compute, Kernel};
use crate::model::Model;
use crate::scene::Force;
use crate::twins::safe_time_step::RENEWAL;

/// The step, and its renewal.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Clock {
    /// Of [`TimeStep::Safe`].
    safe: Option<Safe>,
    pub(super) dt: f64,
    /// The step before; 0 at first.
    pub(super) previous: f64,
}

impl Clock {
    pub(super) fn new(time_step: TimeStep, integrator: Integrator, model: &Model) -> Self {
        let safe = (time_step == TimeStep::Safe).then(|| Safe::new(model, integrator));
        let dt = match time_step {
            TimeStep::Paper | TimeStep::Safe => time_step::paper(model),
            TimeStep::Fixed(dt) => dt,
        };
        Self { safe, dt, previous: 0.0 }
    }

    /// The length of the step that comes after `steps` others; `state` is told where the nodes are, where it is renewed.
    pub(super) fn step<R: Compute>(
        &mut self,
        (model, own): (&Model, &[Arc<dyn Force>]),
        kernel: &mut Kernel<R>,
        state: &mut State,
        steps: u64,
    ) -> f64 {
        if let Some(safe) = &mut self.safe
            && steps.is_multiple_of(RENEWAL)
        {
            kernel.read_positions(&mut state.positions);
            kernel.read_velocities(&mut state.velocities);
            let safe = safe.step(kernel.shared(), (model, own), &state.positions);
            self.dt = time_step::renewed(safe, &state.velocities, (steps > 0).then_some(self.dt));
        }
        self.dt
    }
}
