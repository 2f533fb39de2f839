//! The narrowed bird base, as a crane begins: its legs after its base.

use origami_core::contact::Crossings;
use origami_core::generate::BirdBase;
use origami_core::glam::{DVec2, DVec3};
use origami_core::measure::Strain;
use origami_core::model::Crease;
use origami_core::scene::{Scene, Targets};
use origami_core::solve::{ContactRelax, State, Stop};

use crate::{model_of, off};

/// With a gap of five thousandths; with the default of one it ends blocked.
#[test]
fn a_narrowed_bird_base_folds_step_by_step() {
    let base = BirdBase::default().pattern().expect("a pattern");
    let pattern = BirdBase { narrowed: true, ..BirdBase::default() }.pattern().expect("a pattern");
    let model = model_of(&pattern);
    // The creases that narrow lie on none of the base's.
    let is_of_base = |crease: &Crease| {
        let Some(edge) = model.mesh.sides[crease.side.index()].edge else { return true };
        let [p, q] = pattern.edges[edge.index()].vertices.map(|v| pattern.vertices[v.index()].truncate());
        base.edges.iter().any(|edge| {
            let [a, b] = edge.vertices.map(|v| base.vertices[v.index()].truncate());
            let between = |p: DVec2| (a.distance(p) + p.distance(b) - a.distance(b)).abs() < 1e-9;
            between(p) && between(q)
        })
    };
    let first = |crease: &Crease| if is_of_base(crease) { crease.full_target } else { 0.0 };
    let targets: Vec<f64> = model.creases.iter().map(first).collect();
    let both = model.creases.iter().zip(&targets);
    let narrowing = both.filter(|(crease, target)| crease.full_target != **target).count();
    assert!(narrowing >= 8 && narrowing < targets.len() / 2, "{narrowing} of {}", targets.len());
    let (mut state, mut solver) = (State::at_rest(&model), ContactRelax::default());
    solver.contact.gap = 5e-3;
    for scene in [Scene::new(Targets::angles(targets)), Scene::percent(100.0)] {
        let mut look = |evaluation: u64, positions: &[DVec3]| {
            let crossings = Crossings::of(&model.mesh, positions);
            assert!(crossings.is_empty(), "evaluation {evaluation}: {crossings:?}");
        };
        let (folded, touch) = solver.fold_looking(&model, &state, &scene, &mut look).expect("it folds");
        let strain = Strain::of(&model, &folded.state.positions).beams.max;
        assert_eq!(folded.stop, Stop::Converged, "{touch:?}");
        assert!(strain <= 0.06 && off(&folded) < 10.0, "{strain}, {} degrees off", off(&folded));
        state = folded.state;
        solver.relax.perturbation = 0.0;
    }
}
