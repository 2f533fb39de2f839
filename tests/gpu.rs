//! The solvers on a GPU against those on the processor, through the public interface.
#![cfg(feature = "gpu")]

mod common;

use common::gpu::gpu;
use common::largest_distance;
use origami::generate::{BirdBase, Fan, Kresling, Miura, Waterbomb};
use origami::glam::DVec3;
use origami::gpu::{Dispatch, Gpu, GpuMethod};
use origami::ids::VertexId;
use origami::pattern::Assignment;
use origami::scene::Scene;
use origami::solve::unwatched;
use origami::solve::{Failed, Instance, Integrator, TimeStep, fold_path};
use origami::{CreasePattern, Dynamics, Folded, Material, Model, Relax, Solver, State};
use std::ops::ControlFlow;

/// How far trajectories of 300 steps may be apart, in radii. Forces come in single precision, 1e-7 of their size each, and
/// positions are kept to 1e-11: 1e-7 of a motion of 1 with damping, some 1e-6 without, where nothing forgets an error.
const TRAJECTORY: f64 = 5e-6;

/// And their velocities: an error vibrates with the frequency of a short beam, sqrt(2 EA / l), here some 10.
const VELOCITY: f64 = 10.0 * TRAJECTORY;

/// How far equilibria may be apart, in radii: both solvers stop within 1e-4 of it, where soft directions count for more.
const EQUILIBRIUM: f64 = 1e-3;

/// By how much their energies may differ, relative to the energy to be released.
const ENERGY: f64 = 1e-4;

/// How far a position is from the one that buffers hold, in radii.
const HELD: f64 = 1e-11;

const STEPS: u64 = 300;

const WAYS: &[Dispatch] = Dispatch::WAYS;

/// What shaders have of it: neither clusters of near nodes nor the search for saddles nor Newton's method.
fn relax() -> Relax {
    Relax { near: 0.0, saddle_search: 0.0, hand_over: None, ..Relax::default() }
}

fn built(pattern: &CreasePattern, material: Material) -> Model {
    Model::new(pattern, &material).expect("a model")
}

fn miura(columns: usize, rows: usize) -> CreasePattern {
    Miura { columns, rows, ..Miura::default() }.pattern().expect("a pattern")
}

/// A square grid of which two neighbouring inner edges are cut.
fn with_slit() -> CreasePattern {
    let side = 5_u32;
    let (mut edges, mut letters) = (Vec::new(), Vec::new());
    for here in 0..side * side {
        let (row, column) = (here / side, here % side);
        if column + 1 < side {
            let cut = row == 2 && (column == 1 || column == 2);
            let inner = row > 0 && row + 1 < side;
            edges.push(format!("[{here},{}]", here + 1));
            letters.push(if cut {
                "C"
            } else if !inner {
                "B"
            } else if (row + column) % 2 == 0 {
                "M"
            } else {
                "V"
            });
        }
        if row + 1 < side {
            let inner = column > 0 && column + 1 < side;
            edges.push(format!("[{here},{}]", here + side));
            letters.push(if !inner {
                "B"
            } else if column % 2 == 0 {
                "M"
            } else {
                "V"
            });
        }
    }
    let points: Vec<String> = (0..side * side).map(|i| format!("[{},{}]", i % side, i / side)).collect();
    let text = format!(
        r#"{{"vertices_coords":[{}],"edges_vertices":[{}],"edges_assignment":["{}"]}}"#,
        points.join(","),
        edges.join(","),
        letters.join("\",\"")
    );
    let document = origami::fold::Document::from_slice(text.as_bytes()).expect("a document");
    CreasePattern::from_document(&document, 0).expect("a pattern")
}

