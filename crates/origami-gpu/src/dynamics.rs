//! The paper's motion on a GPU.

use std::ops::ControlFlow;

use origami_core::scene::{Held, Refusal};
use origami_core::solve::{Dynamics, Failed, Folded, Instance, Integrator, Progress, TimeStep, time_step};

use crate::engine::Engine;
use crate::layout::Control;
use crate::outcome::{backend, checked, folded, placed, progress, refused};
use crate::purpose::{Dispatch, Purpose};
use crate::run::Beginning;
use crate::variant::Scheme;

/// What an engine for dynamics has to do. `damped`: whether some of the models have damping.
pub(crate) fn purpose(dynamics: &Dynamics, damped: bool, dispatch: Dispatch) -> Purpose {
    let verlet = dynamics.integrator == Integrator::Verlet;
    Purpose { scheme: Scheme::Dynamics { verlet, damped }, safe: dynamics.time_step == TimeStep::Safe, dispatch }
}

/// Runs instances to their ends; results in their order.
pub(crate) fn run(
    dynamics: &Dynamics,
    engine: &mut Engine,
    instances: &[Instance<'_>],
    observe: &mut dyn FnMut(usize, Progress) -> ControlFlow<()>,
) -> Vec<Result<Folded, Failed>> {
    let targets: Result<Vec<_>, _> = instances.iter().map(|i| targets(dynamics, i)).collect();
    let targets = match targets {
        Ok(targets) => targets,
        Err(refusal) => return refused(instances, &refusal),
    };
    let beginnings: Vec<Beginning<'_>> =
        instances.iter().zip(&targets).map(|(i, targets)| beginning(dynamics, i, targets.clone())).collect();
    let mut report = |i: usize, control: &Control| observe(i, progress(control));
    let endings = match engine.run(&beginnings, &mut report) {
        Ok(endings) => endings,
        Err(error) => return instances.iter().map(|i| Err(backend(error.clone(), &i.start, 0))).collect(),
    };
    let scheme = engine.variant.scheme;
    let came_to = |((instance, targets), ending): ((&Instance<'_>, Vec<f64>), _)| {
        let held = Held::new(instance.model, &instance.scene);
        folded(instance, held, targets, dynamics.steps.is_some(), ending, scheme)
    };
    instances.iter().zip(targets).zip(&endings).map(came_to).collect()
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
