//! Scenes and simulations on a GPU against those on the processor, through the public interface.
#![cfg(feature = "gpu")]

mod common;

use std::ops::ControlFlow;

use common::gpu::gpu;
use common::{largest_distance, made};
use origami::forces::Forces;
use origami::glam::DVec3;
use origami::gpu::{Dispatch, Gpu, GpuMethod};
use origami::ids::NodeId;
use origami::scene::{Axes, Force, Load, Refusal, Scene, Support, Targets};
use origami::solve::{
    Engine, Failed, Folded, Instance, Integrator, Method, Report, Simulation, Stop, TimeStep, unwatched,
};
use origami::{Dynamics, Material, Model, Relax, Solver, State};

/// How far trajectories of some hundred steps may be apart, in radii: that of `tests/gpu`.
const TRAJECTORY: f64 = 5e-6;

/// How far equilibria may be apart, in radii.
const EQUILIBRIUM: f64 = 1e-3;

/// By how much reactions and other forces may differ: f32 cancels to some 1e-6, and a position that is off by
/// [`TRAJECTORY`] makes a force of that times the stiffness of a short beam.
const FORCE: f64 = 1e-3;

/// What shaders have of it: neither clusters of near nodes nor the search for saddles nor Newton's method; and as stiff on the way
/// as at its end, since a soft sheet arrives a few evaluations later there.
fn relax() -> Relax {
    Relax { softening: None, near: 0.0, saddle_search: 0.0, hand_over: None, ..Relax::default() }
}

/// Steps that hold on every sheet.
fn dynamics(integrator: Integrator) -> Dynamics {
    Dynamics { time_step: TimeStep::Safe, integrator, ..Dynamics::default() }
}

/// A sheet that hangs on an edge and on a corner whose height is prescribed, with two loads on one node and one on another.
fn hung(model: &Model) -> Scene {
    let last = NodeId::new(model.node_count() - 1);
    let lifted = model.rest[last.index()] + DVec3::new(0.0, 0.0, 0.05);
    let load = |node, force| Load { node: NodeId(node), force };
    Scene::percent(40.0)
        .with_support(Support::fixed(NodeId(0)))
        .with_support(Support::fixed(NodeId(1)))
        .with_support(Support::along(last, Axes::Z).at(lifted))
        .with_load(load(5, DVec3::new(0.0, 0.0, -2e-3)))
        .with_load(load(9, DVec3::new(1e-3, 0.0, 0.0)))
        .with_load(load(5, DVec3::new(0.0, 1e-3, 0.0)))
}

fn fold(solver: &dyn Solver, model: &Model, scene: &Scene) -> Folded {
    solver.fold(model, &State::perturbed(model, 1e-2, 3), scene, &mut unwatched).expect("it holds")
}

fn forces_apart(ours: &Folded, theirs: &Folded) -> f64 {
    assert_eq!(ours.reactions.len(), theirs.reactions.len());
    let apart = ours.reactions.iter().zip(&theirs.reactions).map(|(one, two)| {
        assert_eq!(one.node, two.node);
        one.force.distance(two.force)
    });
    apart.fold(0.0, f64::max)
}

#[test]
fn supports_and_loads_act_as_on_the_processor() {
    let Some(gpu) = gpu() else { return };
    let model = made("miura");
    let scene = hung(&model);
    for dispatch in [Dispatch::Passes, Dispatch::Workgroup, Dispatch::Blocks] {
        for integrator in [Integrator::Euler, Integrator::Verlet] {
            let method = Dynamics { steps: Some(200), ..dynamics(integrator) };
            let (ours, theirs) =
                (fold(&gpu.with(method.clone()).dispatch(dispatch), &model, &scene), fold(&method, &model, &scene));
            let far = largest_distance(&ours.state.positions, &theirs.state.positions);
            println!("{integrator:?}: {far:.1e} radii apart, reactions {:.1e}", forces_apart(&ours, &theirs));
            assert!(far < TRAJECTORY && forces_apart(&ours, &theirs) < FORCE, "{far}");
            let mut other = scene.clone();
            other.loads.pop();
            let other = fold(&method, &model, &other);
            assert!(largest_distance(&ours.state.positions, &other.state.positions) > TRAJECTORY, "a load is seen");
        }
    }
    let method = relax();
    let (ours, theirs) = (fold(&gpu.with(method.clone()), &model, &scene), fold(&method, &model, &scene));
    let far = largest_distance(&ours.state.positions, &theirs.state.positions);
    println!("{far:.1e} radii apart, {} and {} evaluations", ours.steps, theirs.steps);
    assert!(
        ours.converged() && theirs.converged() && far < EQUILIBRIUM,
        "{far} radii apart, {:?}, {:?}",
        ours.stop,
        theirs.stop
    );
    // At the equilibrium supports carry all loads.
    let held: DVec3 = ours.reactions.iter().map(|reaction| reaction.force).sum();
    let loaded: DVec3 = scene.loads.iter().map(|load| load.force).sum();
    assert!((held + loaded).length() < 0.1 * loaded.length(), "{held} and {loaded}");
    let last = ours.reactions[ours.reactions.len() - 1];
    assert_eq!((last.force.x, last.force.y), (0.0, 0.0), "it is free along these axes");
}

