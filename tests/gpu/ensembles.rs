//! Many sheets at once.

use std::ops::ControlFlow;

use origami::generate::BirdBase;
use origami::gpu::{Dispatch, Gpu, GpuMethod};
use origami::scene::Scene;
use origami::solve::unwatched;
use origami::solve::{Failed, Instance, Integrator, TimeStep};
use origami::{Dynamics, Material, Model, Relax, Solver};

use crate::common::gpu::gpu;
use crate::sheets::{EQUILIBRIUM, HELD, TRAJECTORY, WAYS, apart, folded, relax, sheet, start};

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
