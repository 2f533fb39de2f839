//! Motion in time: the vibration of a single crease (METHOD's closed form 4), and the order of both integrators.

mod common;

use origami::glam::DVec3;
use origami::scene::Scene;
use origami::solve::unwatched;
use origami::solve::{Integrator, Stop, TimeStep};
use origami::{Dynamics, Folded, Material, Model, Solver, State};

/// A crease of length 1 between apexes at height 0.8 on both sides.
fn crease(fold_angle: f64, material: &Material) -> Model {
    let points = [DVec3::new(0.5, 0.8, 0.0), DVec3::new(0.5, -0.8, 0.0), DVec3::ZERO, DVec3::X];
    common::hinge(points, fold_angle, material)
}

fn run(model: &Model, integrator: Integrator, time: f64, steps: u64) -> Folded {
    let time_step = TimeStep::Fixed(time / steps as f64);
    let solver = Dynamics { time_step, integrator, steps: Some(steps), ..Dynamics::default() };
    solver.fold(model, &State::at_rest(model), &Scene::percent(100.0), &mut unwatched).expect("a short step")
}

/// Angular frequency of small vibrations about the target: `omega^2 = 4 k_fold l / (h^2 m)`, in the model's units.
fn frequency(model: &Model) -> f64 {
    let (length, height) = (1.0 / model.normalisation.radius, 0.8 / model.normalisation.radius);
    (4.0 * model.material.k_fold * length).sqrt() / height
}

#[test]
fn a_crease_vibrates_at_its_frequency() {
    let target = 1e-3;
    let model = crease(target, &Material { zeta: 0.0, ..Material::default() });
    let period = std::f64::consts::TAU / frequency(&model);
    for (share, expected) in [(0.25, target), (0.5, 2.0 * target), (0.75, target), (1.0, 0.0)] {
        let folded = run(&model, Integrator::Verlet, share * period, 4000);
        let angle = folded.state.fold_angles[0];
        assert!((angle - expected).abs() < 1e-5 * target, "after {share} periods: {angle}, expected {expected}");
    }
}

#[test]
fn euler_is_of_first_order_and_verlet_of_second() {
    for zeta in [0.0, 0.45] {
        let model = crease(1.0, &Material { zeta, ..Material::default() });
        let exact = run(&model, Integrator::Verlet, 2.0, 1 << 15).state;
        for (integrator, order) in [(Integrator::Euler, 1.0), (Integrator::Verlet, 2.0)] {
            let error = |steps| {
                let state = run(&model, integrator, 2.0, steps).state;
                common::largest_distance(&state.positions, &exact.positions)
                    + common::largest_distance(&state.velocities, &exact.velocities)
            };
            let measured = (error(256) / error(512)).log2();
            assert!((measured - order).abs() < 0.15, "{integrator:?} at zeta {zeta} is of order {measured}");
        }
    }
}

#[test]
fn a_vibration_neither_gains_nor_loses_energy_over_many_periods() {
    let model = crease(1.0, &Material { zeta: 0.0, ..Material::default() });
    for integrator in [Integrator::Euler, Integrator::Verlet] {
        let energy = |steps: u64| {
            let state = run(&model, integrator, 0.002 * steps as f64, steps).state;
            let kinetic: f64 = state.velocities.iter().map(|v| 0.5 * v.length_squared()).sum();
            kinetic + state.energy(&model).total()
        };
        let (early, late) = (energy(1000), energy(100_000));
        assert!((late / early - 1.0).abs() < 0.01, "{integrator:?}: {early} became {late}");
    }
}

#[test]
fn the_driven_crease_comes_to_rest_at_its_target_without_strain() {
    let model = crease(2.0, &Material::default());
    let solver = Dynamics { tolerance: 1e-6, ..Dynamics::default() };
    let folded = solver
        .fold(&model, &State::at_rest(&model), &Scene::percent(100.0), &mut unwatched)
        .expect("a proper triangle pair");
    assert_eq!(folded.stop, Stop::Converged);
    assert!((folded.state.fold_angles[0] - 2.0).abs() < 1e-5);
    assert!(folded.state.energy(&model).total() < 1e-11);
}

#[test]
fn exactly_the_steps_asked_for_are_run() {
    let model = crease(2.0, &Material::default());
    let mut dt = 0.0;
    for steps in [0, 1, 7, 300] {
        let solver = Dynamics { steps: Some(steps), ..Dynamics::default() };
        let folded =
            solver.fold(&model, &State::at_rest(&model), &Scene::percent(100.0), &mut unwatched).expect("holds");
        assert_eq!((folded.steps, folded.stop), (steps, Stop::StepsDone));
        dt = folded.time_step;
    }
    // The paper's rule: 0.9 / (2 pi sqrt(EA / l0)) of the shortest beam.
    let shortest = model.beams.iter().map(|b| b.rest_length).fold(f64::INFINITY, f64::min);
    assert!((dt - 0.9 / (std::f64::consts::TAU * (20.0 / shortest).sqrt())).abs() < 1e-15);
}

#[test]
fn fixed_vertices_stay_where_they_are() {
    let mut pattern = common::pattern(
        vec![DVec3::new(0.5, 0.8, 0.0), DVec3::new(0.5, -0.8, 0.0), DVec3::ZERO, DVec3::X],
        vec![common::edge(2, 3, origami::pattern::Assignment::Valley, Some(1.0))],
        &[&[2, 3, 0], &[3, 2, 1]],
    );
    pattern.fixed = vec![origami::ids::VertexId(1), origami::ids::VertexId(2), origami::ids::VertexId(3)];
    let model = Model::new(&pattern, &Material::default()).expect("two triangles");
    let solvers: [&dyn Solver; 3] = [
        &origami::Relax::default(),
        &Dynamics::default(),
        &Dynamics { integrator: Integrator::Verlet, ..Dynamics::default() },
    ];
    for solver in solvers {
        let folded =
            solver.fold(&model, &State::at_rest(&model), &Scene::percent(100.0), &mut unwatched).expect("holds");
        assert!(folded.converged());
        for fixed in 1..4 {
            assert_eq!(folded.state.positions[fixed], model.rest[fixed]);
        }
        assert!((folded.state.fold_angles[0] - 1.0).abs() < 1e-3, "the free apex did the folding");
    }
}

#[test]
fn a_crease_folded_past_flat_is_at_rest_where_the_file_has_it() {
    // Folded by 183 degrees, as 3D files clamp it: measured, it looks like -177.
    let turn = origami::glam::DQuat::from_rotation_x(183_f64.to_radians());
    let left = turn * DVec3::new(0.0, 0.8, 0.0) + DVec3::X * 0.5;
    let points = [left, DVec3::new(0.5, -0.8, 0.0), DVec3::ZERO, DVec3::X];
    let model = common::hinge(points, 180_f64.to_radians(), &Material::default());
    assert!((model.creases[0].rest_angle - 183_f64.to_radians()).abs() < 1e-12);
    // One that is far from flat has no turn to add.
    let left = origami::glam::DQuat::from_rotation_x(-1.0) * DVec3::new(0.0, 0.8, 0.0) + DVec3::X * 0.5;
    let model = common::hinge([left, points[1], points[2], points[3]], 3.0, &Material::default());
    assert!((model.creases[0].rest_angle + 1.0).abs() < 1e-12);
}
