//! `converged` is a claim about distance, and is held against a solution a million times tighter.

mod common;

use common::{fold, made, model};
use origami::generate::{self, CurvedPleat, Hypar, catalog};
use origami::measure::align;
use origami::model::Softening;
use origami::scene::Scene;
use origami::solve::{Stop, TimeStep, default_ramp, unwatched};
use origami::{Dynamics, Folded, Relax, Solver};

#[test]
fn converged_states_are_within_the_tolerance() {
    let (mut claims, mut kept, mut runs) = (0, 0, 0);
    for name in catalog::names() {
        let model = made(name);
        for percent in [60.0, 100.0] {
            runs += 1;
            let claim = fold(&model, &Relax::default(), percent);
            if !claim.converged() {
                continue;
            }
            claims += 1;
            let tight = fold(&model, &Relax { tolerance: 1e-10, ..Relax::default() }, percent);
            let distance = align(&claim.state.positions, &tight.state.positions).max;
            kept += usize::from(distance < 1e-4);
            assert!(distance < 3e-4, "{name} at {percent} %: {distance}");
        }
    }
    assert!(claims >= runs - 1, "{claims} of {runs} converged");
    assert!(kept >= claims - 1, "{kept} of {claims} claims hold");
}

#[test]
fn symmetric_sheets_leave_their_saddles() {
    let mut left = 0;
    for (name, percent) in [("curved-pleat", 60.0), ("curved-pleat", 100.0), ("fan", 60.0), ("fan", 100.0)] {
        let model = made(name);
        let symmetric = fold(&model, &Relax { perturbation: 0.0, saddle_search: 0.0, ..Relax::default() }, percent);
        let perturbed = fold(&model, &Relax::default(), percent);
        let [symmetric, perturbed] = [symmetric, perturbed].map(|folded| folded.state.energy(&model).total());
        assert!(perturbed < 1.000_001 * symmetric, "{name} at {percent} %: {perturbed} is above {symmetric}");
        left += usize::from(perturbed < 0.9 * symmetric);
    }
    assert!(left > 0, "rounding alone leaves them all: the test has lost its scenes");
}

#[test]
fn a_finely_cut_curved_crease_is_not_said_to_rest_on_its_saddle() {
    let model = model(&CurvedPleat { segments: 72, ..CurvedPleat::default() }.pattern().expect("valid"));
    let symmetric = fold(&model, &Relax { perturbation: 0.0, ..Relax::default() }, 60.0);
    let claim = fold(&model, &Relax::default(), 60.0);
    let tight = fold(&model, &Relax { tolerance: 1e-8, ..Relax::default() }, 60.0);
    let distance = |a: &Folded, b: &Folded| align(&a.state.positions, &b.state.positions).max;
    assert!(symmetric.converged() && distance(&symmetric, &tight) > 0.1, "there is no saddle to rest on");
    assert!(claim.converged() && distance(&claim, &tight) < 1e-4);
}

#[test]
fn a_tighter_tolerance_goes_on_along_the_same_way() {
    let model = made("waterbomb");
    let loose = fold(&model, &Relax::default(), 60.0);
    let repeated = Relax { steps: Some(loose.steps), ..Relax::default() };
    let tight = Relax { tolerance: 1e-9, ..Relax::default() };
    assert!(fold(&model, &tight, 60.0).steps > loose.steps);
    // The last evaluation of a converged run moves nothing; that of a counted one does.
    let on_the_way = fold(&model, &Relax { steps: Some(loose.steps - 1), ..repeated }, 60.0);
    assert_eq!(on_the_way.state, loose.state);
}

#[test]
fn too_few_steps_are_no_convergence() {
    let model = made("miura");
    let folded = fold(&model, &Relax { max_steps: 100, ..Relax::default() }, 60.0);
    assert_eq!((folded.stop, folded.steps), (Stop::StepLimit, 100));
    let folded = fold(&model, &Dynamics { max_steps: 100, ..Dynamics::default() }, 60.0);
    assert_eq!((folded.stop, folded.steps), (Stop::StepLimit, 100));
    assert_eq!(folded.state.targets, model.targets(60.0), "energy and angles are held against what was asked");
    let folded = fold(&model, &Relax { steps: Some(1234), ..Relax::default() }, 60.0);
    assert_eq!((folded.stop, folded.steps), (Stop::StepsDone, 1234));
}

