//! A row of the study: a case with all that was found of it.

use origami_core::measure::align;
use origami_core::solve::{Integrator, TimeStep, time_step};
use origami_core::{Dynamics, Model, Newton, State};

use super::cases::{Case, Size};
use super::found::{Budget, Found, Limit, Relaxed, follow, unpanicked};
use super::gpu_run::GpuRun;
use super::motion::{self, Motion, Outcome};

/// Factorisations that the reference may take.
const FACTORISATIONS: u32 = 300;
/// Nodes above which no reference is sought.
const MOST_NODES: usize = 3000;

/// A case with all that was found of it.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) case: Case,
    pub(super) result: CaseResult,
    /// The same in 32 bits, where there is a GPU.
    pub(super) gpu: Option<GpuRun>,
}

impl Row {
    /// What was found; `None` if the case was refused, panicked or was left out.
    pub(super) fn found(&self) -> Option<&Found> {
        match &self.result {
            CaseResult::Found(found) => Some(found),
            _ => None,
        }
    }
}

/// What came of a case.
#[derive(Clone, Debug)]
pub(super) enum CaseResult {
    /// All of it was run.
    Found(Box<Found>),
    /// The case makes no model, and an error says why.
    Refused(String),
    /// The run panicked, with this text.
    Panicked(String),
    /// There was no time to run it.
    LeftOut,
}

/// Runs a case on the processor.
pub(super) fn run(case: &Case, budget: Budget) -> CaseResult {
    let pattern = case.pattern.as_ref().map_err(ToString::to_string);
    match pattern.and_then(|pattern| Model::new(pattern, &case.material).map_err(|error| error.to_string())) {
        Err(error) => CaseResult::Refused(error),
        Ok(model) => {
            unpanicked(|| CaseResult::Found(Box::new(find(case, model, budget)))).unwrap_or_else(CaseResult::Panicked)
        }
    }
}

fn find(case: &Case, model: Model, budget: Budget) -> Found {
    let (steps, _) = budget.of(case.size);
    let motion = |time_step, integrator| {
        let solver = motion::piece(Dynamics { time_step, integrator, ..Dynamics::default() }, steps);
        let each = steps / motion::PIECES;
        Motion { solver: &solver, integrator, each, rounding: motion::ROUNDING }.run(&model, &case.path)
    };
    let effort = if case.size == Size::Small { budget.effort } else { budget.effort_of_large };
    let at_rest = State::at_rest(&model);
    let limit = |state: &State, integrator| Limit::find(&model, state, integrator, effort);
    let (safe, end) = motion(TimeStep::Safe, Integrator::Euler);
    let (relaxed, equilibrium) = relax(case, &model, budget);
    Found {
        paper_step: time_step::paper(&model),
        paper: motion(TimeStep::Paper, Integrator::Euler).0,
        safe,
        safe_verlet: motion(TimeStep::Safe, Integrator::Verlet).0,
        end,
        at_rest: limit(&at_rest, Integrator::Euler),
        verlet: (case.size == Size::Small).then(|| limit(&at_rest, Integrator::Verlet)),
        folded: equilibrium.as_ref().map(|state| limit(state, Integrator::Euler)),
        relaxed,
        equilibrium,
        model,
    }
}

fn relax(case: &Case, model: &Model, budget: Budget) -> (Relaxed, Option<State>) {
    let folded = match follow(case, model, budget, |relax| Box::new(relax.clone())) {
        Ok(folded) if motion::is_finite(&folded.state) => folded,
        Ok(_) => return (Relaxed::Failed(Outcome::Wrong("not finite".into())), None),
        Err(failed) => return (Relaxed::Failed(Outcome::of_failed(model, &failed)), None),
    };
    let known = model.node_count() <= MOST_NODES && case.size == Size::Small;
    let newton = Newton { max_factorisations: FACTORISATIONS, ..Newton::default() };
    let equilibrium = if known { newton.refine(model, &folded.state).ok().filter(|e| e.converged) } else { None };
    let saddles = equilibrium.as_ref().map(|equilibrium| equilibrium.escapes);
    let state = equilibrium.map(|equilibrium| equilibrium.state);
    let distance = state.as_ref().map(|state| align(&folded.state.positions, &state.positions).max);
    (Relaxed::Ended { folded: Box::new(folded), distance, saddles }, state)
}
