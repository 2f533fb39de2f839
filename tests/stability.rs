//! Stiff and thin scenes: where the paper's step blows up, the safe step and the relaxation hold; and what does not hold
//! says so.

mod common;

use origami::generate::{Fan, miura};
use origami::glam::DVec3;
use origami::scene::Scene;
use origami::solve::unwatched;
use origami::solve::{Diverged, Failed, Integrator, Quantity, TimeStep};
use origami::{CreasePattern, Dynamics, Folded, Material, Model, Relax, Solver, State};

fn fan(valence: usize) -> CreasePattern {
    Fan { valence, ..Fan::default() }.pattern().expect("valid")
}

/// Two long triangles of little height along one crease.
fn sliver(height: f64, fold_angle: f64, material: &Material) -> Model {
    let points = [DVec3::new(0.5, height, 0.0), DVec3::new(0.5, -height, 0.0), DVec3::ZERO, DVec3::X];
    common::hinge(points, fold_angle, material)
}

/// The scenes that METHOD names as blowing up at the paper's step.
fn dangerous() -> Vec<(&'static str, Model)> {
    let default = Material::default();
    let of = |pattern: &CreasePattern, material: Material| Model::new(pattern, &material).expect("valid");
    let sheet = miura(4, 4).expect("valid");
    vec![
        ("zeta 1 on a sheet", of(&sheet, Material { zeta: 1.0, ..default })),
        ("zeta 1 on a hub of 16", of(&fan(16), Material { zeta: 1.0, ..default })),
        ("zeta 1 on a hub of 32", of(&fan(32), Material { zeta: 1.0, ..default })),
        ("a sliver of 1 %", sliver(0.01, 1.0, &default)),
        ("a sliver of 0.3 %", sliver(0.003, 1.0, &default)),
        ("creases a thousand times stiffer", of(&sheet, Material { k_fold: 700.0, k_facet: 700.0, ..default })),
        ("corner angles a thousand times stiffer", of(&sheet, Material { k_face: 200.0, ..default })),
    ]
}

fn run(model: &Model, time_step: TimeStep, integrator: Integrator, steps: u64) -> Result<Folded, Failed> {
    let solver = Dynamics { time_step, integrator, steps: Some(steps), ..Dynamics::default() };
    solver.fold(model, &State::at_rest(model), &Scene::percent(60.0), &mut unwatched)
}

/// Whether a run came to rest. Where it did not, it blew up, or, on thin triangles, whose apexes swing through each other,
/// shakes without end.
fn rests(model: &Model, time_step: TimeStep) -> bool {
    let solver = Dynamics { time_step, max_steps: 20_000, ..Dynamics::default() };
    solver
        .fold(model, &State::at_rest(model), &Scene::percent(60.0), &mut unwatched)
        .is_ok_and(|folded| folded.converged())
}

fn is_sane(state: &State) -> bool {
    state.positions.iter().all(|p| p.length() < 2.0)
}

#[test]
fn the_papers_step_fails_where_the_safe_one_and_the_relaxation_hold() {
    for (name, model) in dangerous() {
        assert!(!rests(&model, TimeStep::Paper), "{name}: the paper's step holds");
        for integrator in [Integrator::Euler, Integrator::Verlet] {
            let safe = run(&model, TimeStep::Safe, integrator, 20_000).expect(name);
            assert!(is_sane(&safe.state), "{name}: {integrator:?}");
        }
        let relaxed = Relax::default().fold_from_rest(&model, 60.0).expect(name);
        assert!(relaxed.converged() && is_sane(&relaxed.state), "{name}");
    }
}

#[test]
fn the_safe_step_is_not_far_below_the_limit() {
    for (name, model) in dangerous() {
        let dt = origami::solve::time_step::safe(&model, &model.rest, Integrator::Euler);
        assert!(!rests(&model, TimeStep::Fixed(3.0 * dt)), "{name}: three times the safe step holds too");
    }
}