/// A Miura with two beams to a point outside any face, one of its own rigidity.
fn with_loose_beams() -> CreasePattern {
    let mut pattern = miura(3, 3);
    let out = pattern.vertices.len() as u32;
    let apart = DVec3::new(-0.7, -0.4, 0.3);
    pattern.vertices.push(pattern.vertices[0] + apart);
    let mut edges = [(0, out), (1, out)].map(|(a, b)| common::edge(a, b, Assignment::Boundary, None));
    edges[1].ea = Some(5.0);
    pattern.edges.extend(edges);
    common::pattern(pattern.vertices, pattern.edges, &[]).with_faces(pattern.faces)
}

trait WithFaces {
    fn with_faces(self, faces: Vec<Vec<VertexId>>) -> Self;
}

impl WithFaces for CreasePattern {
    fn with_faces(self, faces: Vec<Vec<VertexId>>) -> Self {
        Self { faces, ..self }
    }
}

/// Fixed vertices, stiffnesses of edges' own, and creases that nothing drives.
fn with_own_springs() -> CreasePattern {
    let mut pattern = miura(4, 4);
    pattern.fixed = vec![VertexId(0), VertexId(6)];
    for (i, edge) in pattern.edges.iter_mut().enumerate() {
        match i % 4 {
            0 => edge.k_crease = Some(2.0),
            1 => edge.ea = Some(35.0),
            2 => edge.fold_angle = None,
            _ => {}
        }
    }
    pattern
}

/// What is compared: a sheet of every kind that the pipelines are built for.
fn sheets() -> Vec<(&'static str, Model)> {
    let plain = Material::default();
    vec![
        ("miura", built(&miura(5, 4), plain)),
        ("bird base", built(&BirdBase::default().pattern().expect("a pattern"), plain)),
        ("kresling", built(&Kresling::default().pattern().expect("a pattern"), plain)),
        ("waterbomb", built(&Waterbomb::default().pattern().expect("a pattern"), plain)),
        ("fan", built(&Fan::default().pattern().expect("a pattern"), plain)),
        ("slit", built(&with_slit(), plain)),
        ("loose beams", built(&with_loose_beams(), plain)),
        ("own springs", built(&with_own_springs(), plain)),
        ("k_face 0", built(&miura(4, 3), Material { k_face: 0.0, ..plain })),
        ("k_fold 0", built(&Kresling::default().pattern().expect("a pattern"), Material { k_fold: 0.0, ..plain })),
        ("zeta 0", built(&miura(3, 4), Material { zeta: 0.0, ..plain })),
    ]
}

fn sheet(wanted: &str) -> Model {
    sheets().into_iter().find(|(name, _)| *name == wanted).expect("one of this name").1
}

/// Off the plane, so that every force is at work from the first step.
fn start(model: &Model) -> State {
    let mut state = State::perturbed(model, 1e-2, 3);
    for node in &model.fixed {
        state.positions[node.index()] = model.rest[node.index()];
    }
    state
}

fn folded(solver: &dyn Solver, model: &Model, percent: f64) -> Folded {
    solver.fold(model, &start(model), &Scene::percent(percent), &mut unwatched).expect("it holds")
}

fn apart(a: &State, b: &State) -> f64 {
    largest_distance(&a.positions, &b.positions)
}

/// Ways to step through time. The paper's step does not hold on every sheet: where it does not, the safe one is taken.
fn ways() -> [(Dynamics, Dispatch); 7] {
    let (steps, plain) = (Some(STEPS), Dynamics::default());
    let (safe, verlet) = (TimeStep::Safe, Integrator::Verlet);
    [
        (Dynamics { steps, ..plain.clone() }, Dispatch::Passes),
        (Dynamics { steps, time_step: safe, ramp: 90, ..plain.clone() }, Dispatch::Workgroup),
        (Dynamics { steps, time_step: safe, integrator: verlet, ..plain.clone() }, Dispatch::Passes),
        (Dynamics { steps, time_step: safe, integrator: verlet, ramp: 130, ..plain.clone() }, Dispatch::Workgroup),
        (Dynamics { steps, ..plain.clone() }, Dispatch::Blocks),
        (Dynamics { steps, time_step: safe, ramp: 90, ..plain.clone() }, Dispatch::Blocks),
        (Dynamics { steps, time_step: safe, integrator: verlet, ramp: 130, ..plain }, Dispatch::Blocks),
    ]
}

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

