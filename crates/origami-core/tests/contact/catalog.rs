//! All patterns: nothing goes through anything, and what touches nothing is not changed.

use std::ops::ControlFlow;

use origami_core::Solver;
use origami_core::contact::Crossings;
use origami_core::generate::catalog;
use origami_core::glam::DVec3;
use origami_core::measure::align;
use origami_core::scene::{Scene, Targets};
use origami_core::solve::{ContactRelax, Relax, State, Stop, Touching, unwatched};

use crate::{model, off, watched};

#[test]
fn nothing_crosses_on_the_way_to_flat() {
    let mut touched = 0;
    for (name, most_off) in
        [("bird-base", 1.5), ("strip", 1.5), ("square-twist", 2.5), ("miura", 2.5), ("kresling", 1.5)]
    {
        let model = model(name);
        let (folded, touch, crossed) = watched(&model, &ContactRelax::default(), &Scene::percent(100.0));
        assert_eq!(crossed, 0, "{name}");
        assert_eq!(folded.stop, Stop::Converged, "{name}: {touch:?}");
        assert!(off(&folded) < most_off, "{name}: {} degrees off", off(&folded));
        assert!(touch.least_gap > 0.0, "{name}");
        touched += usize::from(touch.least_gap.is_finite());
        // The same sheet without contact, to see that there is something to be prevented.
        let free = Relax::default().fold_from_rest(&model, 100.0).expect("it folds");
        assert!(folded.steps < 8 * free.steps, "{name}: {} evaluations, {} without", folded.steps, free.steps);
    }
    assert!(touched >= 4, "layers touch in {touched} patterns");
}

/// The prototype's fuzz: random targets on random patterns, in random order; `runs` of them.
fn fuzz(runs: u64) -> usize {
    let mut state = 11_u64;
    let mut next = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(state >> 33).expect("31 bits")) / f64::from(1_u32 << 31)
    };
    let names = ["bird-base", "square-twist", "waterbomb-vertex", "kresling", "strip", "degree-4"];
    let models = names.map(model);
    let mut crossed_without = 0;
    for run in 0..runs {
        #[expect(clippy::cast_possible_truncation, reason = "a few")]
        let model = &models[run as usize % models.len()];
        let targets: Vec<f64> = model.creases.iter().map(|_| (2.0 * next() - 1.0) * std::f64::consts::PI).collect();
        let scene = Scene::new(Targets::angles(targets));
        let gap = 10.0_f64.powf(-2.0 - 1.5 * next());
        let relax = Relax { ramp: Some(200), steps: Some(500), ..Relax::default() };
        let mut solver = ContactRelax { relax, ..ContactRelax::default() };
        solver.contact.gap = gap;
        let (folded, touch, crossed) = watched(model, &solver, &scene);
        assert_eq!(crossed, 0, "run {run}, gap {gap}");
        assert!(folded.state.positions.iter().all(|p| p.is_finite()) && touch.least_gap > 0.0, "run {run}");
        let free = Relax { retry: false, ..solver.relax.clone() };
        let free = free.fold(model, &State::at_rest(model), &scene, &mut |_| ControlFlow::Continue(()));
        crossed_without += usize::from(free.is_ok_and(|f| !Crossings::of(&model.mesh, &f.state.positions).is_empty()));
    }
    crossed_without
}

#[test]
fn random_folds_do_not_cross() {
    let without = fuzz(12);
    assert!(without >= 3, "only {without} cross without contact: this shows little");
}

#[test]
#[ignore = "seconds: a thousand runs"]
fn a_thousand_random_folds_do_not_cross() {
    assert!(fuzz(1000) > 200);
}

#[test]
#[ignore = "seconds: all patterns, percentages and perturbations"]
fn nothing_crosses_in_any_pattern() {
    for name in catalog::names() {
        let model = model(name);
        for percent in [60.0, 90.0, 99.0, 100.0] {
            for perturbation in [1e-2, 5e-3, 2e-3] {
                let relax = Relax { perturbation, max_steps: 8000, ..Relax::default() };
                let solver = ContactRelax { relax, ..ContactRelax::default() };
                let (folded, touch, crossed) = watched(&model, &solver, &Scene::percent(percent));
                assert_eq!(crossed, 0, "{name} at {percent} %, {perturbation}");
                assert!(matches!(folded.stop, Stop::Converged | Stop::Blocked | Stop::StepLimit), "{name}: {touch:?}");
            }
        }
    }
}

/// The same method on the same sheet, but for what contact adds, which is nothing.
#[test]
fn where_nothing_touches_nothing_is_changed() {
    for (name, percent) in [("miura", 60.0), ("degree-4", 70.0), ("hypar", 100.0)] {
        let model = model(name);
        let scene = Scene::percent(percent);
        let relax = Relax { softening: None, near: 0.0, steps: Some(4000), ..Relax::default() };
        let free = relax.fold(&model, &State::at_rest(&model), &scene, &mut |_| ControlFlow::Continue(()));
        let free = free.expect("it folds").state.positions;
        let solver = ContactRelax { relax, ..ContactRelax::default() };
        let held = solver.fold_touching(&model, &State::at_rest(&model), &scene, &mut unwatched);
        let (held, touch) = held.expect("it folds");
        assert_eq!((touch.limited, touch.least_gap), (0, f64::INFINITY), "{name}");
        let apart = |from: &[DVec3]| align(&held.state.positions, from).max;
        assert!(apart(&model.rest) > 0.1, "{name} moves");
        assert!(apart(&free) < 1e-12, "{name}: {:e}", apart(&free));
    }
}

#[test]
fn where_nothing_touches_the_state_is_the_same() {
    for (name, percent) in [("miura", 60.0), ("degree-4", 70.0), ("hypar", 100.0)] {
        let model = model(name);
        let scene = Scene::percent(percent);
        let relax = Relax { softening: None, tolerance: 1e-7, ..Relax::default() };
        let solver = ContactRelax { relax: relax.clone(), ..ContactRelax::default() };
        let (with, touch, crossed) = watched(&model, &solver, &scene);
        let without =
            relax.fold(&model, &State::at_rest(&model), &scene, &mut |_| ControlFlow::Continue(())).expect("folds");
        assert_eq!((touch.limited, crossed), (0, 0), "{name}");
        let apart = with.state.positions.iter().zip(&without.state.positions).map(|(a, b)| (*a - *b).length());
        let apart = apart.fold(0.0, f64::max);
        assert!(apart < 1e-5, "{name}: {apart}");
        assert!(with.steps as f64 <= 1.3 * without.steps as f64, "{name}: {} and {}", with.steps, without.steps);
    }
}