#[test]
fn held_axes_stay_and_the_others_do_not() {
    let Some(gpu) = gpu() else { return };
    let model = made("miura");
    let scene = hung(&model);
    let folded = fold(&gpu.with(relax()), &model, &scene);
    let start = State::perturbed(&model, 1e-2, 3);
    let last = model.node_count() - 1;
    let moved = |node: usize| folded.state.positions[node] - start.positions[node];
    assert!((folded.state.positions[last].z - model.rest[last].z - 0.05).abs() < 1e-9, "where it is prescribed");
    assert!(moved(last).truncate().length() > 1e-3, "free in its plane");
    assert!(moved(0).length() < 1e-9 && moved(7).length() > 1e-3);
}

#[test]
fn scenes_of_an_ensemble_have_loads_and_supports_of_their_own() {
    let Some(gpu) = gpu() else { return };
    let model = made("miura");
    let load = |node, z| Load { node: NodeId(node), force: DVec3::Z * z };
    let scenes = [
        hung(&model),
        Scene::percent(30.0),
        Scene::percent(30.0).with_support(Support::fixed(NodeId(2))).with_load(load(7, 1e-3)),
        Scene::percent(30.0).with_load(load(7, 1e-3)).with_load(load(3, -1e-3)),
    ];
    let start = State::perturbed(&model, 1e-2, 3);
    let instances: Vec<Instance<'_>> =
        scenes.iter().map(|scene| Instance { model: &model, start: start.clone(), scene: scene.clone() }).collect();
    let method = Dynamics { steps: Some(100), ..dynamics(Integrator::Euler) };
    for dispatch in [Dispatch::Passes, Dispatch::Workgroup, Dispatch::Blocks] {
        let solver = gpu.with(method.clone()).dispatch(dispatch);
        let all = solver.fold_all(&instances, &|_, _| ControlFlow::Continue(()));
        let states: Vec<State> = all.into_iter().map(|folded| folded.expect("it holds").state).collect();
        for (i, (instance, state)) in instances.iter().zip(&states).enumerate() {
            let theirs = fold(&method, &model, &instance.scene);
            let far = largest_distance(&state.positions, &theirs.state.positions);
            assert!(far < TRAJECTORY, "scene {i}: {far} radii apart");
        }
        assert!(largest_distance(&states[1].positions, &states[3].positions) > TRAJECTORY, "each has its own");
    }
}

#[test]
fn who_is_refused_does_not_take_the_others_along() {
    let Some(gpu) = gpu() else { return };
    let model = made("miura");
    let start = State::perturbed(&model, 1e-2, 3);
    let falls = Scene::percent(30.0).with_load(Load { node: NodeId(7), force: DVec3::Z });
    let instances: Vec<Instance<'_>> = [Scene::percent(30.0), falls, Scene::percent(20.0).with_force(Idle)]
        .into_iter()
        .map(|scene| Instance { model: &model, start: start.clone(), scene })
        .collect();
    let all = gpu.with(relax()).fold_all(&instances, &|_, _| ControlFlow::Continue(()));
    assert!(all[0].as_ref().is_ok_and(Folded::converged));
    assert!(matches!(&all[1], Err(Failed::Refused { refusal: Refusal::Unbalanced { .. }, .. })), "{:?}", all[1]);
    assert!(matches!(&all[2], Err(Failed::Refused { refusal: Refusal::Unsupported { .. }, .. })), "{:?}", all[2]);
}

