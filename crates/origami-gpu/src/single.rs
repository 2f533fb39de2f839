//! Numbers that a GPU cannot compute with: they are refused by their names before any work.

use std::ops::RangeInclusive;

use glam::DVec3;
use origami_core::model::{Model, StiffnessSource};
use origami_core::scene::{Load, Refusal, Scene};
use origami_core::solve::State;

use crate::error::GPU;

/// Sizes that numbers may have: f32 ends a hundred million times farther out, where what is made of them lies.
const SIZES: RangeInclusive<f64> = 1e-30..=1e30;

/// Whether a stiffness or a setting, of which 0 is none, can be computed with.
///
/// # Errors
/// [`Refusal::TooWide`] with what it is.
pub(crate) fn check(what: &str, value: f64) -> Result<(), Refusal> {
    if value == 0.0 || SIZES.contains(&value.abs()) { Ok(()) } else { Err(too_wide(what.to_owned(), value)) }
}

/// Whether a number can, of which whatever is small is next to nothing. What is no number is for the solvers to find.
fn check_size(what: impl FnOnce() -> String, value: f64) -> Result<(), Refusal> {
    if value.abs() > *SIZES.end() { Err(too_wide(what(), value)) } else { Ok(()) }
}

fn too_wide(what: String, value: f64) -> Refusal {
    Refusal::TooWide { what, value, backend: GPU, least: *SIZES.start(), most: *SIZES.end() }
}

/// All that a model brings: its material, and what its edges have of their own.
///
/// # Errors
/// As [`check`].
pub(crate) fn check_model(model: &Model) -> Result<(), Refusal> {
    let material = &model.material;
    let of_all = [
        ("material ea", material.ea),
        ("material k_fold", material.k_fold),
        ("material k_facet", material.k_facet),
        ("material k_face", material.k_face),
        ("material zeta", material.zeta),
        ("material collapse", material.collapse),
    ];
    of_all.into_iter().try_for_each(|(what, value)| check(what, value))?;
    for beam in model.beams.iter().filter(|beam| beam.own) {
        let [a, b] = beam.nodes;
        check(&format!("ea of the edge from node {} to node {}", a.0, b.0), beam.stiffness * beam.rest_length)?;
    }
    for (i, crease) in model.creases.iter().enumerate().filter(|(_, crease)| crease.source == StiffnessSource::Own) {
        let [_, _, a, b] = crease.nodes;
        check(&format!("stiffness of crease {i}, from node {} to node {}", a.0, b.0), crease.stiffness)?;
    }
    Ok(())
}

/// All that a scene brings, on the way to `targets`.
///
/// # Errors
/// As [`check`].
pub(crate) fn check_scene(scene: &Scene, targets: &[f64]) -> Result<(), Refusal> {
    check_targets(targets)?;
    let positions = scene.supports.iter().map(|support| support.position.unwrap_or_default());
    check_vectors("supports", positions)?;
    check_loads(&scene.loads)
}

/// Target angles.
///
/// # Errors
/// As [`check`].
pub(crate) fn check_targets(targets: &[f64]) -> Result<(), Refusal> {
    check_numbers("targets", targets)
}

/// Forces of loads.
///
/// # Errors
/// As [`check`].
pub(crate) fn check_loads(loads: &[Load]) -> Result<(), Refusal> {
    check_vectors("loads", loads.iter().map(|load| load.force))
}

fn check_vectors(what: &str, vectors: impl Iterator<Item = DVec3>) -> Result<(), Refusal> {
    for (i, vector) in vectors.enumerate() {
        vector.to_array().into_iter().try_for_each(|x| check_size(|| format!("{what}[{i}]"), x))?;
    }
    Ok(())
}

fn check_numbers(what: &str, numbers: &[f64]) -> Result<(), Refusal> {
    numbers.iter().enumerate().try_for_each(|(i, x)| check_size(|| format!("{what}[{i}]"), *x))
}

/// Where a node is to be.
///
/// # Errors
/// As [`check`].
pub(crate) fn check_position(position: DVec3) -> Result<(), Refusal> {
    position.to_array().into_iter().try_for_each(|x| check_size(|| "position".to_owned(), x))
}

