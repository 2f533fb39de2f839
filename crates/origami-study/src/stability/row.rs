//! What is asked of one scene.

use std::panic::{AssertUnwindSafe, catch_unwind};

use origami_core::measure::align;
use origami_core::solve::{Failed, Integrator, TimeStep, time_step};
use origami_core::{Dynamics, Folded, Model, Newton, Relax, Solver, State};

use super::in_32_bits::OnGpu;
use super::limit::{Effort, largest};
use super::motion::{self, Held, Motion};
use super::scenes::{Scene, Size};

/// Factorisations that the reference may take.
const FACTORISATIONS: u32 = 300;
/// Nodes above which no reference is sought.
const MOST_NODES: usize = 3000;

/// How much is run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Budget {
    /// Steps of each motion.
    pub(super) steps: u64,
    /// Of a large sheet.
    pub(super) steps_of_large: u64,
    /// Evaluations of a relaxation.
    pub(super) relaxation: u64,
    /// Of a large sheet: too few to arrive.
    pub(super) relaxation_of_large: u64,
    /// For the largest step that holds.
    pub(super) effort: Effort,
    /// Of a large sheet.
    pub(super) effort_of_large: Effort,
}

impl Budget {
    pub(super) fn new(quick: bool) -> Self {
        let small = Self {
            steps: 400,
            steps_of_large: 50,
            relaxation: 20_000,
            relaxation_of_large: 60,
            effort: Effort { half: 150, precision: 0.02 },
            effort_of_large: Effort { half: 25, precision: 0.1 },
        };
        let whole = Self { steps: 3000, relaxation: 100_000, effort: Effort { half: 400, precision: 0.005 }, ..small };
        if quick { small } else { whole }
    }

    /// Steps of a motion and evaluations of a relaxation.
    pub(super) fn of(self, size: Size) -> (u64, u64) {
        match size {
            Size::Small => (self.steps, self.relaxation),
            Size::Large => (self.steps_of_large, self.relaxation_of_large),
        }
    }
}

/// A bound and the largest step that was seen to hold, in units of model time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limit {
    pub(super) bound: f64,
    pub(super) largest: Option<f64>,
}

impl Limit {
    /// The bound as a share of the largest step that holds: at most 1 if it is one.
    pub(super) fn ratio(self) -> Option<f64> {
        self.largest.map(|largest| self.bound / largest)
    }

    fn find(model: &Model, state: &State, integrator: Integrator, effort: Effort) -> Self {
        let bound = time_step::safe(model, &state.positions, integrator) / time_step::SAFE_SHARE;
        Self { bound, largest: largest(model, state, integrator, bound, effort) }
    }
}

/// Where a relaxation ended.
#[derive(Clone, Debug)]
pub(super) enum Relaxed {
    /// Somewhere.
    Ended {
        /// It.
        folded: Box<Folded>,
        /// Its largest distance, in radii, from the equilibrium that Newton's method refines it to; where that was found.
        distance: Option<f64>,
        /// How many saddles Newton's method left on its way there.
        saddles: Option<u32>,
    },
    /// Nowhere.
    Failed(Held),
}

impl Relaxed {
    pub(super) fn folded(&self) -> Option<&Folded> {
        match self {
            Self::Ended { folded, .. } => Some(folded),
            Self::Failed(_) => None,
        }
    }

    pub(super) fn converged(&self) -> bool {
        self.folded().is_some_and(Folded::converged)
    }

    /// Whether it said rightly that it is within the tolerance; `None` where it did not say so or nobody knows.
    pub(super) fn claim_is_true(&self) -> Option<bool> {
        match self {
            Self::Ended { distance: Some(distance), folded, .. } if folded.converged() => {
                Some(*distance <= Relax::default().tolerance)
            }
            _ => None,
        }
    }
}

/// What was found of a scene.
#[derive(Clone, Debug)]
pub(super) struct Found {
    pub(super) model: Model,
    pub(super) paper_step: f64,
    pub(super) paper: Held,
    pub(super) safe: Held,
    pub(super) safe_verlet: Held,
    /// Where the safe step of Euler led.
    pub(super) end: Option<State>,
    pub(super) at_rest: Limit,
    /// With Verlet; of a small sheet.
    pub(super) verlet: Option<Limit>,
    /// About the folded equilibrium, where it is known.
    pub(super) folded: Option<Limit>,
    pub(super) relaxed: Relaxed,
    /// What Newton's method refined that to.
    pub(super) equilibrium: Option<State>,
}