#[test]
fn a_session_takes_scenes_with_more_in_them() {
    let Some(gpu) = gpu() else { return };
    let model = made("miura");
    let solver = gpu.with(Dynamics { steps: Some(60), ..dynamics(Integrator::Euler) });
    let mut session = solver.session(&model);
    let start = State::perturbed(&model, 1e-2, 3);
    for scene in [Scene::percent(40.0), hung(&model), Scene::percent(40.0)] {
        let folded = session.fold(&start, &scene, &mut unwatched).expect("it holds");
        let far = largest_distance(&folded.state.positions, &fold(&solver, &model, &scene).state.positions);
        assert!(far < TRAJECTORY, "{far} radii from what it is alone");
    }
}

/// A force that does nothing.
#[derive(Debug)]
struct Idle;

impl Force for Idle {
    fn inventory(&self) -> origami::model::Built {
        origami::model::Built { what: "idle", count: 1 }
    }

    fn add_forces(&self, _: &[DVec3], _: &[DVec3], _: &mut [DVec3]) {}
}

fn refusal<T: std::fmt::Debug>(result: Result<T, Failed>) -> Refusal {
    match result {
        Err(Failed::Refused { refusal, .. }) => refusal,
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_a_gpu_cannot_do_is_refused_with_what_can() {
    let Some(gpu) = gpu() else { return };
    let (model, solver) = (made("miura"), gpu.with(relax()));
    let start = State::at_rest(&model);
    let own = solver.fold(&model, &start, &Scene::percent(50.0).with_force(Idle), &mut unwatched);
    let text = refusal(own).to_string();
    assert!(text.starts_with("forces: a GPU cannot compute them; expected the same solver on the CPU"), "{text}");
    let load = Load { node: NodeId(4), force: DVec3::Z };
    let falls = solver.fold(&model, &start, &Scene::percent(50.0).with_load(load), &mut unwatched);
    assert!(matches!(refusal(falls), Refusal::Unbalanced { .. }));

    let mut simulation = Simulation::new(model, solver).expect("it fits");
    let text = refusal(simulation.set_loads(vec![load])).to_string();
    assert!(text.starts_with("loads on other nodes: a GPU cannot"), "{text}");
    assert!(matches!(refusal(simulation.save()), Refusal::Unsupported { .. }));
}

#[test]
fn a_fold_that_is_broken_off_hands_back_its_state() {
    let Some(gpu) = gpu() else { return };
    let model = made("miura");
    for solver in [&gpu.with(relax()) as &dyn Solver, &gpu.with(Dynamics::default())] {
        let mut reports = 0;
        let mut observe = |_| {
            reports += 1;
            if reports < 3 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        };
        let folded = solver
            .fold(&model, &State::at_rest(&model), &Scene::percent(50.0), &mut observe)
            .expect("it was only broken off");
        assert_eq!((folded.stop, folded.attempts, reports), (Stop::Cancelled, 1, 3));
        assert!(folded.steps >= 300 && folded.steps < 1000, "{} steps", folded.steps);
        assert!(largest_distance(&folded.state.positions, &model.rest) > 1e-3, "it had come some way");
    }
    let folded = gpu.with(relax()).fold_from_rest(&model, 20.0).expect("it holds");
    assert!(folded.converged() && folded.percent() == Some(20.0));
}

/// What is compared at each stop: the report and the state.
type Stops = Vec<(Report, State)>;

/// Moves a slider, pins a node while all moves, drags it, lets it go, and comes back; `portion` steps in one call.
fn commands<M: Method>(model: &Model, method: M, portion: u64) -> Stops {
    let node = NodeId(0);
    let mut simulation = Simulation::new(model.clone(), method).expect("it fits");
    let mut stops = Stops::new();
    fn step<M: Method>(simulation: &mut Simulation<M>, stops: &mut Stops, portion: u64, mut steps: u64) {
        while steps > 0 {
            let now = steps.min(portion);
            simulation.step(now).expect("it holds");
            steps -= now;
        }
        stops.push((simulation.report(), simulation.state().expect("read")));
    }
    simulation.set_targets(Targets::percent(30.0)).expect("targets");
    step(&mut simulation, &mut stops, portion, 47);
    let pin = simulation.pin(node).expect("a node");
    step(&mut simulation, &mut stops, portion, 21);
    let place = simulation.positions().expect("read").get(node).expect("a node");
    simulation.move_pin(pin, place + DVec3::new(0.0, 0.0, 0.02)).expect("a pin");
    simulation.set_targets(Targets::percent(35.0)).expect("targets");
    step(&mut simulation, &mut stops, portion, 33);
    simulation.unpin(pin).expect("a pin");
    step(&mut simulation, &mut stops, portion, 40);
    stops
}

fn commands_agree<S: GpuMethod + Method + Clone>(gpu: &Gpu, model: &Model, method: &S) {
    let (ours, theirs) = (commands(model, gpu.with(method.clone()), 40), commands(model, method.clone(), 40));
    for (i, (ours, theirs)) in ours.iter().zip(&theirs).enumerate() {
        let far = largest_distance(&ours.1.positions, &theirs.1.positions);
        assert!(far < TRAJECTORY, "stop {i}: {far} radii apart after {} steps", ours.0.steps);
        assert_eq!(ours.0.steps, theirs.0.steps);
        assert!((ours.0.ramp - theirs.0.ramp).abs() < 1e-9, "stop {i}: {} and {}", ours.0.ramp, theirs.0.ramp);
        let targets = ours.1.targets.iter().zip(&theirs.1.targets);
        assert!(targets.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) < 1e-9, "stop {i}: targets on their way");
    }
    // The pinned node stood still while the others moved, was dragged, and went when it was let go.
    let node = |stop: usize| ours[stop].1.positions[0];
    assert!(node(1).distance(node(0)) < 1e-9 && (node(2).z - node(1).z - 0.02).abs() < 1e-9);
    assert!(node(3).distance(node(2)) > 1e-6);
    assert_eq!(ours[1].1.velocities[0], DVec3::ZERO, "a pinned node has no velocity");
    let last = |stops: &Stops| stops[stops.len() - 1].clone();
    for portion in [1, 7] {
        let other = last(&commands(model, gpu.with(method.clone()), portion));
        assert_eq!(other, last(&ours), "{portion} steps in one call");
    }
}

#[test]
fn steered_simulations_agree_with_the_processor() {
    let Some(gpu) = gpu() else { return };
    let model = made("miura");
    for integrator in [Integrator::Euler, Integrator::Verlet] {
        commands_agree(&gpu, &model, &dynamics(integrator));
    }
    commands_agree(&gpu, &model, &Dynamics { ramp: 50, ..dynamics(Integrator::Euler) });
    commands_agree(&gpu, &model, &Relax { ramp: Some(60), ..relax() });
}

#[test]
fn a_simulation_settles_where_a_fold_does_and_settles_again() {
    let Some(gpu) = gpu() else { return };
    let model = made("bird-base");
    let soft = Relax { saddle_search: 0.0, ..Relax::default() };
    let solver = gpu.with(soft.clone());
    let mut ours = Simulation::new(model.clone(), solver.clone()).expect("it fits");
    let mut theirs = Simulation::new(model.clone(), soft).expect("it fits");
    for percent in [60.0, 45.0, 45.0] {
        ours.set_targets(Targets::percent(percent)).expect("targets");
        theirs.set_targets(Targets::percent(percent)).expect("targets");
        let reports = [ours.settle(20_000), theirs.settle(20_000)].map(|report| report.expect("it holds"));
        assert!(reports.iter().all(|report| report.settled && report.distance < 1e-4), "{reports:?}");
        let took = reports[0].steps as f64 / reports[1].steps as f64;
        println!("{percent} %: {} and {} evaluations", reports[0].steps, reports[1].steps);
        assert!((took - 1.0).abs() < 0.15, "{percent} %: {reports:?}");
    }
    // A drawn pin disturbs what had settled.
    let pin = ours.pin(NodeId(0)).expect("a node");
    assert!(!ours.report().settled && ours.report().distance.is_infinite());
    ours.unpin(pin).expect("a pin");
    let (ours, theirs) = (ours.finish().expect("read"), theirs.finish().expect("measured"));
    assert_eq!((ours.stop, theirs.stop), (Stop::StepsDone, Stop::Converged), "it was not left to settle again");
    assert!(largest_distance(&ours.state.positions, &theirs.state.positions) < EQUILIBRIUM);
    assert_eq!(ours.percent(), Some(45.0));
    let folded = solver.fold_from_rest(&model, 60.0).expect("it holds");
    assert!(folded.converged());
}

#[test]
fn loads_of_a_simulation_can_be_changed_and_reactions_read() {
    let Some(gpu) = gpu() else { return };
    let model = made("miura");
    let load = |z| vec![Load { node: NodeId(5), force: DVec3::Z * z }];
    let scene = Scene::default().with_support(Support::fixed(NodeId(0))).with_load(load(0.0)[0]);
    let start = State::at_rest(&model);
    let method = dynamics(Integrator::Euler);
    let mut ours =
        Simulation::in_scene(model.clone(), gpu.with(method.clone()), &scene, start.clone()).expect("it fits");
    let mut theirs = Simulation::in_scene(model.clone(), method, &scene, start).expect("it fits");
    for z in [0.02, -0.04] {
        ours.set_loads(load(z)).expect("a node that has a load");
        theirs.set_loads(load(z)).expect("a node");
        ours.step(60).expect("it holds");
        theirs.step(60).expect("it holds");
        let (one, two) = (ours.state().expect("read"), theirs.state().expect("read"));
        let far = largest_distance(&one.positions, &two.positions);
        assert!(far < TRAJECTORY, "{far} radii apart");
        let moved = largest_distance(&two.positions, &model.rest);
        println!("{far:.1e} radii apart after moving {moved:.1e}");
        assert!(moved > 10.0 * TRAJECTORY, "it moves: {moved}");
        // Those of the state that was read: the processor's own are of the evaluation before its last move.
        let scene = scene.clone().with_load(load(z)[0]);
        let mut forces = Forces::in_scene(&model, &scene);
        forces.evaluate(&two.positions, &two.targets, &mut two.fold_angles.clone());
        let (found, wanted) = (ours.reactions().expect("read"), forces.reactions());
        assert_eq!((found.len(), found[0].node), (1, NodeId(0)));
        let size = wanted[0].force.length();
        assert!(found[0].force.distance(wanted[0].force) < 1e-2 * size, "{found:?} and {wanted:?}");
    }
}

#[test]
fn a_simulation_that_diverges_says_so_and_stays_so() {
    let Some(gpu) = gpu() else { return };
    let model = made("miura");
    let method = Dynamics { time_step: TimeStep::Fixed(0.25), ..Dynamics::default() };
    let diverges = |portion: u64| {
        let start = State::perturbed(&model, 1e-2, 3);
        let scene = Scene::percent(60.0);
        let mut simulation =
            Simulation::in_scene(model.clone(), gpu.with(method.clone()), &scene, start).expect("it fits");
        for _ in 0..2000 / portion {
            if let Err(failed) = simulation.step(portion) {
                assert!(matches!(simulation.step(1), Err(Failed::Diverged(_))), "it stays so");
                let Failed::Diverged(diverged) = failed else { panic!("{failed}") };
                return (diverged.vertex, diverged.step);
            }
        }
        panic!("the step is too long");
    };
    assert_eq!(diverges(1), diverges(500));
    let theirs = method
        .fold(&model, &State::perturbed(&model, 1e-2, 3), &Scene::percent(60.0), &mut unwatched)
        .expect_err("the step is too long");
    let Failed::Diverged(theirs) = theirs else { panic!("{theirs}") };
    assert_eq!(diverges(100), (theirs.vertex, theirs.step));
}

#[test]
fn positions_lie_where_the_buffer_says() {
    let Some(gpu) = gpu() else { return };
    let model = Model::new(&origami::generate::Miura::default().pattern().expect("a pattern"), &Material::default())
        .expect("a model");
    let mut simulation = Simulation::new(model, gpu.with(Dynamics::default())).expect("it fits");
    simulation.step(3).expect("it holds");
    let buffer = simulation.engine().positions_buffer();
    assert_eq!(buffer.buffer.size(), buffer.stride * buffer.nodes as u64);
    assert_eq!((buffer.high, buffer.low, buffer.stride), (0, 16, 64), "as the documented struct in WGSL has them");
    assert_eq!(buffer.quantum, 0.000_244_140_625);
    let _ = simulation.engine().report();
}
