//! What a relaxation comes to.

use std::ops::ControlFlow;

use origami::glam::DVec3;
use origami::gpu::Dispatch;
use origami::scene::Scene;
use origami::solve::fold_path;
use origami::solve::unwatched;
use origami::{Dynamics, Relax, Solver, State};

use crate::common::gpu::gpu;
use crate::sheets::{ENERGY, EQUILIBRIUM, WAYS, apart, folded, relax, sheet, sheets, start};

#[test]
fn equilibria_are_those_of_the_processor() {
    let Some(gpu) = gpu() else { return };
    for (i, (name, model)) in sheets().into_iter().enumerate() {
        let method = relax();
        let dispatch = if i % 3 == 0 { Dispatch::Passes } else { Dispatch::Workgroup };
        let theirs = folded(&method, &model, 50.0);
        let ours = folded(&gpu.with(method).dispatch(dispatch), &model, 50.0);
        let blocks = folded(&gpu.with(relax()).dispatch(Dispatch::Blocks), &model, 50.0);
        let other = apart(&blocks.state, &theirs.state);
        assert!(blocks.stop == theirs.stop && other < EQUILIBRIUM, "{name}, by blocks: {other} radii apart");
        let far = apart(&ours.state, &theirs.state);
        let energies = [&ours, &theirs].map(|folded| folded.state.energy(&model).total());
        let released = State { targets: model.targets(50.0), ..start(&model) }.energy(&model).total();
        println!("{name}: {far:.1e} radii apart, {} and {} evaluations, {energies:?}", ours.steps, theirs.steps);
        assert_eq!(ours.stop, theirs.stop, "{name}");
        assert!(far < EQUILIBRIUM, "{name}: {far} radii apart");
        assert!((energies[0] - energies[1]).abs() < ENERGY * released + 1e-9, "{name}: energies {energies:?}");
        assert_eq!(ours.state.velocities, vec![DVec3::ZERO; model.node_count()]);
        assert_eq!(ours.state.targets, theirs.state.targets);
    }
    let (miura, near) = (sheet("miura"), relax());
    let far = apart(&folded(&near, &miura, 50.0).state, &folded(&near, &miura, 50.5).state);
    assert!(far > EQUILIBRIUM, "half a percent is seen: {far}");
}

#[test]
fn evaluations_are_those_of_the_processor_at_first() {
    let Some(gpu) = gpu() else { return };
    let model = sheet("bird base");
    let stiff = Relax { softening: None, ..relax() };
    let methods = [
        // Past two renewals of the masses, on the ramp and beyond.
        Relax { steps: Some(150), ramp: Some(80), ..stiff.clone() },
        // Soft, past one renewal; the end of the ramp is not the same evaluation on both.
        Relax { steps: Some(90), ramp: Some(120), ..relax() },
    ];
    for (method, dispatch) in methods.iter().flat_map(|method| WAYS.iter().map(move |way| (method, *way))) {
        let (theirs, ours) =
            (folded(method, &model, 70.0), folded(&gpu.with(method.clone()).dispatch(dispatch), &model, 70.0));
        let far = apart(&ours.state, &theirs.state);
        println!("bird base: {far:.1e} radii apart after {} evaluations", ours.steps);
        assert!(far < 1e-5, "{far} radii apart");
        assert!((ours.time_step / theirs.time_step - 1.0).abs() < 1e-5, "FIRE's step");
        let softening = if method.softening.is_some() { None } else { relax().softening };
        let longer = Relax { ramp: method.ramp.map(|ramp| ramp + 1), ..method.clone() };
        for other in [longer, Relax { softening, ..method.clone() }] {
            let far = apart(&ours.state, &folded(&other, &model, 70.0).state);
            assert!(far > 1e-5, "another way is seen: {far}");
        }
    }
}

#[test]
fn a_path_in_one_session_is_the_same_as_stage_by_stage() {
    let Some(gpu) = gpu() else { return };
    let model = sheet("bird base");
    let solver = gpu.with(relax());
    let percents = [0.0, 30.0, 60.0, 45.0];
    let path = fold_path(&model, &solver, &percents, &mut |_, _| ControlFlow::Continue(())).expect("it holds");
    let mut state = State::at_rest(&model);
    for (stage, percent) in path.iter().zip(percents) {
        let alone = solver.fold(&model, &state, &Scene::percent(percent), &mut unwatched).expect("it holds");
        assert_eq!((&stage.state, stage.steps), (&alone.state, alone.steps), "{percent} %");
        assert!(stage.converged(), "{percent} %");
        state = alone.state;
    }
}

#[test]
fn two_runs_give_the_same_bits() {
    let Some(gpu) = gpu() else { return };
    let model = sheet("miura");
    for dispatch in WAYS.iter().copied() {
        let relax = gpu.with(relax()).dispatch(dispatch);
        let dynamics = gpu.with(Dynamics { steps: Some(200), ..Dynamics::default() }).dispatch(dispatch);
        for solver in [&relax as &dyn Solver, &dynamics] {
            let (one, two) = (folded(solver, &model, 80.0), folded(solver, &model, 80.0));
            assert_eq!(one.state, two.state);
            assert_eq!((one.steps, one.residual, one.distance), (two.steps, two.residual, two.distance));
        }
    }
}