fn diverged(failed: Failed) -> Diverged {
    match failed {
        Failed::Diverged(diverged) => diverged,
        other => panic!("the processor does not give up: {other}"),
    }
}

#[test]
fn divergence_names_its_place_and_hands_back_the_last_good_state() {
    let model = Model::new(&miura(6, 6).expect("valid"), &Material::default()).expect("valid");
    let dt = origami::solve::time_step::paper(&model);
    for integrator in [Integrator::Euler, Integrator::Verlet] {
        let error = run(&model, TimeStep::Fixed(8.0 * dt), integrator, 10_000).expect_err("far too long a step");
        let error = diverged(error);
        assert!(error.step > 0 && error.vertex.index() < model.node_count());
        assert!(error.last_good_step < error.step && is_sane(&error.last_good));
        assert!(matches!(error.quantity, Quantity::Move | Quantity::Position));
        let text = error.to_string();
        assert!(text.contains(&format!("step {}", error.step)), "{text}");
        assert!(text.contains(&format!("vertex {}", error.vertex.0)), "{text}");
    }
}

#[test]
fn a_state_that_is_not_finite_is_divergence() {
    let model = Model::new(&miura(3, 3).expect("valid"), &Material::default()).expect("valid");
    let mut start = State::at_rest(&model);
    start.positions[5].y = f64::NAN;
    let solvers: [&dyn Solver; 2] = [&Dynamics::default(), &Relax::default()];
    for solver in solvers {
        let error = solver.fold(&model, &start, &Scene::percent(60.0), &mut unwatched).expect_err("NaN");
        let error = diverged(error);
        assert_eq!(error.step, 1);
        assert!(!error.value.is_finite());
    }
}

#[test]
fn relaxation_bears_extreme_materials_and_targets() {
    let default = Material::default();
    let mut scenes = Vec::new();
    for ea in [1.0, 1e3, 1e6, 1e8] {
        scenes.push(Material { ea, ..default });
    }
    for k in [0.0, 1e-6, 1e2, 1e5] {
        scenes.push(Material { k_fold: k, ..default });
        scenes.push(Material { k_facet: k, ..default });
        scenes.push(Material { k_face: k, ..default });
    }
    let pattern = miura(4, 4).expect("valid");
    for material in scenes {
        let model = Model::new(&pattern, &material).expect("valid");
        for percent in [-100.0, 60.0, 100.0, 250.0] {
            let solver = Relax { max_steps: 3000, ..Relax::default() };
            let folded = solver.fold_from_rest(&model, percent).expect("holds");
            assert!(is_sane(&folded.state), "{material:?} at {percent} %");
        }
    }
}

#[test]
fn thin_triangles_relax_to_their_angle() {
    for height in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5] {
        let model = sliver(height, 1.0, &Material::default());
        let folded = Relax::default().fold_from_rest(&model, 100.0).expect("holds");
        assert!(folded.converged(), "height {height}");
        assert!((folded.state.fold_angles[0] - 1.0).abs() < 1e-2, "height {height}: {}", folded.state.fold_angles[0]);
    }
}

#[test]
fn very_stiff_beams_hide_no_slow_motion() {
    // Beams leave the out-of-plane motion almost no speed: what hardly moves has not settled.
    for ea in [1e4, 1e6, 1e8, 1e12, 1e20, 1e100] {
        let points = [DVec3::new(0.5, 0.8, 0.0), DVec3::new(0.5, -0.8, 0.0), DVec3::ZERO, DVec3::X];
        let model = common::hinge(points, 1.5, &Material { ea, ..Material::default() });
        let folded = Relax { max_steps: 20_000, ..Relax::default() }.fold_from_rest(&model, 100.0).expect("holds");
        let missing = (folded.state.fold_angles[0] - 1.5).abs();
        assert!(!folded.converged() || missing < 2e-4, "EA {ea}: {missing} radians from its target");
        assert!(ea > 1e8 || folded.converged(), "EA {ea}: {} after {} steps", folded.distance, folded.steps);
    }
}
