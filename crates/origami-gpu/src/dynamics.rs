//! The paper's motion on a GPU.

use std::collections::BTreeMap;
use std::ops::{ControlFlow, Range};

use origami_core::scene::{Held, Refusal};
use origami_core::solve::{Dynamics, Failed, Instance, Integrator, TimeStep, time_step};

use crate::engine::Engine;
use crate::error::GpuError;
use crate::layout::Control;
use crate::outcome::{backend, checked, folded, placed, progress};
use crate::purpose::{Dispatch, Purpose};
use crate::run::{Beginning, Ending};
use crate::stream::{Asked, Sheets};
use crate::variant::Scheme;

/// What an engine for dynamics has to do. `damped`: whether some of the models have damping.
pub(crate) fn purpose(dynamics: &Dynamics, damped: bool, dispatch: Dispatch) -> Purpose {
    let verlet = dynamics.integrator == Integrator::Verlet;
    Purpose {
        scheme: Scheme::Dynamics { verlet, damped },
        safe: dynamics.time_step == TimeStep::Safe,
        softens: false,
        dispatch,
    }
}

/// Runs instances to their ends.
pub(crate) fn run<'r>(dynamics: &'r Dynamics, engine: &Engine, asked: Asked<'r, '_>) {
    let waiting = 0..asked.instances.len();
    let mut motions = Motions { dynamics, asked, waiting, running: BTreeMap::new(), scheme: engine.variant.scheme };
    if let Err(error) = engine.stream(&mut motions) {
        motions.gave_up(&error);
    }
}

/// Instances in motion.
struct Motions<'r, 'm> {
    dynamics: &'r Dynamics,
    asked: Asked<'r, 'm>,
    /// Those that are to begin, by their places.
    waiting: Range<usize>,
    /// Those that are on the GPU, with their targets.
    running: BTreeMap<usize, Vec<f64>>,
    scheme: Scheme,
}

impl<'m> Sheets<'m> for Motions<'_, 'm> {
    fn next(&mut self) -> Option<(usize, Beginning<'m>)> {
        loop {
            let i = self.waiting.next()?;
            let instance = self.asked.instances[i];
            match targets(self.dynamics, instance) {
                Ok(targets) => {
                    self.running.insert(i, targets.clone());
                    return Some((i, beginning(self.dynamics, instance, targets)));
                }
                Err(refusal) => {
                    // Whoever wants no more is told nothing more.
                    let refused = Err(Failed::refused(refusal, &instance.start));
                    if (self.asked.take)(i, refused).is_break() {
                        self.waiting = 0..0;
                    }
                }
            }
        }
    }

    fn look(&mut self, i: usize, control: &Control) -> ControlFlow<()> {
        (self.asked.observe)(i, progress(control))
    }

    fn end(&mut self, i: usize, ending: Ending) -> ControlFlow<()> {
        let Some(targets) = self.running.remove(&i) else { return ControlFlow::Continue(()) };
        let instance = self.asked.instances[i];
        let held = Held::new(instance.model, &instance.scene);
        let steps_asked = self.dynamics.steps.is_some();
        (self.asked.take)(i, folded(instance, held, targets, steps_asked, &ending, self.scheme))
    }
}

impl Motions<'_, '_> {
    /// Every instance that has no result fails for the same reason.
    fn gave_up(self, error: &GpuError) {
        for i in self.running.keys().copied().chain(self.waiting) {
            if (self.asked.take)(i, Err(backend(error.clone(), &self.asked.instances[i].start, 0))).is_break() {
                return;
            }
        }
    }
}

/// What is asked of the creases of an instance, where this can run it. Whoever asks for so many steps may watch a sheet fall.
pub(crate) fn targets(dynamics: &Dynamics, instance: &Instance<'_>) -> Result<Vec<f64>, Refusal> {
    let targets = checked(instance)?;
    if dynamics.steps.is_none() {
        instance.scene.check_balance(instance.model)?;
    }
    Ok(targets)
}

/// Where an instance begins.
pub(crate) fn beginning<'m>(dynamics: &Dynamics, instance: &Instance<'m>, targets: Vec<f64>) -> Beginning<'m> {
    let (model, state) = (instance.model, placed(instance));
    Beginning {
        model,
        held: Held::new(model, &instance.scene),
        loads: instance.scene.loads.clone(),
        targets,
        ramp: dynamics.ramp,
        softening: None,
        limit: dynamics.steps.unwrap_or(dynamics.max_steps),
        tolerance: dynamics.tolerance,
        stops_when_settled: dynamics.steps.is_none(),
        time_step: match dynamics.time_step {
            TimeStep::Paper => time_step::paper(model),
            TimeStep::Safe => {
                let safe = time_step::safe(model, &state.positions, dynamics.integrator);
                time_step::renewed(safe, &state.velocities, None)
            }
            TimeStep::Fixed(dt) => dt,
            _ => time_step::paper(model),
        },
        damping_sum: time_step::damping_sum(model, dynamics.integrator),
        state,
    }
}