/// All that a state brings in which a sheet begins.
///
/// # Errors
/// As [`check`].
pub(crate) fn check_start(start: &State) -> Result<(), Refusal> {
    check_vectors("start positions", start.positions.iter().copied())?;
    check_vectors("start velocities", start.velocities.iter().copied())?;
    check_numbers("start fold_angles", &start.fold_angles)?;
    check_numbers("start targets", &start.targets)
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use origami_core::generate::BirdBase;
    use origami_core::ids::NodeId;
    use origami_core::pattern::CreasePattern;
    use origami_core::scene::{Support, Targets};
    use origami_core::solve::{Failed, Instance, Simulation, TimeStep, unwatched};
    use origami_core::{Dynamics, Material, Relax, Solver};

    use super::*;
    use crate::testing::gpu;
    use crate::{Dispatch, Gpu};

    const WIDE: [f64; 2] = [1e39, -1e31];

    fn bird(change: &dyn Fn(&mut CreasePattern), material: &Material) -> Model {
        let mut pattern = BirdBase::default().pattern().expect("a pattern");
        change(&mut pattern);
        Model::new(&pattern, material).expect("a model")
    }

    fn plain() -> Model {
        bird(&|_| {}, &Material::default())
    }

    /// What a solver says that is about to be given such a sheet, on every way and by every entrance; all say the same.
    fn told<S: crate::GpuMethod + Clone>(gpu: &Gpu, method: &S, instance: &Instance<'_>) -> String {
        let mut told = Vec::new();
        for dispatch in Dispatch::WAYS.iter().chain(&[Dispatch::Auto]) {
            let solver = gpu.with(method.clone()).dispatch(*dispatch);
            let folded = solver.fold(instance.model, &instance.start, &instance.scene, &mut unwatched);
            let all = solver.fold_all(std::slice::from_ref(instance), &|_, _| ControlFlow::Continue(()));
            let start = instance.start.clone();
            let begun = Simulation::in_scene(instance.model.clone(), solver, &instance.scene, start).map(|_| ());
            let failures = [folded.map(|_| ()), all.into_iter().next().expect("one").map(|_| ()), begun];
            told.extend(failures.map(|failed| match failed {
                Err(failed @ Failed::Refused { .. }) => failed.to_string(),
                other => panic!("{other:?}"),
            }));
        }
        told.dedup();
        assert_eq!(told.len(), 1, "{told:?}");
        told.remove(0)
    }

    #[test]
    fn every_number_that_is_too_wide_is_refused_by_its_name() {
        let Some(gpu) = gpu() else { return };
        let relax = Relax { steps: Some(20), ..Relax::default() };
        let usual = Material::default();
        let models = [
            ("material ea", bird(&|_| {}, &Material { ea: 1e39, ..usual })),
            ("material k_fold", bird(&|_| {}, &Material { k_fold: 1e300, ..usual })),
            ("material k_facet", bird(&|_| {}, &Material { k_facet: 1e-40, ..usual })),
            ("material k_face", bird(&|_| {}, &Material { k_face: 1e31, ..usual })),
            ("material zeta", bird(&|_| {}, &Material { zeta: 1e39, ..usual })),
            ("material collapse", bird(&|_| {}, &Material { collapse: 1e39, ..usual })),
            ("ea of the edge from node ", bird(&|p| p.edges[0].ea = Some(1e39), &usual)),
            ("stiffness of crease ", bird(&|p| p.edges.iter_mut().for_each(|e| e.k_crease = Some(1e39)), &usual)),
        ];
        for (what, model) in &models {
            let instance = Instance { model, start: State::at_rest(model), scene: Scene::percent(30.0) };
            let told = told(&gpu, &relax, &instance);
            assert!(told.starts_with(what) && told.contains("a GPU computes in f32"), "{what}: {told}");
        }

        let model = plain();
        let at_rest = || State::at_rest(&model);
        let node = NodeId(1);
        for wide in WIDE {
            let far = DVec3::new(0.0, wide, 0.0);
            let mut angles = model.targets(30.0);
            angles[2] = wide;
            let scenes = [
                ("targets[", Scene::new(Targets::angles(angles))),
                (
                    "loads[0]",
                    Scene::percent(30.0).with_support(Support::fixed(node)).with_load(Load { node, force: far }),
                ),
                ("supports[0]", Scene::percent(30.0).with_support(Support::fixed(node).at(far))),
            ];
            for (what, scene) in scenes {
                let told = told(&gpu, &relax, &Instance { model: &model, start: at_rest(), scene });
                assert!(told.starts_with(what), "{what}: {told}");
            }
            let mut start = at_rest();
            start.positions[3] = far;
            let told = told(&gpu, &relax, &Instance { model: &model, start, scene: Scene::percent(30.0) });
            assert!(told.starts_with("start positions[3]"), "{told}");
        }
        for (what, method) in [
            ("tolerance", Dynamics { tolerance: 1e-50, ..Dynamics::default() }),
            ("time step", Dynamics { time_step: TimeStep::Fixed(1e39), ..Dynamics::default() }),
        ] {
            let instance = Instance { model: &model, start: at_rest(), scene: Scene::percent(30.0) };
            let told = told(&gpu, &method, &instance);
            assert!(told.starts_with(what), "{what}: {told}");
        }
    }

    #[test]
    fn a_simulation_refuses_what_comes_later() {
        let Some(gpu) = gpu() else { return };
        let model = plain();
        let (node, far) = (NodeId(1), DVec3::new(1e39, 0.0, 0.0));
        let scene = Scene::percent(30.0).with_load(Load { node, force: DVec3::ZERO });
        let at_rest = State::at_rest(&model);
        let mut simulation =
            Simulation::in_scene(model, gpu.with(Dynamics::default()), &scene, at_rest).expect("it fits");
        simulation.step(20).expect("it holds");
        let told = |result: Result<(), Failed>| result.expect_err("too wide").to_string();
        assert!(told(simulation.set_targets(Targets::percent(1e39))).starts_with("targets["));
        assert!(told(simulation.set_loads(vec![Load { node, force: far }])).starts_with("loads[0]"));
        let pin = simulation.pin(node).expect("a node of the sheet");
        assert!(told(simulation.move_pin(pin, far)).starts_with("position"));
        simulation.step(20).expect("it goes on");
    }

    #[test]
    fn nothing_is_no_number_and_small_parts_of_vectors_are_next_to_nothing() {
        assert_eq!(check("k_face", 0.0), Ok(()));
        assert!(
            check("k_face", 1e-31).is_err() && check("k_face", 1e-29).is_ok() && check("k_face", f64::NAN).is_err()
        );
        let load = Load { node: NodeId(0), force: DVec3::new(1e-300, -1.0, 0.0) };
        assert_eq!(check_scene(&Scene::percent(10.0).with_load(load), &[1e-200]), Ok(()));
        assert_eq!(check_model(&plain()), Ok(()));
    }
}
