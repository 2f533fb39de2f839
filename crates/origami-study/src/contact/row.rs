//! One pattern at one percentage, freely and under contact.

use std::time::Instant;

use origami_core::contact::Crossings;
use origami_core::measure::{Strain, angle_error};
use origami_core::solve::{ContactRelax, Touch, Touching, unwatched};
use origami_core::{Folded, Model, Relax, Scene, Solver, State};

/// Under contact a run ends after so many evaluations.
const MOST_STEPS: u64 = 20_000;
/// Evaluations between two looks of the exact test.
const LOOK: u64 = 10;

/// What came of it.
pub(super) struct Row {
    pub(super) name: String,
    pub(super) vertices: usize,
    pub(super) triangles: usize,
    pub(super) percent: f64,
    pub(super) free: Result<Way, String>,
    pub(super) contact: Result<(Way, Held), String>,
}

/// A run.
pub(super) struct Way {
    pub(super) evaluations: u64,
    /// Microseconds of one evaluation, on one thread.
    pub(super) micros: f64,
    /// At its end, and of contact on the way too.
    pub(super) crossings: usize,
    /// The depth of the deepest at its end, in radii.
    pub(super) deepest: f64,
    /// The largest difference of an angle from its target, in degrees.
    pub(super) off: f64,
    /// Largest, of a beam.
    pub(super) strain: f64,
}

/// What contact did.
pub(super) struct Held {
    pub(super) stop: &'static str,
    pub(super) touch: Touch,
}

pub(super) fn run(name: &str, model: &Model, percent: f64) -> Row {
    let (start, scene) = (State::at_rest(model), Scene::percent(percent));
    let relax = Relax { threads: std::num::NonZeroUsize::new(1), ..Relax::default() };
    let began = Instant::now();
    let free = relax.fold(model, &start, &scene, &mut unwatched);
    let seconds = began.elapsed().as_secs_f64();
    let free = free.map(|folded| way(model, &folded, seconds, 0)).map_err(|failed| failed.to_string());

    let relax = Relax { max_steps: MOST_STEPS, ..relax };
    let solver = ContactRelax { relax, ..ContactRelax::default() };
    let began = Instant::now();
    let timed = solver.fold_touching(model, &start, &scene, &mut unwatched);
    let seconds = began.elapsed().as_secs_f64();
    // Once more, looked at: looking takes longer than folding.
    let mut crossed = 0;
    let mut look = |evaluation: u64, positions: &[origami_core::glam::DVec3]| {
        if evaluation.is_multiple_of(LOOK) {
            crossed += Crossings::of(&model.mesh, positions).all.len();
        }
    };
    let looked = solver.fold_looking(model, &start, &scene, &mut look);
    let contact = timed.and(looked).map_err(|failed| failed.to_string()).map(|(folded, touch)| {
        let stop = match folded.stop {
            origami_core::solve::Stop::Converged => "converged",
            origami_core::solve::Stop::Blocked => "blocked",
            _ => "step limit",
        };
        (way(model, &folded, seconds, crossed), Held { stop, touch })
    });
    Row {
        name: name.to_owned(),
        vertices: model.node_count(),
        triangles: model.mesh.triangles.len(),
        percent,
        free,
        contact,
    }
}

fn way(model: &Model, folded: &Folded, seconds: f64, on_the_way: usize) -> Way {
    let crossings = Crossings::of(&model.mesh, &folded.state.positions);
    Way {
        evaluations: folded.steps,
        micros: 1e6 * seconds / folded.steps.max(1) as f64,
        crossings: on_the_way + crossings.all.len(),
        deepest: crossings.deepest(),
        off: angle_error(&folded.state).max,
        strain: Strain::of(model, &folded.state.positions).beams.max,
    }
}