#[test]
fn a_jump_takes_a_fortieth_of_the_evaluations_of_the_papers_scheme() {
    let model = model(&generate::miura(10, 10).expect("valid"));
    let exact = fold(&model, &Relax { tolerance: 1e-10, ramp: Some(0), ..Relax::default() }, 60.0).state;
    let jump = fold(&model, &Relax { ramp: Some(0), ..Relax::default() }, 60.0);
    assert!(jump.converged() && jump.steps <= 300, "{} evaluations", jump.steps);
    assert!(align(&jump.state.positions, &exact.positions).max < 1e-4);

    let paper = fold(&model, &Dynamics { steps: Some(10_000), ..Dynamics::default() }, 60.0);
    let distance = align(&paper.state.positions, &exact.positions).max;
    assert!(distance > 1e-4, "after 10 000 steps the paper's scheme is {distance} away");
}

#[test]
fn relaxation_ends_no_higher_than_the_papers_scheme() {
    for name in catalog::names() {
        let model = made(name);
        for percent in [60.0, 100.0] {
            let relaxed = fold(&model, &Relax::default(), percent).state.energy(&model).total();
            let paper = Dynamics { ramp: 1000, steps: Some(3000), time_step: TimeStep::Safe, ..Dynamics::default() };
            let paper = fold(&model, &paper, percent).state.energy(&model).total();
            assert!(relaxed <= 1.001 * paper + 1e-9, "{name} at {percent} %: {relaxed} is above {paper}");
        }
    }
}

#[test]
fn a_tangled_state_is_folded_again_and_the_lower_energy_kept() {
    let model = made("crane");
    // As stiff as its material all the way: softened, it does not tangle.
    let stiff = Relax { softening: None, ..Relax::default() };
    let once = fold(&model, &Relax { retry: false, ..stiff.clone() }, 100.0);
    let again = fold(&model, &stiff, 100.0);
    assert!(once.state.lost_creases() > 0 && once.attempts == 1);
    assert!(again.attempts > 1 && again.steps > once.steps);
    assert!(again.state.energy(&model).total() < once.state.energy(&model).total());
    let soft = fold(&model, &Relax::default(), 100.0);
    assert!(soft.attempts == 1 && soft.state.lost_creases() == 0);
    assert!(
        soft.state.energy(&model).total() <= 1.001 * again.state.energy(&model).total() + 1e-6,
        "both flat, or softly lower"
    );
}

#[test]
fn the_default_ramp_grows_with_the_root_of_the_size() {
    let ramp = |n: usize| default_ramp(&model(&generate::miura(n, n).expect("valid")));
    assert_eq!(ramp(7), 400);
    let (small, large) = (f64::from(ramp(40)), f64::from(ramp(81)));
    assert!((large / small - 2.0).abs() < 0.01, "{small} and {large}");
    let hypar = |rings: usize| default_ramp(&model(&Hypar { rings, ..Hypar::default() }.pattern().expect("valid")));
    assert_eq!([hypar(8), hypar(70)], [400, 400], "281 nodes, and no crease that shall lie flat");
}

#[test]
fn nothing_of_the_softness_is_left_at_the_end() {
    for name in ["miura", "bird-base", "square-twist"] {
        let model = made(name);
        let soft = fold(&model, &Relax::default(), 60.0);
        assert!(soft.converged());
        // Asked to stay where it is by the material itself, it does.
        let stay = Relax { softening: None, tolerance: 1e-7, perturbation: 0.0, ..Relax::default() };
        let stayed = stay.fold(&model, &soft.state, &Scene::percent(60.0), &mut unwatched).expect("holds");
        let moved = align(&stayed.state.positions, &soft.state.positions).max;
        assert!(moved < 1e-4, "{name} moves by {moved}");
        assert!(soft.residual < 1e-3, "{name}: a force of {}", soft.residual);
        // The soft sheet is another one on the way.
        let way = |softening| fold(&model, &Relax { softening, steps: Some(350), ..Relax::default() }, 60.0).state;
        let apart = align(&way(None).positions, &way(Some(Softening::default())).positions).max;
        assert!(apart > 1e-3, "{name}: apart by {apart}");
    }
}

#[test]
fn states_along_the_way_are_settled_each() {
    let model = made("square-twist");
    let percents = origami::solve::frame_percents(80.0, 4);
    assert_eq!(percents, [0.0, 20.0, 40.0, 60.0, 80.0]);
    let states =
        origami::solve::fold_path(
            &model,
            &Relax::default(),
            &percents,
            &mut |_, _| std::ops::ControlFlow::Continue(()),
        )
        .expect("holds");
    for (state, percent) in states.iter().zip(percents) {
        assert!(state.converged());
        assert_eq!(state.percent(), Some(percent));
        let direct = fold(&model, &Relax { tolerance: 1e-8, ..Relax::default() }, percent);
        assert!(align(&state.state.positions, &direct.state.positions).max < 1e-4);
    }
}
