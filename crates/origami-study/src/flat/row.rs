//! What came of one pattern.

use std::f64::consts::PI;
use std::time::Instant;

use origami_core::measure::{Strain, align};
use origami_core::solve::{Failed, Reflect, unwatched};
use origami_core::{Folded, Model, Relax, Scene, Solver, State};

use super::cases::Case;
use crate::GpuChoice;
use crate::crossings::crossings;
use crate::gpu_choice::OnEither;

/// How far from the flat-folded state a sheet may end, in radii, beside the file's own misfit.
pub(super) const NEAR: f64 = 1e-4;
/// By how much a file may miss itself, in radii.
pub(super) const CLOSED: f64 = 1e-3;
/// The percentage at which two ways are compared.
pub(super) const PART: f64 = 60.0;

/// A pattern with all that was found of it.
pub(super) struct Row {
    pub(super) name: String,
    pub(super) vertices: usize,
    pub(super) result: Result<Found, Missing>,
}

/// Why nothing was found.
pub(super) enum Missing {
    /// It has no flat-folded state.
    NotFlat(String),
    /// There was no time.
    LeftOut,
}

pub(super) struct Found {
    /// How far the exact state misses itself, in radii.
    pub(super) closure: f64,
    /// To 100 % by motion on the processor, and on a GPU where there is one.
    pub(super) ways: Vec<Way>,
    /// To 60 %: the open sheet closed, and the flat-folded one opened.
    pub(super) closed: Way,
    pub(super) opened: Way,
}

/// A run, and where it ended.
pub(super) struct Way {
    pub(super) on: String,
    pub(super) seconds: f64,
    /// The rest, or why there is none.
    pub(super) end: Result<End, String>,
}

pub(super) struct End {
    pub(super) converged: bool,
    /// From the exact state, in radii after the best rigid motion; at 100 % only.
    pub(super) distance: Option<f64>,
    /// Whether that is as near as can be asked for.
    pub(super) arrived: bool,
    /// Largest, of a beam.
    pub(super) strain: f64,
    /// How often its paper goes through itself; none of a very large sheet.
    pub(super) crossings: Option<usize>,
    pub(super) energy: f64,
    /// Creases more than half a turn from their targets: they closed the wrong way.
    pub(super) wrong: usize,
    pub(super) attempts: u32,
    pub(super) evaluations: u64,
}

impl Row {
    pub(super) fn left_out(case: &Case) -> Self {
        Self { name: case.name.clone(), vertices: case.model.node_count(), result: Err(Missing::LeftOut) }
    }

    pub(super) fn found(&self) -> Option<&Found> {
        self.result.as_ref().ok()
    }
}

/// Runs one pattern.
pub(super) fn run(case: &Case, gpu: &GpuChoice) -> Row {
    let result = exact(&case.model).map(|exact| find(&case.model, &exact, gpu));
    let result = result.map_err(|failed| Missing::NotFlat(failed.to_string()));
    Row { result, ..Row::left_out(case) }
}

/// The flat-folded state.
pub(super) fn exact(model: &Model) -> Result<Folded, Failed> {
    Reflect { tolerance: CLOSED }.fold_from_rest(model, 100.0)
}

/// The largest distance of a vertex from where it lies in the exact state, in radii after the best rigid motion.
pub(super) fn distance(exact: &Folded, state: &State) -> f64 {
    align(&state.positions, &exact.state.positions).max
}

/// Whether `state` is the exact one, as far as a tolerance of [`NEAR`] and the file's own misfit allow.
pub(super) fn has_arrived(exact: &Folded, state: &State) -> bool {
    distance(exact, state) <= NEAR + exact.distance
}

fn find(model: &Model, exact: &Folded, gpu: &GpuChoice) -> Found {
    let relax = Relax { tolerance: NEAR, ..Relax::default() };
    let rest = State::at_rest(model);
    let mut ways = vec![way(model, &relax, "processor", &rest, 100.0, Some(exact))];
    if let Some(name) = gpu.name() {
        let solver = gpu.with(OnEither::Relax(relax.clone()));
        ways.push(way(model, solver.as_ref(), &name, &rest, 100.0, Some(exact)));
    }
    Found {
        closure: exact.distance,
        ways,
        closed: way(model, &relax, "closed", &rest, PART, None),
        opened: way(model, &relax, "opened", &exact.state, PART, None),
    }
}

fn way(model: &Model, solver: &dyn Solver, on: &str, start: &State, percent: f64, exact: Option<&Folded>) -> Way {
    let began = Instant::now();
    let folded = solver.fold(model, start, &Scene::percent(percent), &mut unwatched);
    let seconds = began.elapsed().as_secs_f64();
    let end = folded.map_err(|failed| failed.to_string()).map(|folded| {
        let state = &folded.state;
        let off = state.fold_angles.iter().zip(&state.targets).filter(|(angle, target)| (*angle - *target).abs() > PI);
        End {
            converged: folded.converged(),
            distance: exact.map(|exact| distance(exact, state)),
            arrived: exact.is_some_and(|exact| has_arrived(exact, state)),
            strain: Strain::of(model, &state.positions).beams.max,
            crossings: crossings(model, &state.positions),
            energy: state.energy(model).total(),
            wrong: off.count(),
            attempts: folded.attempts,
            evaluations: folded.steps,
        }
    });
    Way { on: on.into(), seconds, end }
}
