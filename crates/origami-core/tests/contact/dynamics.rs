//! Motion through time of sheets that touch themselves.

use origami_core::contact::{Contact, Crossings};
use origami_core::glam::DVec3;
use origami_core::scene::Scene;
use origami_core::solve::{
    ContactDynamics, ContactRelax, Dynamics, Folded, Integrator, Relax, State, Stop, TimeStep, Touch, Touching,
    time_step, unwatched,
};
use origami_core::{Material, Model, Solver};

/// A sheet without damping.
fn undamped(name: &str) -> Model {
    let pattern = origami_core::generate::catalog::generate(name, &[]).expect("a pattern");
    Model::new(&pattern, &Material { zeta: 0.0, ..Material::default() }).expect("a model")
}

/// Steps that hardly cost the springs any energy: what drifts is due to contact.
fn of_steps(model: &Model, steps: u64, integrator: Integrator, contact: Contact) -> ContactDynamics {
    let time_step = TimeStep::Fixed(0.07 * time_step::safe(model, &model.rest, integrator));
    let dynamics = Dynamics { steps: Some(steps), integrator, time_step, ..Dynamics::default() };
    ContactDynamics { dynamics, contact }
}

/// Motion, springs and contact.
fn energy(model: &Model, folded: &Folded, touch: &Touch) -> f64 {
    let kinetic: f64 = folded.state.velocities.iter().map(|v| 0.5 * v.length_squared()).sum();
    kinetic + folded.state.energy(model).total() + touch.energy
}

/// Lets a sheet fly from where it is at rest at 90 %, with its creases asked to lie flat. The largest drift of energy
/// over `pieces` of so many steps, as a share of what there was; the share of the pieces' ends at which something touched; and
/// how many of the states, of each tenth, are crossed.
fn fly(name: &str, (gap, stiffness): (f64, f64), (pieces, steps): (usize, u64)) -> (f64, f64, usize) {
    let model = undamped(name);
    let solver = of_steps(&model, steps, Integrator::Verlet, Contact { gap, stiffness, ..Contact::default() });
    let mut state = Relax::default().fold_from_rest(&model, 90.0).expect("it folds").state;
    let (mut first, mut worst, mut touched, mut crossed) = (None, 0.0_f64, 0, 0);
    for _ in 0..pieces {
        let mut look = |step: u64, positions: &[DVec3]| {
            if step.is_multiple_of(10) {
                crossed += usize::from(!Crossings::of(&model.mesh, positions).is_empty());
            }
        };
        let flown = solver.fold_looking(&model, &state, &Scene::percent(100.0), &mut look);
        let (folded, touch) = flown.expect("it moves");
        let now = energy(&model, &folded, &touch);
        let before = *first.get_or_insert(now);
        worst = worst.max((now - before).abs() / before);
        touched += usize::from(touch.least_gap.is_finite());
        state = folded.state;
    }
    (worst, touched as f64 / pieces as f64, crossed)
}

#[test]
fn a_sheet_that_bounces_keeps_its_energy() {
    let (drift, touched, crossed) = fly("strip", (0.01, 50.0), (20, 200));
    assert!(drift < 1e-3, "{drift}");
    assert!(touched > 0.3, "it touches: {touched}");
    assert_eq!(crossed, 0);
}

#[test]
#[ignore = "seconds: ten thousand steps each"]
fn ten_thousand_steps_in_contact_keep_energy() {
    let sheets =
        [("strip", 50.0), ("strip", 500.0), ("bird-base", 500.0), ("square-twist", 50.0), ("square-twist", 500.0)];
    for (name, stiffness) in sheets {
        let (drift, touched, crossed) = fly(name, (0.01, stiffness), (20, 500));
        assert!(drift < 1e-3, "{name}: {drift}");
        assert!(touched > 0.3, "{name} touches: {touched}");
        assert_eq!(crossed, 0, "{name}");
    }
}

#[test]
fn what_slams_shut_is_stopped_and_does_not_cross() {
    for name in ["strip", "bird-base", "square-twist"] {
        let model = undamped(name);
        // All creases are let go at once, of a sheet that hardly pushes: no barrier brakes that.
        let contact = Contact { gap: 3e-3, stiffness: 1.0, ..Contact::default() };
        let solver = of_steps(&model, 1500, Integrator::Verlet, contact);
        let (start, mut crossed) = (State::perturbed(&model, 1e-2, 1), 0);
        let mut look = |_: u64, positions: &[DVec3]| {
            crossed += usize::from(!Crossings::of(&model.mesh, positions).is_empty());
        };
        let (_, touch) = solver.fold_looking(&model, &start, &Scene::percent(100.0), &mut look).expect("it moves");
        assert!(touch.limited > 0 && crossed == 0, "{name}: {} stops, {crossed} crossed", touch.limited);
    }
}

#[test]
fn a_damped_sheet_comes_to_rest_where_relaxation_brings_it() {
    let pattern = origami_core::generate::catalog::generate("strip", &[]).expect("a pattern");
    let model = Model::new(&pattern, &Material::paper()).expect("a model");
    let contact = Contact { gap: 0.01, ..Contact::default() };
    let (start, scene) = (State::perturbed(&model, 1e-2, 1), Scene::percent(100.0));
    let dynamics = Dynamics { ramp: 2000, max_steps: 400_000, tolerance: 1e-5, ..Dynamics::default() };
    let (moved, touch) =
        ContactDynamics { dynamics, contact }.fold_touching(&model, &start, &scene, &mut unwatched).expect("it moves");
    assert_eq!(moved.stop, Stop::Converged);
    assert!(touch.least_gap < contact.gap && touch.least_gap > 0.0);
    let relax = Relax { tolerance: 1e-5, ..Relax::default() };
    let relaxed = ContactRelax { relax, contact }.fold(&model, &start, &scene, &mut unwatched).expect("it folds");
    let apart = moved.state.fold_angles.iter().zip(&relaxed.state.fold_angles).map(|(a, b)| (a - b).abs().to_degrees());
    let apart = apart.fold(0.0, f64::max);
    assert!(apart < 0.2, "{apart} degrees");
}

#[test]
fn without_touching_it_moves_as_dynamics_does() {
    let model = undamped("miura");
    let start = State::perturbed(&model, 1e-2, 1);
    for integrator in [Integrator::Euler, Integrator::Verlet] {
        let dynamics = Dynamics { steps: Some(200), integrator, time_step: TimeStep::Safe, ..Dynamics::default() };
        let scene = Scene::percent(20.0);
        let free = dynamics.fold(&model, &start, &scene, &mut unwatched).expect("it moves");
        let solver = ContactDynamics { dynamics, ..ContactDynamics::default() };
        let (held, touch) = solver.fold_touching(&model, &start, &scene, &mut unwatched).expect("it moves");
        assert_eq!((touch.limited, touch.least_gap), (0, f64::INFINITY));
        let apart = |a: &[DVec3], b: &[DVec3]| a.iter().zip(b).map(|(a, b)| (*a - *b).length()).fold(0.0, f64::max);
        let moved = apart(&free.state.positions, &start.positions);
        let [places, speeds] = [
            apart(&free.state.positions, &held.state.positions),
            apart(&free.state.velocities, &held.state.velocities),
        ];
        assert!(moved > 0.05 && places < 1e-12 && speeds < 1e-11, "{integrator:?}: {places} {speeds} of {moved}");
    }
}
