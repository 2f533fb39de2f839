//! The way of a solver towards the equilibrium: its states, with what they cost.

use origami_core::scene::{Scene, Targets};
use origami_core::solve::unwatched;
use std::time::Instant;

use origami_core::glam::DVec3;
use origami_core::solve::{Failed, Stop};
use origami_core::{Dynamics, Folded, Model, Newton, Relax, Solver, State};

use super::cases::Case;
use crate::gpu_choice::{GpuChoice, OnEither};
use crate::options::Deadline;

/// Evaluations at the first look, and how much later each next one is: closer where curves are compared in full.
const FIRST_LOOK: u64 = 20;
const NEXT_LOOK: f64 = 1.15;
const NEXT_LOOK_IN_FULL: f64 = 1.05;
/// Runs shorter than this many seconds are timed three times, and the least counts.
const SHORT: f64 = 0.05;
/// Seconds after which one solver is left on one case.
const PATIENCE: f64 = 60.0;

/// A state on the way.
#[derive(Clone, Debug)]
pub(super) struct Look {
    pub(super) evaluations: u64,
    /// Of Newton's method alone.
    pub(super) factorisations: Option<u32>,
    /// Of solving, from the first evaluation on.
    pub(super) seconds: f64,
    pub(super) positions: Vec<DVec3>,
}

/// The way of a run, from its first look to its end.
#[derive(Clone, Debug, Default)]
pub(super) struct Trail {
    pub(super) looks: Vec<Look>,
    /// Where it ended; `None` where it diverged before the first look.
    pub(super) last: Option<Folded>,
    /// Why the run ended early.
    pub(super) failed: Option<String>,
}

/// Where it is computed.
#[derive(Clone, Copy, Debug)]
pub(super) enum On<'a> {
    Cpu,
    Gpu(&'a GpuChoice),
}

/// The motion of `dynamics`, looked at as it goes on: its state is all that it needs to continue.
pub(super) fn of_dynamics(
    case: &Case,
    model: &Model,
    dynamics: &Dynamics,
    on: On<'_>,
    limit: u64,
    arrived: impl Fn(&Look) -> bool,
    deadline: Deadline,
) -> Trail {
    let mut trail = Trail::default();
    let part = |steps: u64, ramp: u32| Dynamics { steps: Some(steps), ramp, ..dynamics.clone() };
    let (mut state, mut evaluations, mut seconds) = (State::at_rest(model), 0, 0.0);
    let mut next = if case.ramp == 0 { FIRST_LOOK } else { u64::from(case.ramp) };
    while evaluations < limit && seconds < PATIENCE && !deadline.passed() {
        let ramp = if evaluations == 0 { case.ramp } else { 0 };
        match timed(OnEither::Dynamics(part(next, ramp)), model, &state, case.percent, on) {
            Ok((folded, spent)) => {
                seconds += spent;
                evaluations += folded.steps;
                state = folded.state.clone();
                trail.looks.push(look(&folded, evaluations, seconds));
                trail.last = Some(folded);
                if trail.looks.last().is_some_and(&arrived) {
                    return trail;
                }
            }
            Err(failed) => {
                trail.failed = Some(failed.to_string());
                return trail;
            }
        }
        // Whole renewals of the safe step, so that parts make the same steps as one run.
        next = further(case, evaluations, 20);
    }
    trail
}

/// The way of `relax`: one run for each look, of so many evaluations, and at the end the run that claims to have converged.
pub(super) fn of_relax(case: &Case, relax: &Relax, on: On<'_>, deadline: Deadline) -> Trail {
    let mut trail = Trail::default();
    let relax = Relax { ramp: Some(case.ramp), ..relax.clone() };
    let start = State::at_rest(&case.model);
    let run = |relax: Relax| timed(OnEither::Relax(relax), &case.model, &start, case.percent, on);
    let (claim, in_all) = match run(relax.clone()) {
        Ok(claim) => claim,
        Err(failed) => {
            trail.failed = Some(failed.to_string());
            return trail;
        }
    };
    // Looks at a way that was tried more than once would show the first attempt.
    let looks = if claim.attempts == 1 { claim.steps } else { 0 };
    let (mut evaluations, mut spent) = (FIRST_LOOK, 0.0);
    while evaluations < looks && spent < PATIENCE && !deadline.passed() {
        if let Ok((folded, seconds)) = run(Relax { steps: Some(evaluations), retry: false, ..relax.clone() }) {
            spent += seconds;
            trail.looks.push(look(&folded, evaluations, seconds));
        }
        evaluations += further(case, evaluations, 5);
    }
    trail.looks.push(look(&claim, claim.steps, in_all));
    bound_by_later(&mut trail.looks);
    trail.last = Some(claim);
    trail
}

