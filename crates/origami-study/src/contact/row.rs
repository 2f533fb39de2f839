//! One pattern at one percentage, freely and under contact.

use std::time::Instant;

use origami_core::contact::{Contact, Crossings};
use origami_core::measure::angle_error;
use origami_core::solve::{Failed, Touching, unwatched};
use origami_core::{Model, Relax, Scene, Solver, State};

use super::watched::{Watched, relax, solver, watched};

/// What came of it.
pub(super) struct Row {
    pub(super) name: String,
    pub(super) vertices: usize,
    pub(super) triangles: usize,
    pub(super) percent: f64,
    /// How far each node was moved at the start, as a share of its shortest beam.
    pub(super) perturbation: f64,
    pub(super) free: Result<Free, Failed>,
    pub(super) contact: Result<Held, Failed>,
}

/// Without contact.
pub(super) struct Free {
    pub(super) evaluations: u64,
    /// Microseconds of one evaluation, on one thread.
    pub(super) micros: f64,
    /// At the end.
    pub(super) crossings: usize,
    /// The depth of the deepest of them, in radii.
    pub(super) deepest: f64,
    /// The largest difference of an angle from its target, in degrees.
    pub(super) off: f64,
}

/// With contact.
pub(super) struct Held {
    pub(super) came: Watched,
    pub(super) micros: f64,
}

impl Row {
    /// Both, where both came to an end.
    pub(super) fn both(&self) -> Option<(&Free, &Held)> {
        Some((self.free.as_ref().ok()?, self.contact.as_ref().ok()?))
    }

    /// How many times as many evaluations contact takes.
    pub(super) fn times(&self) -> Option<f64> {
        self.both().map(|(free, held)| held.came.evaluations as f64 / free.evaluations as f64)
    }

    /// How many times as long an evaluation takes.
    pub(super) fn cost(&self) -> Option<f64> {
        self.both().map(|(free, held)| held.micros / free.micros)
    }

    /// Whether layers press at the end.
    pub(super) fn touches(&self) -> bool {
        self.contact.as_ref().is_ok_and(|held| held.came.touch.least_gap.is_finite())
    }
}

pub(super) fn run(name: &str, model: &Model, percent: f64, perturbation: f64) -> Row {
    let (start, scene) = (State::at_rest(model), Scene::percent(percent));
    let freely = Relax { perturbation, ..relax() };
    let (free, seconds) = timed(|| freely.fold(model, &start, &scene, &mut unwatched));
    let free = free.map(|folded| {
        let crossings = Crossings::of(&model.mesh, &folded.state.positions);
        Free {
            evaluations: folded.steps,
            micros: micros(seconds, folded.steps),
            crossings: crossings.all.len(),
            deepest: crossings.deepest(),
            off: angle_error(&folded.state).max,
        }
    });
    // Twice: looking takes longer than folding.
    let solver = solver(perturbation, Contact::default());
    let (unseen, seconds) = timed(|| solver.fold_touching(model, &start, &scene, &mut unwatched));
    let contact = unseen.and_then(|(unseen, _)| {
        let came = watched(model, &solver, &[scene])?;
        Ok(Held { came, micros: micros(seconds, unseen.steps) })
    });
    let (vertices, triangles) = (model.node_count(), model.mesh.triangles.len());
    Row { name: name.to_owned(), vertices, triangles, percent, perturbation, free, contact }
}

fn timed<T>(run: impl FnOnce() -> T) -> (T, f64) {
    let began = Instant::now();
    let came = run();
    (came, began.elapsed().as_secs_f64())
}

fn micros(seconds: f64, evaluations: u64) -> f64 {
    1e6 * seconds / evaluations.max(1) as f64
}
