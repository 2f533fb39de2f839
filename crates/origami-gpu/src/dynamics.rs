//! The paper's motion on a GPU.

use origami_core::model::{Inventory, Model};
use origami_core::solve::{
    Dynamics, Failed, Folded, Instance, Integrator, Progress, Session, Solver, State, TimeStep, time_step,
};

use crate::engine::{Engine, Purpose};
use crate::ensemble;
use crate::error::GpuError;
use crate::inventory;
use crate::layout::Control;
use crate::run::Beginning;
use crate::solver::{self, OnGpu, backend, folded, progress};
use crate::variant::Motion;

impl OnGpu<Dynamics> {
    /// `damped`: whether any of the models is.
    fn purpose(&self, damped: bool) -> Purpose {
        let verlet = self.method.integrator == Integrator::Verlet;
        let motion = Motion::Dynamics { verlet, damped };
        Purpose { motion, safe: self.method.time_step == TimeStep::Safe, dispatch: self.dispatch }
    }

    fn run(
        &self,
        engine: &mut Engine,
        instances: &[Instance<'_>],
        observe: &mut dyn FnMut(usize, Progress),
    ) -> Vec<Result<Folded, Failed>> {
        let beginnings: Vec<Beginning<'_>> = instances.iter().map(|i| self.beginning(i)).collect();
        let mut told = |i: usize, control: &Control| observe(i, progress(control));
        let endings = match engine.run(&beginnings, &mut told) {
            Ok(endings) => endings,
            Err(error) => return instances.iter().map(|i| Err(backend(error.clone(), &i.start, 0))).collect(),
        };
        let motion = match self.method.integrator {
            Integrator::Euler => solver::Motion::Euler,
            Integrator::Verlet => solver::Motion::Verlet,
        };
        let came_to = |(instance, ending): (&Instance<'_>, _)| {
            let targets = instance.model.targets(instance.percent);
            folded(instance.model, instance.percent, targets, self.method.steps.is_some(), ending, motion)
        };
        instances.iter().zip(&endings).map(came_to).collect()
    }

    fn beginning<'m>(&self, instance: &Instance<'m>) -> Beginning<'m> {
        let (dynamics, model) = (&self.method, instance.model);
        Beginning {
            model,
            state: instance.start.clone(),
            goals: model.targets(instance.percent),
            ramp: dynamics.ramp,
            limit: dynamics.steps.unwrap_or(dynamics.max_steps),
            tolerance: dynamics.tolerance,
            stops_when_settled: dynamics.steps.is_none(),
            time_step: match dynamics.time_step {
                TimeStep::Paper => time_step::paper(model),
                TimeStep::Safe => time_step::safe(model, &instance.start.positions, dynamics.integrator),
                TimeStep::Fixed(dt) => dt,
            },
            damping_sum: time_step::damping_sum(model, dynamics.integrator),
        }
    }
}

impl Solver for OnGpu<Dynamics> {
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
        let purpose = self.purpose(model.material.zeta > 0.0);
        Box::new(DynamicsSession { solver: self, model, engine: Engine::new(&self.gpu, &[model], purpose, 1) })
    }

    fn fold_all(
        &self,
        instances: &[Instance<'_>],
        observe: &(dyn Fn(usize, Progress) + Sync),
    ) -> Vec<Result<Folded, Failed>> {
        let purpose = self.purpose(instances.iter().any(|i| i.model.material.zeta > 0.0));
        ensemble::fold_all(&self.gpu, purpose, instances, observe, |engine, instances, observe| {
            self.run(engine, instances, observe)
        })
    }

    fn inventory(&self, model: &Model) -> Inventory {
        let purpose = self.purpose(model.material.zeta > 0.0);
        inventory::of(&self.gpu, model, self.method.inventory(model), purpose)
    }
}

/// The engine stays from one percentage to the next.
struct DynamicsSession<'a> {
    solver: &'a OnGpu<Dynamics>,
    model: &'a Model,
    engine: Result<Engine, GpuError>,
}

impl Session for DynamicsSession<'_> {
    fn fold(&mut self, start: &State, percent: f64, observe: &mut dyn FnMut(Progress)) -> Result<Folded, Failed> {
        let engine = self.engine.as_mut().map_err(|error| backend(error.clone(), start, 0))?;
        let instance = Instance { model: self.model, start: start.clone(), percent };
        let mut results = self.solver.run(engine, &[instance], &mut |_, progress| observe(progress));
        results.pop().expect("one result for one instance")
    }
}
