//! Folds under contact that the exact test looks at on the way.

use std::num::NonZeroUsize;

use origami_core::contact::{Contact, Crossings};
use origami_core::glam::DVec3;
use origami_core::measure::{Strain, angle_error};
use origami_core::solve::{ContactRelax, Failed, Stop, Touch};
use origami_core::{Folded, Model, Relax, Scene, State};

/// A run ends after so many evaluations.
const MOST_STEPS: u64 = 20_000;
/// Evaluations between two looks of the exact test.
const LOOK: u64 = 10;

/// What came of a fold.
pub(super) struct Watched {
    pub(super) folded: Folded,
    pub(super) touch: Touch,
    /// Of all stages.
    pub(super) evaluations: u64,
    /// At every tenth evaluation and at the end of each stage, added up.
    pub(super) crossings: usize,
    /// Largest of a beam, at the end.
    pub(super) strain: f64,
    /// The largest difference of an angle from its target at the end, in degrees.
    pub(super) off: f64,
}

/// On one thread, so that times can be compared.
pub(super) fn relax() -> Relax {
    Relax { threads: NonZeroUsize::new(1), ..Relax::default() }
}

pub(super) fn solver(perturbation: f64, contact: Contact) -> ContactRelax {
    ContactRelax { relax: Relax { max_steps: MOST_STEPS, perturbation, ..relax() }, contact }
}

/// Folds from rest through `stages`, each from where the last one ended.
pub(super) fn watched(model: &Model, solver: &ContactRelax, stages: &[Scene]) -> Result<Watched, Failed> {
    let (mut solver, mut state) = (solver.clone(), State::at_rest(model));
    let (mut evaluations, mut crossings, mut last) = (0, 0, None);
    for scene in stages {
        let mut look = |evaluation: u64, positions: &[DVec3]| {
            if evaluation.is_multiple_of(LOOK) {
                crossings += Crossings::of(&model.mesh, positions).all.len();
            }
        };
        let (folded, touch) = solver.fold_looking(model, &state, scene, &mut look)?;
        crossings += Crossings::of(&model.mesh, &folded.state.positions).all.len();
        evaluations += folded.steps;
        // The sheet is off every symmetry from its first move on.
        solver.relax.perturbation = 0.0;
        state.clone_from(&folded.state);
        last = Some((folded, touch));
    }
    let (folded, touch) = match last {
        Some(last) => last,
        None => solver.fold_looking(model, &state, &Scene::percent(0.0), &mut |_, _| {})?,
    };
    let strain = Strain::of(model, &folded.state.positions).beams.max;
    let off = angle_error(&folded.state).max;
    Ok(Watched { folded, touch, evaluations, crossings, strain, off })
}

impl Watched {
    pub(super) fn stop(&self) -> &'static str {
        match self.folded.stop {
            Stop::Converged => "converged",
            Stop::Blocked => "blocked",
            _ => "step limit",
        }
    }

    /// The faces that press hardest, in pairs.
    pub(super) fn pressing(&self, most: usize) -> String {
        let pairs = self.touch.pressing.iter().take(most).map(|pressing| {
            let [one, other] = pressing.faces.map(|face| face.0);
            format!("{one} and {other}")
        });
        pairs.collect::<Vec<_>>().join(", ")
    }
}
