//! A sheet that is stepped and steered ends where a fold ends, and nothing is lost on the way.

use origami_core::generate::{Miura, catalog};
use origami_core::glam::{DVec2, DVec3};
use origami_core::ids::{NodeId, VertexId};
use origami_core::scene::{Axes, Load, Refusal, Scene, Support, Targets, Timeline};
use origami_core::solve::{Failed, Integrator, Method, Precision, Simulation, Stop, TimeStep, Units, unwatched};
use origami_core::{Dynamics, Material, Model, Relax, Solver, State};

fn model(name: &str) -> Model {
    let pattern = catalog::generate(name, &[]).expect("a pattern");
    Model::new(&pattern, &Material::default()).expect("a model")
}

fn farthest(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

/// How far apart two states are, whatever rigid motion lies between them.
fn apart(a: &State, b: &State) -> f64 {
    origami_core::measure::align(&a.positions, &b.positions).max
}

/// Dynamics of each kind that steps differently.
fn dynamics() -> Vec<Dynamics> {
    let mut all = Vec::new();
    for integrator in [Integrator::Euler, Integrator::Verlet] {
        for precision in [Precision::F64, Precision::Mixed] {
            all.push(Dynamics { integrator, precision, time_step: TimeStep::Safe, ..Dynamics::default() });
        }
    }
    all
}

#[test]
fn steps_are_the_solvers_bit_for_bit_however_they_are_portioned() {
    let model = model("miura");
    for method in dynamics() {
        let whole = Dynamics { steps: Some(333), ..method.clone() }.fold_from_rest(&model, 60.0).expect("holds");
        for portions in [vec![333], vec![1; 333], vec![100, 7, 40, 186]] {
            let mut simulation = Simulation::new(model.clone(), method.clone()).expect("it runs");
            simulation.set_targets(Targets::percent(60.0)).expect("targets");
            assert!(portions.iter().all(|steps| simulation.step(*steps).is_ok()));
            assert_eq!(simulation.report().steps, 333);
            assert_eq!(simulation.finish().expect("measured").state, whole.state, "{method:?}");
        }
    }
    for precision in [Precision::F64, Precision::Mixed] {
        let relax = Relax { steps: Some(500), precision, ..Relax::default() };
        let whole = relax.fold_from_rest(&model, 60.0).expect("holds");
        let mut simulation = Simulation::new(model.clone(), relax).expect("it runs");
        simulation.set_targets(Targets::percent(60.0)).expect("targets");
        assert!((0..500).all(|_| simulation.step(1).is_ok()));
        assert_eq!(simulation.finish().expect("measured").state, whole.state, "{precision:?}");
    }
}

/// Draws a slider from 0 to 100 % in 1 000 calls of one step, and lets the sheet settle.
fn slide<M: Method>(model: &Model, method: M) -> origami_core::Folded {
    let mut simulation = Simulation::new(model.clone(), method).expect("it runs");
    for i in 1..=1000 {
        simulation.set_targets(Targets::percent(0.1 * f64::from(i))).expect("targets");
        simulation.step(1).expect("holds");
    }
    let report = simulation.settle(200_000).expect("holds");
    assert!(report.settled, "{report:?}");
    simulation.finish().expect("measured")
}

#[test]
fn a_slider_ends_where_a_fold_ends() {
    for name in ["single-crease", "miura", "bird-base", "waterbomb-vertex", "kresling"] {
        let model = model(name);
        let relax = Relax { tolerance: 1e-5, ..Relax::default() };
        let folded = relax.fold_from_rest(&model, 100.0).expect("holds");
        let by_slider = slide(&model, relax.clone());
        let far = apart(&by_slider.state, &folded.state);
        assert!(far < 2e-5, "{name}: relax ends {far} radii apart");
        assert_eq!((by_slider.stop, by_slider.percent()), (Stop::Converged, Some(100.0)));
    }
    let model = model("single-crease");
    let dynamics = Dynamics { time_step: TimeStep::Safe, tolerance: 1e-5, ..Dynamics::default() };
    let folded = dynamics.fold_from_rest(&model, 100.0).expect("holds");
    let far = apart(&slide(&model, dynamics).state, &folded.state);
    assert!(far < 2e-5, "dynamics ends {far} radii apart");
}

#[test]
fn claims_after_a_move_of_the_targets_are_true() {
    for name in ["miura", "waterbomb", "hypar", "fan", "square-twist"] {
        let model = model(name);
        let tolerance = 1e-4;
        let mut simulation = Simulation::new(model.clone(), Relax { tolerance, ..Relax::default() }).expect("it runs");
        for percent in [30.0, 30.5, 31.0, 45.0, 44.9, 20.0] {
            simulation.set_targets(Targets::percent(percent)).expect("targets");
            assert!(!simulation.report().settled && simulation.report().distance.is_infinite(), "not known yet");
            assert!(simulation.settle(200_000).expect("holds").settled, "{name} at {percent} %");
            let claimed = simulation.state().expect("read");
            // The same state, relaxed a thousand times closer.
            let on = Relax { tolerance: 1e-7, perturbation: 0.0, retry: false, ..Relax::default() };
            let closer = on.fold(&model, &claimed, &Scene::percent(percent), &mut unwatched).expect("holds");
            let far = farthest(&claimed.positions, &closer.state.positions);
            assert!(far < 3.0 * tolerance, "{name} at {percent} %: claimed within {tolerance}, {far} away");
        }
    }
}

#[test]
fn new_targets_do_not_shake_the_sheet() {
    let model = model("miura");
    let mut simulation = Simulation::new(model, Relax::default()).expect("it runs");
    simulation.set_targets(Targets::percent(50.0)).expect("targets");
    simulation.settle(100_000).expect("holds");
    let before = simulation.state().expect("read").positions;
    simulation.set_targets(Targets::percent(50.01)).expect("targets");
    simulation.step(1).expect("holds");
    let moved = farthest(&before, &simulation.state().expect("read").positions);
    // A perturbation of 1 % of a beam would be a hundred times as much.
    assert!(moved < 3e-5, "{moved}");
}

#[test]
fn a_node_that_is_pinned_in_motion_stands_still() {
    let model = model("miura");
    for method in dynamics() {
        let mut simulation = Simulation::new(model.clone(), method.clone()).expect("it runs");
        simulation.set_targets(Targets::percent(60.0)).expect("targets");
        simulation.step(300).expect("holds");
        let state = simulation.state().expect("read");
        let swift = (0..model.node_count()).max_by(|a, b| {
            let speed = |n: &usize| state.velocities[*n].length();
            speed(a).total_cmp(&speed(b))
        });
        let node = NodeId::new(swift.expect("nodes"));
        assert!(state.velocities[node.index()].length() > 1e-3, "it moves");
        let pin = simulation.pin(node).expect("a node");
        simulation.step(200).expect("holds");
        let held = simulation.state().expect("read");
        assert_eq!(held.positions[node.index()], state.positions[node.index()], "{method:?}");
        assert_eq!(held.velocities[node.index()], DVec3::ZERO);
        assert!(simulation.reactions().expect("read")[0].force.length() > 1e-6, "something pulls at it");

        let target = held.positions[node.index()] + DVec3::new(0.0, 0.0, 0.05);
        simulation.move_pin(pin, target).expect("pinned");
        simulation.step(50).expect("holds");
        assert_eq!(simulation.positions().expect("read").get(node), Some(target));
        simulation.unpin(pin).expect("let go");
        simulation.step(50).expect("holds");
        assert!(simulation.positions().expect("read").get(node).expect("a node").distance(target) > 1e-6, "it is free");
        let refused = simulation.move_pin(pin, target).expect_err("it was taken out");
        assert!(matches!(refused, Failed::Refused { refusal: Refusal::NotPinned(n), .. } if n == node), "{refused}");
    }
}

#[test]
fn what_does_not_fit_is_refused_before_any_work() {
    let model = model("single-crease");
    let mut simulation = Simulation::new(model.clone(), Relax::default()).expect("it runs");
    let before = simulation.state().expect("read");
    let nodes = model.node_count();
    let says = |failed: Failed| failed.to_string();
    assert_eq!(
        says(simulation.pin(NodeId::new(nodes)).expect_err("no such node")),
        "supports[0]: node 4; expected one of the sheet's 4 nodes"
    );
    let wrong = says(simulation.set_targets(Targets::angles(vec![0.0; 3])).expect_err("three for one"));
    assert_eq!(wrong, "targets: 3 angles; expected one for each of the model's 1 creases");
    assert!(says(simulation.set_targets(Targets::percent(f64::NAN)).expect_err("no number")).contains("NaN %"));
    let pin = simulation.pin(NodeId(0)).expect("a node");
    assert!(simulation.move_pin(pin, DVec3::NAN).is_err());
    assert_eq!(simulation.state().expect("read"), before, "nothing was done");
    let unbalanced = Scene::percent(10.0).with_load(Load { node: NodeId(0), force: DVec3::Z });
    let failed = Relax::default().fold(&model, &before, &unbalanced, &mut unwatched).expect_err("it would fly away");
    assert!(matches!(&failed, Failed::Refused { refusal: Refusal::Unbalanced { .. }, .. }), "{failed}");
    assert_eq!(failed.last_state(), &before);
}

#[test]
fn a_fold_that_is_broken_off_hands_back_what_it_had() {
    use std::ops::ControlFlow;
    for (name, threads) in [("miura", None), ("miura", std::num::NonZeroUsize::new(2))] {
        let model = model(name);
        // It would go on for a long time; who listens beside several threads may be late.
        let most = 5_000_000;
        let relax = Relax { threads, tolerance: 1e-30, max_steps: most, ..Relax::default() };
        let mut reports = 0;
        let folded = relax.fold(&model, &State::at_rest(&model), &Scene::percent(60.0), &mut |progress| {
            reports += 1;
            if progress.step >= 100 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        let folded = folded.expect("no error");
        assert_eq!(folded.stop, Stop::Cancelled);
        assert!((100..most).contains(&folded.steps) && reports >= 2, "{} steps", folded.steps);
        assert!(farthest(&folded.state.positions, &model.rest) > 1e-3, "it had come somewhere");
    }
}

#[test]
fn a_view_writes_the_units_that_are_asked_for() {
    let pattern = Miura { columns: 3, rows: 3, ..Miura::default() }.pattern().expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let mut simulation = Simulation::new(model.clone(), Dynamics::default()).expect("it runs");
    let view = simulation.positions().expect("a view");
    let mut written = vec![0.0_f32; 3 * view.len()];
    assert_eq!(view.write_f32(Units::File, &mut written), model.node_count());
    for (i, node) in model.mesh.vertex_of_node.iter().enumerate() {
        let own = DVec3::new(written[3 * i].into(), written[3 * i + 1].into(), written[3 * i + 2].into());
        assert!(own.distance(pattern.vertices[node.index()]) < 1e-5, "vertex {}", node.0);
    }
    assert_eq!(view.write_f32(Units::Radii, &mut written[..7]), 2, "as many as fit");
    assert!(view.iter().zip(&model.rest).all(|(a, b)| a == *b));
}

#[test]
fn a_timeline_folds_creases_one_after_the_other() {
    let model = model("miura");
    let pattern = catalog::generate("miura", &[]).expect("a pattern");
    let mut order = Timeline::new(&model);
    let creases: Vec<_> =
        pattern.edges.iter().enumerate().filter(|(_, e)| e.fold_angle.is_some_and(|a| a != 0.0)).collect();
    for (i, (edge, of)) in creases.iter().enumerate() {
        let angle = 0.5 * of.fold_angle.expect("it has one");
        let keys = if i % 2 == 0 { [(0.0, 0.0), (0.5, angle)] } else { [(0.5, 0.0), (1.0, angle)] };
        order.set(origami_core::ids::EdgeId::new(*edge), keys).expect("keys");
    }
    let mut simulation = Simulation::new(model.clone(), Relax::default()).expect("it runs");
    for share in [0.25, 0.5, 0.75, 1.0] {
        simulation.set_targets(order.at(share)).expect("targets");
        assert!(simulation.settle(100_000).expect("holds").settled);
    }
    let folded = simulation.finish().expect("measured");
    let half = Targets::percent(50.0).of(&model).expect("targets");
    assert!(
        folded.state.targets.iter().zip(&half).all(|(a, b)| (a - b).abs() < 1e-12),
        "it ends at half of all angles"
    );
    assert_eq!(folded.percent(), None, "angles that are no percentage");
}

#[test]
fn it_goes_on_bit_for_bit_from_where_it_was_saved() {
    let model = model("waterbomb");
    let check = |first: &mut dyn FnMut() -> State, restored: State| assert_eq!(first(), restored);
    for method in dynamics() {
        let mut simulation = Simulation::new(model.clone(), method.clone()).expect("it runs");
        simulation.set_targets(Targets::percent(60.0)).expect("targets");
        simulation.pin(NodeId(3)).expect("a node");
        simulation.step(137).expect("holds");
        let saved = simulation.save().expect("saved");
        let mut again = Simulation::restore(model.clone(), method, &Scene::default(), &saved).expect("it fits");
        assert_eq!(again.report(), simulation.report());
        again.step(100).expect("holds");
        let other = again.state().expect("read");
        check(
            &mut || {
                simulation.step(100).expect("holds");
                simulation.state().expect("read")
            },
            other,
        );
    }
    let mut simulation = Simulation::new(model.clone(), Relax::default()).expect("it runs");
    simulation.set_targets(Targets::percent(60.0)).expect("targets");
    simulation.step(137).expect("in the middle of the ramp");
    let saved = simulation.save().expect("saved");
    let mut again = Simulation::restore(model, Relax::default(), &Scene::default(), &saved).expect("it fits");
    again.settle(100_000).expect("holds");
    simulation.settle(100_000).expect("holds");
    assert_eq!(again.finish().expect("measured").state, simulation.finish().expect("measured").state);
    let other = self::model("single-crease");
    let refused = Simulation::restore(other, Relax::default(), &Scene::default(), &saved).expect_err("another sheet");
    assert!(refused.to_string().contains("expected one of 4 nodes and 1 creases"), "{refused}");
}

#[test]
fn supports_hold_along_their_axes_and_carry_the_loads() {
    let model = model("miura");
    let folded = Relax::default().fold_from_rest(&model, 50.0).expect("holds");
    let nodes = model.node_count();
    let load = DVec3::new(2e-4, -1e-4, -1e-3);
    let scene = Scene::percent(50.0)
        .with_support(Support::fixed(NodeId(0)))
        .with_support(Support::along(NodeId::new(nodes - 1), Axes::Z | Axes::Y))
        .with_support(Support::along(NodeId(4), Axes::Z).at(DVec3::new(0.0, 0.0, folded.state.positions[4].z + 0.01)))
        .with_load(Load { node: NodeId::new(nodes / 2), force: load });
    let relax = Relax { tolerance: 1e-7, ..Relax::default() };
    let loaded = relax.fold(&model, &folded.state, &scene, &mut unwatched).expect("holds");
    assert!(loaded.converged());
    let moved = |n: usize| loaded.state.positions[n] - folded.state.positions[n];
    assert_eq!(moved(0), DVec3::ZERO);
    assert_eq!(moved(nodes - 1).with_x(0.0), DVec3::ZERO);
    assert!(moved(nodes - 1).x.abs() > 1e-6 && moved(4).truncate().length() > 1e-6, "free along the other axes");
    assert!((moved(4).z - 0.01).abs() < 1e-15, "put where it was prescribed");
    let total: DVec3 = loaded.reactions.iter().map(|r| r.force).sum::<DVec3>() + load;
    let moment = |n: NodeId, f: DVec3| loaded.state.positions[n.index()].cross(f);
    let moments: DVec3 =
        loaded.reactions.iter().map(|r| moment(r.node, r.force)).sum::<DVec3>() + moment(NodeId::new(nodes / 2), load);
    assert!(total.length() < 1e-6 && moments.length() < 1e-6, "left over: {total}, {moments}");
    assert!(loaded.reactions.iter().all(|r| r.force.length() > 1e-5), "each support carries something");
    assert_eq!(loaded.reactions.len(), 3);
    assert_eq!(loaded.reactions[1].force.truncate(), DVec2::ZERO, "no reaction along free axes");

    // The same by Newton's method, and by the simulation's own reactions.
    #[cfg(feature = "newton")]
    {
        let newton =
            origami_core::Newton::default().fold(&model, &folded.state, &scene, &mut unwatched).expect("holds");
        assert!(newton.converged() && newton.residual < 1e-9, "{newton:?}");
        let far = farthest(&loaded.state.positions, &newton.state.positions);
        assert!(far < 1e-6, "{far} radii apart");
        let same = loaded.reactions.iter().zip(&newton.reactions).all(|(a, b)| a.force.distance(b.force) < 1e-5);
        assert!(same && newton.reactions.len() == 3, "{:?}", newton.reactions);
    }
    let mut simulation = Simulation::in_scene(model.clone(), relax, &scene, folded.state.clone()).expect("it runs");
    simulation.settle(200_000).expect("holds");
    let reactions = simulation.reactions().expect("read");
    assert!(reactions.iter().zip(&loaded.reactions).all(|(a, b)| a.force.distance(b.force) < 1e-5), "{reactions:?}");
}

#[test]
fn a_fixed_vertex_of_the_file_is_held_in_every_scene() {
    let mut pattern = catalog::generate("bird-base", &[]).expect("a pattern");
    pattern.fixed = vec![VertexId(2)];
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let node = model.node(VertexId(2)).expect("a node");
    let mut simulation = Simulation::new(model.clone(), Dynamics::default()).expect("it runs");
    simulation.set_targets(Targets::percent(40.0)).expect("targets");
    let pin = simulation.pin(node).expect("held twice");
    simulation.unpin(pin).expect("held once");
    simulation.step(500).expect("holds");
    assert_eq!(simulation.positions().expect("read").get(node), Some(model.rest[node.index()]));
}

/// Written down as JSON and read again: another process goes on bit for bit.
#[cfg(feature = "serde")]
#[test]
fn it_goes_on_bit_for_bit_from_a_file() {
    let model = model("bird-base");
    let method = Dynamics { integrator: Integrator::Verlet, time_step: TimeStep::Safe, ..Dynamics::default() };
    let scene = Scene::percent(50.0).with_load(Load { node: NodeId(1), force: 1e-4 * DVec3::Z });
    let rest = State::at_rest(&model);
    let mut simulation = Simulation::in_scene(model.clone(), method.clone(), &scene, rest).expect("it runs");
    simulation.step(77).expect("holds");
    let text = serde_json::to_string(&simulation.save().expect("saved")).expect("JSON");
    let settings = serde_json::to_string(&method).expect("JSON");
    let method: Dynamics = serde_json::from_str(&settings).expect("settings");
    let saved = serde_json::from_str(&text).expect("what was written");
    let mut again = Simulation::restore(model, method, &Scene::default(), &saved).expect("it fits");
    assert_eq!(again.targets().label(), Some(50.0));
    again.step(500).expect("holds");
    simulation.step(500).expect("holds");
    assert_eq!(again.state().expect("read"), simulation.state().expect("read"));
}