fn instances(models: &[Model]) -> Vec<Instance<'_>> {
    let percents = [20.0, 55.0, 80.0].into_iter().cycle();
    models
        .iter()
        .zip(percents)
        .map(|(model, percent)| Instance { model, start: start(model), scene: Scene::percent(percent) })
        .collect()
}

/// Whether each of an ensemble is what it is alone, on the same adapter and by the same passes.
fn same_as_alone<S: GpuMethod + Clone>(gpu: &Gpu, method: &S, dispatch: Dispatch, instances: &[Instance<'_>]) {
    let solver = gpu.with(method.clone()).dispatch(dispatch);
    let all = solver.fold_all(instances, &|_, _| ControlFlow::Continue(()));
    assert_eq!(all.len(), instances.len());
    for (i, (instance, together)) in instances.iter().zip(all).enumerate() {
        let alone = solver.fold(instance.model, &instance.start, &instance.scene, &mut unwatched).expect("it holds");
        let together = together.expect("it holds");
        assert_eq!((together.targets, together.steps, together.stop), (alone.targets, alone.steps, alone.stop), "{i}");
        let far = apart(&together.state, &alone.state);
        assert!(far < TRAJECTORY, "instance {i}: {far} radii apart");
    }
}

#[test]
fn ensembles_are_what_their_sheets_are_alone() {
    let Some(gpu) = gpu() else { return };
    let plain = Material::default();
    let materials = [
        plain,
        Material { k_fold: 3.0, ..plain },
        Material { ea: 60.0, zeta: 0.2, ..plain },
        // Springs in other places: scenes of their own.
        Material { k_fold: 0.0, ..plain },
        Material { k_face: 0.0, k_facet: 2.0, ..plain },
        Material { zeta: 0.0, ..plain },
    ];
    let pattern = BirdBase::default().pattern().expect("a pattern");
    let models = Model::of_each(&pattern, &materials).expect("models");
    let instances = instances(&models);
    let dynamics = Dynamics { steps: Some(100), time_step: TimeStep::Safe, ramp: 40, ..Dynamics::default() };
    let relax = Relax { steps: Some(100), ramp: Some(40), ..relax() };
    for dispatch in WAYS.iter().copied() {
        same_as_alone(&gpu, &dynamics, dispatch, &instances);
        same_as_alone(&gpu, &relax, dispatch, &instances);
    }
}

#[test]
fn ensembles_converge_as_on_the_processor() {
    let Some(gpu) = gpu() else { return };
    let pattern = BirdBase::default().pattern().expect("a pattern");
    let plain = Material::default();
    let models = Model::of_each(&pattern, &[plain, Material { k_fold: 2.0, ..plain }]).expect("models");
    let percents = [0.0, 25.0, 50.0, 75.0];
    let of = |model| percents.map(|percent| Instance { model, start: start(model), scene: Scene::percent(percent) });
    let instances: Vec<Instance<'_>> = models.iter().flat_map(of).collect();
    let (ours, theirs) = (
        gpu.with(relax()).fold_all(&instances, &|_, _| ControlFlow::Continue(())),
        relax().fold_all(&instances, &|_, _| ControlFlow::Continue(())),
    );
    for ((instance, ours), theirs) in instances.iter().zip(ours).zip(theirs) {
        let (ours, theirs) = (ours.expect("it holds"), theirs.expect("it holds"));
        let far = apart(&ours.state, &theirs.state);
        let asked = instance.scene.targets.label();
        println!("{asked:?} %: {far:.1e} radii apart, {} and {} evaluations", ours.steps, theirs.steps);
        assert!(ours.converged() && theirs.converged() && far < EQUILIBRIUM, "{asked:?} %: {far}");
        // At rest but for rounding, and told so as soon.
        assert!(ours.steps < theirs.steps + theirs.steps / 5, "{} and {} evaluations", ours.steps, theirs.steps);
    }
}

#[test]
fn one_that_diverges_does_not_disturb_the_others() {
    let Some(gpu) = gpu() else { return };
    let pattern = BirdBase::default().pattern().expect("a pattern");
    let plain = Material::default();
    // The same step is far too long for a sheet this stiff.
    let models = Model::of_each(&pattern, &[plain, Material { ea: 20_000.0, ..plain }, plain]).expect("models");
    let instances = instances(&models);
    let step = origami::solve::time_step::paper(&models[0]);
    let method = Dynamics { time_step: TimeStep::Fixed(step), steps: Some(250), ..Dynamics::default() };
    for dispatch in WAYS.iter().copied() {
        let ours = gpu.with(method.clone()).dispatch(dispatch).fold_all(&instances, &|_, _| ControlFlow::Continue(()));
        let theirs = method.fold_all(&instances, &|_, _| ControlFlow::Continue(()));
        for place in [0, 2] {
            let [ours, theirs] = [&ours, &theirs].map(|all| &all[place].as_ref().expect("it holds").state);
            assert!(apart(ours, theirs) < TRAJECTORY, "instance {place}");
        }
        let [Err(Failed::Diverged(ours)), Err(Failed::Diverged(theirs))] = [&ours[1], &theirs[1]] else {
            panic!("a divergence expected of the second")
        };
        assert_eq!((ours.vertex, ours.step, ours.quantity), (theirs.vertex, theirs.step, theirs.quantity));
        assert!(apart(&ours.last_good, &instances[1].start) < HELD, "it began with its last good state");
    }
}

#[test]
fn nothing_at_all_is_no_mistake() {
    let Some(gpu) = gpu() else { return };
    let model = sheet("miura");
    assert!(gpu.with(relax()).fold_all(&[], &|_, _| ControlFlow::Continue(())).is_empty());
    for dispatch in WAYS.iter().copied() {
        let none = gpu.with(Dynamics { steps: Some(0), integrator: Integrator::Verlet, ..Dynamics::default() });
        let folded = folded(&none.dispatch(dispatch), &model, 50.0);
        assert_eq!(folded.steps, 0);
        assert!(apart(&folded.state, &start(&model)) < HELD);
        assert!(folded.residual > 0.0 && folded.state.targets == model.targets(50.0));
    }
}

#[test]
fn the_report_tells_what_was_built() {
    let Some(gpu) = gpu() else { return };
    let names = |model: &Model, dispatch| {
        let inventory = gpu.with(relax()).dispatch(dispatch).inventory(model);
        let built: Vec<&str> = inventory.built.iter().map(|built| built.what).collect();
        let left_out: Vec<&str> = inventory.left_out.iter().map(|left_out| left_out.what).collect();
        (built.join(", "), left_out.join(", "))
    };
    let (built, left_out) = names(&sheet("loose beams"), Dispatch::Passes);
    assert!(built.contains("pass of loose beams") && built.contains("passes over all elements"), "{built}");
    assert!(!left_out.contains("pass of loose beams"), "{left_out}");
    assert!(built.contains("areas") && !left_out.contains("areas"), "{built}");
    let (built, left_out) = names(&sheet("k_face 0"), Dispatch::Workgroup);
    assert!(built.contains("passes in one workgroup"), "{built}");
    assert!(left_out.contains("corner angles") && left_out.contains("damping"), "{left_out}");
    let (built, _) = names(&sheet("loose beams"), Dispatch::Workgroup);
    assert!(built.contains("in one workgroup") && built.contains("loose beams in blocks"), "{built}");
    let (built, left_out) = names(&sheet("loose beams"), Dispatch::Blocks);
    assert!(built.contains("blocks of nodes") && built.contains("loose beams in blocks"), "{built}");
    assert!(!left_out.contains("loose beams"), "{left_out}");
}
