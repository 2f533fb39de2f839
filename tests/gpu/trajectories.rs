//! Motion in time.

use origami::Dynamics;
use origami::gpu::Dispatch;
use origami::solve::{Integrator, TimeStep};

use crate::common::gpu::gpu;
use crate::common::largest_distance;
use crate::sheets::{HELD, STEPS, TRAJECTORY, VELOCITY, apart, folded, sheet, sheets, ways};

#[test]
fn trajectories_agree_with_the_processor() {
    let Some(gpu) = gpu() else { return };
    for (name, model) in sheets() {
        for (i, (method, dispatch)) in ways().into_iter().enumerate() {
            // Without damping motion is chaotic: there 300 safe steps make 2e-7 out of 1e-9.
            let steps = if model.material.zeta == 0.0 { STEPS / 3 } else { STEPS };
            let method = Dynamics { steps: Some(steps), ..method };
            let theirs = folded(&method, &model, 60.0);
            let ours = folded(&gpu.with(method.clone()).dispatch(dispatch), &model, 60.0);
            let far = apart(&ours.state, &theirs.state);
            let fast = largest_distance(&ours.state.velocities, &theirs.state.velocities);
            let moved = largest_distance(&theirs.state.positions, &model.rest);
            println!("{name}, way {i}: {far:.1e} radii apart, velocities {fast:.1e}, after moving {moved:.2}");
            assert!(far < TRAJECTORY, "{name}, way {i}: {far} radii apart");
            assert!(fast < VELOCITY, "{name}, way {i}: velocities {fast} apart");
            assert!(moved > 0.02 || name == "k_fold 0", "{name} moves");
            let angles = ours.state.fold_angles.iter().zip(&theirs.state.fold_angles);
            assert!(angles.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) < 1e3 * TRAJECTORY, "{name}: fold angles");
            assert_eq!(ours.state.targets, theirs.state.targets);
            assert_eq!((ours.stop, ours.steps, ours.attempts), (theirs.stop, theirs.steps, 1), "{name}");
            let (step, own) = (ours.time_step, theirs.time_step);
            assert!((step / own - 1.0).abs() < 1e-5, "{name}, way {i}: steps of {step} and {own}");
            assert!((ours.residual - theirs.residual).abs() < 1e-3 * theirs.residual + 1e-6, "{name}: residual");
            for node in &model.fixed {
                let moved = ours.state.positions[node.index()].distance(model.rest[node.index()]);
                assert!(moved < HELD, "{name}: it is fixed, and moved by {moved}");
            }
        }
    }
}

#[test]
fn trajectories_that_differ_a_little_are_told_apart() {
    let Some(gpu) = gpu() else { return };
    let model = sheet("miura");
    let (method, dispatch) = ways()[1].clone();
    let ours = folded(&gpu.with(method.clone()).dispatch(dispatch), &model, 60.0);
    let wrongs = [
        folded(&method, &model, 60.01),
        folded(&Dynamics { ramp: 91, ..method.clone() }, &model, 60.0),
        folded(&Dynamics { integrator: Integrator::Verlet, ..method.clone() }, &model, 60.0),
        folded(&Dynamics { steps: Some(STEPS - 1), ..method.clone() }, &model, 60.0),
    ];
    for (i, wrong) in wrongs.iter().enumerate() {
        let far = apart(&ours.state, &wrong.state);
        assert!(far > TRAJECTORY, "wrong {i} is seen: {far}");
    }
}

#[test]
fn dynamics_settles_when_the_processor_does() {
    let Some(gpu) = gpu() else { return };
    let model = sheet("k_face 0");
    for (ramp, dispatch) in [(0, Dispatch::Workgroup), (50, Dispatch::Passes), (50, Dispatch::Blocks)] {
        let method = Dynamics { time_step: TimeStep::Safe, tolerance: 1e-3, ramp, ..Dynamics::default() };
        let (theirs, ours) =
            (folded(&method, &model, 40.0), folded(&gpu.with(method.clone()).dispatch(dispatch), &model, 40.0));
        assert!(ours.converged() && theirs.converged());
        // Looks are 20 evaluations apart, and so windows are longer by up to that.
        let steps = ours.steps as f64 / theirs.steps as f64;
        assert!((steps - 1.0).abs() < 0.1, "{} and {} steps", ours.steps, theirs.steps);
        assert!(apart(&ours.state, &theirs.state) < 2.0 * method.tolerance);
    }
}
