//! Forces agree with the formulas as the paper prints them, on sheets that are folded and shaken.

mod common;
#[path = "common/printed.rs"]
mod printed;

use common::{fold, made};
use origami::forces::{Forces, damping};
use origami::glam::DVec3;
use origami::{Dynamics, Model, Relax, State};
use printed::Printed;

/// Largest difference between the forces of both, relative to the largest force.
fn difference(model: &Model, state: &State, targets: &[f64], stretch: f64) -> f64 {
    let mut angles = state.fold_angles.clone();
    let mut forces = Forces::new(model).evaluate(&state.positions, targets, &mut angles).to_vec();
    damping::add(model, &state.velocities, &mut forces);
    let mut state = state.clone();
    for position in &mut state.positions {
        *position *= 1.0 + stretch;
    }
    let mut printed = Printed::new(model);
    let others = printed.forces(&mut state, targets);
    let largest = forces.iter().map(|f| f.length()).fold(0.0, f64::max);
    assert!(largest > 1e-3, "nothing is compared");
    let differences = forces.iter().zip(others).map(|(a, b)| a.distance(*b));
    let angles = angles.iter().zip(&state.fold_angles).map(|(a, b)| (a - b).abs());
    (differences.fold(0.0, f64::max) / largest).max(angles.fold(0.0, f64::max))
}

/// On its way to 60 %, each node moved and moving somewhere else.
fn shaken(model: &Model) -> State {
    let mut state = fold(model, &Relax { steps: Some(300), ..Relax::default() }, 60.0).state;
    for (n, (position, velocity)) in state.positions.iter_mut().zip(&mut state.velocities).enumerate() {
        let t = n as f64;
        let way = DVec3::new((2.1 * t).sin(), (3.7 * t).cos(), (5.3 * t).sin());
        *position += 2e-3 * way;
        *velocity = 0.1 * way;
    }
    state
}

#[test]
fn forces_are_those_of_the_paper() {
    for name in ["miura", "kresling", "waterbomb", "bird-base", "hypar"] {
        let model = made(name);
        let state = shaken(&model);
        let targets = model.targets(80.0);
        let difference = difference(&model, &state, &targets, 0.0);
        assert!(difference < 1e-9, "{name}: {difference:e}");
    }
}

#[test]
fn a_difference_is_seen() {
    let model = made("miura");
    assert!(difference(&model, &shaken(&model), &model.targets(80.0), 1e-6) > 1e-8);
}

#[test]
fn steps_are_those_of_dynamics() {
    let model = made("miura");
    let dt = origami::solve::time_step::paper(&model);
    let mut state = State::at_rest(&model);
    let mut printed = Printed::new(&model);
    for _ in 0..200 {
        printed.step(&mut state, &model.targets(60.0), dt);
    }
    let ours = fold(&model, &Dynamics { steps: Some(200), ..Dynamics::default() }, 60.0).state;
    let apart = ours.positions.iter().zip(&state.positions).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    assert!(apart < 1e-9, "{apart:e}");
}
