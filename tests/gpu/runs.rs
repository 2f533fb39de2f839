//! How a run is told of, and how it goes wrong.

use std::ops::ControlFlow;

use origami::scene::Scene;
use origami::solve::unwatched;
use origami::solve::{Failed, Integrator, TimeStep};
use origami::{Dynamics, Model, Solver};

use crate::common::gpu::gpu;
use crate::sheets::{WAYS, apart, relax, sheet, start};

#[test]
fn progress_is_told_in_order() {
    let Some(gpu) = gpu() else { return };
    let model = sheet("miura");
    let mut told = Vec::new();
    let solver = gpu.with(relax());
    let folded = solver
        .fold(&model, &start(&model), &Scene::percent(50.0), &mut |progress| {
            told.push(progress);
            ControlFlow::Continue(())
        })
        .expect("it holds");
    assert!(told.len() > 5, "{} reports", told.len());
    assert!(told.windows(2).all(|pair| pair[0].step <= pair[1].step && pair[0].ramp <= pair[1].ramp));
    assert!(told[0].distance.is_infinite() && told[0].ramp < 0.5);
    let last = told[told.len() - 1];
    assert!(last.step <= folded.steps && last.ramp == 1.0 && last.distance < 1e-4, "{last:?}");
}

fn diverged(solver: &dyn Solver, model: &Model) -> origami::solve::Diverged {
    let failed =
        solver.fold(model, &start(model), &Scene::percent(60.0), &mut unwatched).expect_err("the step is too long");
    let Failed::Diverged(diverged) = failed else { panic!("{failed}") };
    diverged
}

#[test]
fn steps_that_are_too_long_diverge_as_on_the_processor() {
    let Some(gpu) = gpu() else { return };
    let model = sheet("miura");
    for (integrator, step) in [(Integrator::Euler, 0.25), (Integrator::Euler, 5.0), (Integrator::Verlet, 0.3)] {
        for dispatch in WAYS.iter().copied() {
            let method = Dynamics { integrator, time_step: TimeStep::Fixed(step), ..Dynamics::default() };
            let (theirs, ours) = (diverged(&method, &model), diverged(&gpu.with(method).dispatch(dispatch), &model));
            println!("{integrator:?}, {step}: {ours} and {theirs}");
            assert_eq!((ours.vertex, ours.step, ours.quantity), (theirs.vertex, theirs.step, theirs.quantity));
            assert!((ours.value / theirs.value - 1.0).abs() < 1e-2, "{} is not {}", ours.value, theirs.value);
            assert_eq!(ours.last_good_step, theirs.last_good_step);
            assert!(apart(&ours.last_good, &theirs.last_good) < 1e-3, "the last good state");
            assert!(ours.last_good.positions.iter().all(|p| p.length() < 2.0));
        }
    }
}

#[test]
fn a_step_that_is_no_number_is_refused_by_its_name() {
    let Some(gpu) = gpu() else { return };
    let model = sheet("miura");
    for dispatch in WAYS.iter().copied() {
        let method = Dynamics { time_step: TimeStep::Fixed(f64::NAN), ..Dynamics::default() };
        let solver = gpu.with(method).dispatch(dispatch);
        let failed = solver.fold(&model, &start(&model), &Scene::percent(60.0), &mut unwatched).expect_err("refused");
        assert!(
            matches!(failed, Failed::Refused { .. }) && failed.to_string().starts_with("time step: NaN"),
            "{failed}"
        );
    }
}
