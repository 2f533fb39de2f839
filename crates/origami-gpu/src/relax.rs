//! Relaxation on a GPU: the core's attempts, each one run of the engine.

use std::ops::ControlFlow;

use origami_core::scene::{Held, Refusal};
use origami_core::solve::attempt::{Attempt, better, or_crushed, steps_of};
use origami_core::solve::{Failed, Folded, Instance, Progress, Relax, Stop};

use crate::engine::Engine;
use crate::error::GpuError;
use crate::layout::Control;
use crate::outcome::{backend, checked, folded, progress, refused};
use crate::purpose::{Dispatch, Purpose};
use crate::run::Beginning;
use crate::variant::Scheme;

/// What an engine for a relaxation has to do.
pub(crate) fn purpose(dispatch: Dispatch) -> Purpose {
    Purpose { scheme: Scheme::Relax, safe: false, dispatch }
}

/// Runs instances until each has made all its attempts.
pub(crate) fn run(
    relax: &Relax,
    engine: &mut Engine,
    instances: &[Instance<'_>],
    observe: &mut dyn FnMut(usize, Progress) -> ControlFlow<()>,
) -> Vec<Result<Folded, Failed>> {
    let targets: Result<Vec<_>, _> = instances.iter().map(targets).collect();
    let targets = match targets {
        Ok(targets) => targets,
        Err(refusal) => return refused(instances, &refusal),
    };
    let first = |(i, to): (&Instance<'_>, &Vec<f64>)| relax.first_attempt((i.model, &i.scene), &i.start, to);
    let mut active: Vec<(usize, Attempt)> = instances.iter().zip(&targets).map(first).enumerate().collect();
    let mut best_so_far: Vec<Option<Result<Folded, Failed>>> = instances.iter().map(|_| None).collect();
    while !active.is_empty() {
        let beginnings: Vec<Beginning<'_>> =
            active.iter().map(|(i, attempt)| beginning(relax, &instances[*i], &targets[*i], *attempt)).collect();
        let so_far = |i: usize| best_so_far[i].as_ref().map_or(0, steps_of);
        let mut report = |slot: usize, control: &Control| {
            let i = active[slot].0;
            let own = progress(control);
            observe(i, Progress { step: so_far(i) + own.step, ..own })
        };
        let endings = match engine.run(&beginnings, &mut report) {
            Ok(endings) => endings,
            Err(error) => {
                return gave_up(best_so_far, instances, &active, &error);
            }
        };
        let cancelled = endings.iter().any(|ending| ending.cancelled);
        let mut next = Vec::new();
        for ((i, attempt), ending) in active.into_iter().zip(&endings) {
            let instance = &instances[i];
            let held = Held::new(instance.model, &instance.scene);
            let came_to = folded(instance, held, targets[i].clone(), relax.steps.is_some(), ending, Scheme::Relax);
            let best = match best_so_far[i].take() {
                None => came_to,
                Some(kept) => {
                    let broken_off = came_to.as_ref().is_ok_and(|other| other.stop == Stop::Cancelled);
                    let best = better((instance.model, &instance.scene), kept, came_to, attempt.number);
                    if broken_off { best.map(|kept| Folded { stop: Stop::Cancelled, ..kept }) } else { best }
                }
            };
            if !cancelled
                && let Some(another) =
                    relax.next_attempt((instance.model, &instance.scene), &instance.start, attempt, &best)
            {
                next.push((i, another));
                best_so_far[i] = Some(best);
                continue;
            }
            let ended = if relax.retries() && !cancelled {
                or_crushed((instance.model, &instance.scene), best, attempt.number)
            } else {
                best
            };
            best_so_far[i] = Some(ended);
        }
        active = next;
    }
    best_so_far.into_iter().flatten().collect()
}

/// What is asked of the creases of an instance, where this can run it.
pub(crate) fn targets(instance: &Instance<'_>) -> Result<Vec<f64>, Refusal> {
    let targets = checked(instance)?;
    instance.scene.check_balance(instance.model)?;
    Ok(targets)
}

/// Where an attempt begins.
pub(crate) fn beginning<'m>(
    relax: &Relax,
    instance: &Instance<'m>,
    targets: &[f64],
    attempt: Attempt,
) -> Beginning<'m> {
    Beginning {
        model: instance.model,
        state: relax.of_attempt(attempt).beginning(instance.model, &instance.start, &instance.scene, targets),
        held: Held::new(instance.model, &instance.scene),
        loads: instance.scene.loads.clone(),
        targets: targets.to_vec(),
        ramp: attempt.ramp,
        limit: attempt.limit,
        tolerance: relax.tolerance,
        stops_when_settled: relax.steps.is_none(),
        time_step: 0.0,
        damping_sum: 0.0,
    }
}

/// Every instance that has no result fails for the same reason.
fn gave_up(
    best_so_far: Vec<Option<Result<Folded, Failed>>>,
    instances: &[Instance<'_>],
    active: &[(usize, Attempt)],
    error: &GpuError,
) -> Vec<Result<Folded, Failed>> {
    let failed = |i: usize, result: Option<Result<Folded, Failed>>| match result {
        Some(result) if active.iter().all(|(a, _)| *a != i) => result,
        Some(Ok(read)) => Err(backend(error.clone(), &read.state, read.steps)),
        _ => Err(backend(error.clone(), &instances[i].start, 0)),
    };
    best_so_far.into_iter().enumerate().map(|(i, result)| failed(i, result)).collect()
}