/// A scene with all that was found of it.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) scene: Scene,
    pub(super) answer: Answer,
    /// The same in 32 bits, where there is a GPU.
    pub(super) gpu: Option<OnGpu>,
}

impl Row {
    /// What was found, if it was run.
    pub(super) fn found(&self) -> Option<&Found> {
        match &self.answer {
            Answer::Found(found) => Some(found),
            _ => None,
        }
    }
}

/// What becomes of a scene.
#[derive(Clone, Debug)]
pub(super) enum Answer {
    /// It was run.
    Found(Box<Found>),
    /// The scene makes no model, and an error says why.
    Refused(String),
    /// Something panicked.
    Panicked(String),
    /// There was no time.
    LeftOut,
}

/// Runs a scene.
pub(super) fn answer(scene: &Scene, budget: Budget) -> Answer {
    let pattern = scene.pattern.as_ref().map_err(ToString::to_string);
    match pattern.and_then(|pattern| Model::new(pattern, &scene.material).map_err(|error| error.to_string())) {
        Err(error) => Answer::Refused(error),
        Ok(model) => {
            unpanicked(|| Answer::Found(Box::new(find(scene, model, budget)))).unwrap_or_else(Answer::Panicked)
        }
    }
}

/// What `run` gives, or what it panicked with: a panic ends a row, and not the study.
pub(super) fn unpanicked<T>(run: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(run)).map_err(|panic| {
        let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
        text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default()
    })
}

fn find(scene: &Scene, model: Model, budget: Budget) -> Found {
    let (steps, _) = budget.of(scene.size);
    let run = |time_step, integrator| {
        let solver = motion::piece(Dynamics { time_step, integrator, ..Dynamics::default() }, steps);
        let each = steps / motion::PIECES;
        Motion { solver: &solver, integrator, each, rounding: motion::ROUNDING }.run(&model, &scene.path)
    };
    let effort = if scene.size == Size::Small { budget.effort } else { budget.effort_of_large };
    let at_rest = State::at_rest(&model);
    let limit = |state: &State, integrator| Limit::find(&model, state, integrator, effort);
    let (safe, end) = run(TimeStep::Safe, Integrator::Euler);
    let (relaxed, equilibrium) = relax(scene, &model, budget);
    Found {
        paper_step: time_step::paper(&model),
        paper: run(TimeStep::Paper, Integrator::Euler).0,
        safe,
        safe_verlet: run(TimeStep::Safe, Integrator::Verlet).0,
        end,
        at_rest: limit(&at_rest, Integrator::Euler),
        verlet: (scene.size == Size::Small).then(|| limit(&at_rest, Integrator::Verlet)),
        folded: equilibrium.as_ref().map(|state| limit(state, Integrator::Euler)),
        relaxed,
        equilibrium,
        model,
    }
}

/// From rest along the scene's path; a target that jumps does so without a ramp.
pub(super) fn follow(
    scene: &Scene,
    model: &Model,
    budget: Budget,
    fold: impl Fn(&Relax) -> Box<dyn Solver>,
) -> Result<Folded, Failed> {
    let (_, max_steps) = budget.of(scene.size);
    let ramp = (scene.path.len() > 1).then_some(0);
    let solver = fold(&Relax { max_steps, ramp, ..Relax::default() });
    let mut folded = None;
    let mut state = State::at_rest(model);
    for percent in &scene.path {
        let reached = solver.fold(model, &state, *percent, &mut |_| {})?;
        state.clone_from(&reached.state);
        folded = Some(reached);
    }
    Ok(folded.expect("every scene is sent somewhere"))
}

fn relax(scene: &Scene, model: &Model, budget: Budget) -> (Relaxed, Option<State>) {
    let folded = match follow(scene, model, budget, |relax| Box::new(relax.clone())) {
        Ok(folded) if motion::is_finite(&folded.state) => folded,
        Ok(_) => return (Relaxed::Failed(Held::Wrong("not finite".into())), None),
        Err(failed) => return (Relaxed::Failed(Held::of_failed(model, &failed)), None),
    };
    let known = model.node_count() <= MOST_NODES && scene.size == Size::Small;
    let newton = Newton { max_factorisations: FACTORISATIONS, ..Newton::default() };
    let equilibrium = if known { newton.refine(model, &folded.state).ok().filter(|e| e.converged) } else { None };
    let saddles = equilibrium.as_ref().map(|equilibrium| equilibrium.escapes);
    let state = equilibrium.map(|equilibrium| equilibrium.state);
    let distance = state.as_ref().map(|state| align(&folded.state.positions, &state.positions).max);
    (Relaxed::Ended { folded: Box::new(folded), distance, saddles }, state)
}
