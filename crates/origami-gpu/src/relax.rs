//! Relaxation on a GPU: the core's attempts, each one run of the engine.

use origami_core::model::{Inventory, Model};
use origami_core::solve::relax::{Attempt, lower};
use origami_core::solve::{Failed, Folded, Instance, Progress, Relax, Session, Solver, State};

use crate::engine::{Engine, Purpose};
use crate::ensemble;
use crate::error::GpuError;
use crate::inventory;
use crate::layout::Control;
use crate::run::Beginning;
use crate::solver::{self, OnGpu, backend, folded, progress};
use crate::variant::Motion;

impl OnGpu<Relax> {
    pub(crate) fn purpose(&self) -> Purpose {
        Purpose { motion: Motion::Relax, safe: false, dispatch: self.dispatch }
    }

    /// Runs instances until each has made all its attempts.
    pub(crate) fn run(
        &self,
        engine: &mut Engine,
        instances: &[Instance<'_>],
        observe: &mut dyn FnMut(usize, Progress),
    ) -> Vec<Result<Folded, Failed>> {
        let relax = &self.method;
        let first = |i: &Instance<'_>| relax.first_attempt(i.model, &i.start, i.percent);
        let mut active: Vec<(usize, Attempt)> = instances.iter().map(first).enumerate().collect();
        let mut kept: Vec<Option<Result<Folded, Failed>>> = instances.iter().map(|_| None).collect();
        while !active.is_empty() {
            let beginnings: Vec<Beginning<'_>> =
                active.iter().map(|(i, attempt)| self.beginning(&instances[*i], *attempt)).collect();
            let so_far = |i: usize| match &kept[i] {
                Some(Ok(folded)) => folded.steps,
                _ => 0,
            };
            let mut told = |place: usize, control: &Control| {
                let i = active[place].0;
                let told = progress(control);
                observe(i, Progress { step: so_far(i) + told.step, ..told });
            };
            let endings = match engine.run(&beginnings, &mut told) {
                Ok(endings) => endings,
                Err(error) => {
                    return gave_up(kept, instances, &active, &error);
                }
            };
            let mut next = Vec::new();
            for ((i, attempt), ending) in active.into_iter().zip(&endings) {
                let instance = &instances[i];
                let targets = instance.model.targets(instance.percent);
                let asked = relax.steps.is_some();
                let came_to = folded(instance.model, instance.percent, targets, asked, ending, solver::Motion::Relax);
                let best = match (kept[i].take(), came_to) {
                    (None, came_to) => came_to,
                    // The state at hand is finite: another way that diverges does not take it away.
                    (Some(Ok(kept)), Ok(other)) => Ok(lower(instance.model, kept, other, attempt.number)),
                    (Some(kept), _) => kept,
                };
                if let Ok(folded) = &best
                    && let Some(attempt) = relax.next_attempt(instance.model, &instance.start, attempt, folded)
                {
                    next.push((i, attempt));
                }
                kept[i] = Some(best);
            }
            active = next;
        }
        kept.into_iter().flatten().collect()
    }

    fn beginning<'m>(&self, instance: &Instance<'m>, attempt: Attempt) -> Beginning<'m> {
        let relax = &self.method;
        Beginning {
            model: instance.model,
            state: relax.beginning(instance.model, &instance.start, instance.percent),
            goals: instance.model.targets(instance.percent),
            ramp: attempt.ramp,
            limit: attempt.limit,
            tolerance: relax.tolerance,
            stops_when_settled: relax.steps.is_none(),
            time_step: 0.0,
            damping_sum: 0.0,
        }
    }
}

/// Every instance that has no result fails for the same reason.
fn gave_up(
    kept: Vec<Option<Result<Folded, Failed>>>,
    instances: &[Instance<'_>],
    active: &[(usize, Attempt)],
    error: &GpuError,
) -> Vec<Result<Folded, Failed>> {
    let failed = |i: usize, kept: Option<Result<Folded, Failed>>| match kept {
        Some(result) if active.iter().all(|(a, _)| *a != i) => result,
        Some(Ok(read)) => Err(backend(error.clone(), &read.state, read.steps)),
        _ => Err(backend(error.clone(), &instances[i].start, 0)),
    };
    kept.into_iter().enumerate().map(|(i, kept)| failed(i, kept)).collect()
}

impl Solver for OnGpu<Relax> {
    fn fold(
        &self,
        model: &Model,
        start: &State,
        percent: f64,
        observe: &mut dyn FnMut(Progress),
    ) -> Result<Folded, Failed> {
        self.session(model).fold(start, percent, observe)
    }

    fn session<'a>(&'a self, model: &'a Model) -> Box<dyn Session + 'a> {
        let engine = Engine::new(&self.gpu, &[model], self.purpose(), 1);
        Box::new(RelaxSession { solver: self, model, engine })
    }

    fn fold_all(
        &self,
        instances: &[Instance<'_>],
        observe: &(dyn Fn(usize, Progress) + Sync),
    ) -> Vec<Result<Folded, Failed>> {
        ensemble::fold_all(&self.gpu, self.purpose(), instances, observe, |engine, instances, observe| {
            self.run(engine, instances, observe)
        })
    }

    fn inventory(&self, model: &Model) -> Inventory {
        inventory::of(&self.gpu, model, self.method.inventory(model), self.purpose())
    }
}

/// The engine stays from one percentage to the next.
struct RelaxSession<'a> {
    solver: &'a OnGpu<Relax>,
    model: &'a Model,
    engine: Result<Engine, GpuError>,
}

impl Session for RelaxSession<'_> {
    fn fold(&mut self, start: &State, percent: f64, observe: &mut dyn FnMut(Progress)) -> Result<Folded, Failed> {
        let engine = self.engine.as_mut().map_err(|error| backend(error.clone(), start, 0))?;
        let instance = Instance { model: self.model, start: start.clone(), percent };
        let mut results = self.solver.run(engine, &[instance], &mut |_, progress| observe(progress));
        results.pop().expect("one result for one instance")
    }
}