/// Where Newton's method begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum From {
    /// From the state in which `relax` ends.
    Relax,
    /// At rest, the target angles rising in increments.
    Rest,
    /// At rest, off every symmetry, with the target angles as asked.
    Jump,
}

/// The way of Newton's method: one run for each residual.
pub(super) fn of_newton(case: &Case, from: From, deadline: Deadline) -> Trail {
    let mut trail = Trail::default();
    for residual in [1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10] {
        if deadline.passed() {
            break;
        }
        let newton = Newton { residual, ..Newton::default() };
        let began = Instant::now();
        let reached = match from {
            From::Relax => {
                let relax = Relax { ramp: Some(case.ramp), ..Relax::default() };
                let near = relax.fold(
                    &case.model,
                    &State::at_rest(&case.model),
                    &Scene::percent(case.percent),
                    &mut unwatched,
                );
                near.and_then(|near| newton.refine(&case.model, &near.state).map(|reached| (reached, near.steps)))
            }
            From::Rest => {
                newton.climb(&case.model, &State::at_rest(&case.model), &Scene::percent(case.percent)).map(|r| (r, 0))
            }
            From::Jump => {
                let off = State::perturbed(&case.model, newton.perturbation, 0);
                let jump = State { targets: case.model.targets(case.percent), ..off };
                newton.refine(&case.model, &jump).map(|reached| (reached, 0))
            }
        };
        match reached {
            Ok((reached, before)) => {
                let folded = Folded {
                    targets: Targets::percent(case.percent),
                    stop: if reached.converged { Stop::Converged } else { Stop::StepLimit },
                    steps: before + reached.evaluations,
                    time_step: 1.0,
                    residual: reached.residual,
                    distance: reached.distance,
                    attempts: 1,
                    saddles: reached.escapes,
                    factorisations: reached.factorisations,
                    state: reached.state,
                    reactions: reached.reactions,
                };
                let seconds = began.elapsed().as_secs_f64();
                let look = look(&folded, folded.steps, seconds);
                trail.looks.push(Look { factorisations: Some(reached.factorisations), ..look });
                trail.last = Some(folded);
            }
            Err(failed) => trail.failed = Some(failed.to_string()),
        }
    }
    bound_by_later(&mut trail.looks);
    trail
}

/// A fold and its seconds; on a GPU without those of building its pipelines.
fn timed(method: OnEither, model: &Model, start: &State, percent: f64, on: On<'_>) -> Result<(Folded, f64), Failed> {
    let solver = match on {
        On::Cpu => method.on_cpu(),
        On::Gpu(gpu) => gpu.with(method),
    };
    let mut session = solver.session(model);
    let mut run = || -> Result<(Folded, f64), Failed> {
        let began = Instant::now();
        let folded = session.fold(start, &Scene::percent(percent), &mut unwatched)?;
        Ok((folded, began.elapsed().as_secs_f64()))
    };
    let (folded, first) = run()?;
    let again = if first < SHORT || matches!(on, On::Gpu(_)) { 2 } else { 0 };
    let seconds = (0..again).filter_map(|_| run().ok()).map(|(_, seconds)| seconds);
    Ok((folded, seconds.fold(first, f64::min)))
}

fn look(folded: &Folded, evaluations: u64, seconds: f64) -> Look {
    Look { evaluations, factorisations: None, seconds, positions: folded.state.positions.clone() }
}

/// A run that goes further and took less time shows that a shorter one was held up by something else.
fn bound_by_later(looks: &mut [Look]) {
    let mut least = f64::INFINITY;
    for look in looks.iter_mut().rev() {
        least = least.min(look.seconds);
        look.seconds = least;
    }
}

/// How many evaluations lie between a look and the next: a multiple of `unit`, and at least that.
fn further(case: &Case, evaluations: u64, unit: u64) -> u64 {
    let next = if case.in_full { NEXT_LOOK_IN_FULL } else { NEXT_LOOK };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of a step count")]
    let share = (evaluations as f64 * (next - 1.0)) as u64;
    (share / unit).max(1) * unit
}
