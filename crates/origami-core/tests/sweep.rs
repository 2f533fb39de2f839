//! Many sheets of one pattern: which there are, and that each is folded as if it were alone.
#![expect(clippy::unwrap_used, reason = "a test may")]

use origami_core::generate::{BirdBase, SingleCrease, miura};
use origami_core::model::MaterialGrid;
use origami_core::scene::Scene;
use origami_core::solve::unwatched;
use origami_core::solve::{Dynamics, Failed, Point, Sweep, TimeStep};
use origami_core::{CreasePattern, Folded, Material, Model, Relax, Solver, State};
use std::ops::ControlFlow;

/// A solver that takes the perturbation that its instances bring.
fn relax() -> Relax {
    Relax { perturbation: 0.0, ..Relax::default() }
}

fn sweep() -> Sweep {
    let materials = MaterialGrid { k_fold: vec![0.1, 7.0], k_face: vec![0.0, 0.2], ..MaterialGrid::default() };
    Sweep {
        percents: vec![60.0, 0.0, -30.0],
        materials: materials.materials(),
        perturbations: vec![3e-3, 0.0],
        seeds: 2,
    }
}

fn fold(pattern: &CreasePattern, sweep: &Sweep, solver: &dyn Solver, threads: usize) -> Vec<Result<Folded, Failed>> {
    let models = Model::of_each(pattern, &sweep.materials).unwrap();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| solver.fold_all(&sweep.instances(&models), &|_, _| ControlFlow::Continue(())))
}

/// All that can differ, to the bit (`==` takes 0 and -0 for one).
fn bits(folded: &Folded) -> (Vec<u64>, u64, u32, u64, u64) {
    let State { positions, velocities, fold_angles, targets } = &folded.state;
    let vectors = positions.iter().chain(velocities).flat_map(|p| p.to_array());
    let numbers = vectors.chain(fold_angles.iter().chain(targets).copied()).map(f64::to_bits).collect();
    (numbers, folded.steps, folded.attempts, folded.residual.to_bits(), folded.distance.to_bits())
}

#[test]
fn points_come_in_the_documented_order() {
    let sweep = sweep();
    let points: Vec<Point> = sweep.points().collect();
    assert_eq!(points.len(), 4 * 2 * 2 * 3);
    let mut expected = Vec::new();
    for material in 0..4 {
        for perturbation in [3e-3, 0.0] {
            for seed in 0..2 {
                for percent in [60.0, 0.0, -30.0] {
                    expected.push(Point { material, perturbation, seed, percent });
                }
            }
        }
    }
    assert_eq!(points, expected);
    let model = Model::new(&miura(2, 2).unwrap(), &Material::default()).unwrap();
    let models = vec![model; 4];
    let instances = sweep.instances(&models);
    assert!(instances.iter().zip(&points).all(|(i, p)| i.scene.targets.label() == Some(p.percent)));
    assert!(instances.iter().zip(&points).all(|(i, p)| std::ptr::eq(i.model, &raw const models[p.material])));
}

#[test]
fn by_default_there_is_one_and_an_empty_list_leaves_none() {
    assert_eq!(Sweep::default().points().count(), 1);
    assert_eq!(Sweep { percents: Vec::new(), ..Sweep::default() }.points().count(), 0);
    assert_eq!(Sweep { seeds: 0, ..Sweep::default() }.points().count(), 0);
}

#[test]
fn models_of_each_material_are_those_made_one_by_one() {
    let pattern = BirdBase::default().pattern().unwrap();
    let materials = sweep().materials;
    let models = Model::of_each(&pattern, &materials).unwrap();
    for (model, material) in models.iter().zip(&materials) {
        let alone = Model::new(&pattern, material).unwrap();
        assert_eq!(format!("{model:?}"), format!("{alone:?}"));
    }
    let bad = [Material::default(), Material { ea: -1.0, ..materials[0] }, Material { ea: -2.0, ..materials[0] }];
    let error = Model::of_each(&pattern, &bad).unwrap_err().to_string();
    assert_eq!(error, Model::new(&pattern, &bad[1]).unwrap_err().to_string(), "the first of two errors");
}

#[test]
fn all_at_once_is_one_by_one_to_the_bit_on_any_number_of_threads() {
    let pattern = BirdBase::default().pattern().unwrap();
    let sweep = sweep();
    let dynamics = Dynamics { steps: Some(300), ..Dynamics::default() };
    for solver in [&relax() as &dyn Solver, &dynamics] {
        let alone: Vec<_> = { sweep.points() }
            .map(|point| {
                let model = Model::new(&pattern, &sweep.materials[point.material]).unwrap();
                let start = point.instance(&model).start;
                bits(&solver.fold(&model, &start, &Scene::percent(point.percent), &mut unwatched).unwrap())
            })
            .collect();
        for threads in [1, 2, 5] {
            let all = fold(&pattern, &sweep, solver, threads);
            let all: Vec<_> = all.into_iter().map(|folded| bits(&folded.unwrap())).collect();
            assert!(all == alone, "{threads} threads");
        }
        assert!(alone[0] != alone[3] && alone[0] != alone[6], "seeds and perturbations make a difference");
    }
}

#[test]
fn seed_0_is_the_perturbation_of_relax() {
    let pattern = BirdBase::default().pattern().unwrap();
    let model = Model::new(&pattern, &Material::default()).unwrap();
    for perturbation in [0.0, 1e-3, 3e-3] {
        let sweep = Sweep { percents: vec![70.0], perturbations: vec![perturbation], ..Sweep::default() };
        let folded = fold(&pattern, &sweep, &relax(), 1).remove(0).unwrap();
        let alone = Relax { perturbation, ..Relax::default() }.fold_from_rest(&model, 70.0).unwrap();
        assert!(bits(&folded) == bits(&alone), "{perturbation}");
    }
}

#[test]
fn a_flat_sheet_at_0_percent_stays_flat() {
    let pattern = miura(3, 3).unwrap();
    let sweep = Sweep { percents: vec![0.0], perturbations: vec![0.1], seeds: 3, ..Sweep::default() };
    let model = Model::new(&pattern, &Material::default()).unwrap();
    for folded in fold(&pattern, &sweep, &relax(), 2) {
        let positions = folded.unwrap().state.positions;
        assert!(positions.iter().all(|p| p.z == 0.0), "{positions:?}");
        assert!(positions.iter().zip(&model.rest).all(|(p, rest)| p.distance(*rest) < 1e-14), "but for rounding");
    }
    assert_ne!(State::perturbed(&model, 0.1, 0).positions, model.rest);
    assert_eq!(State::perturbed(&model, 0.0, 1), State::at_rest(&model));
}

#[test]
fn fixed_nodes_are_not_moved() {
    let mut pattern = miura(3, 3).unwrap();
    pattern.fixed = vec![origami_core::ids::VertexId(4)];
    let model = Model::new(&pattern, &Material::default()).unwrap();
    let moved = State::perturbed(&model, 0.1, 5).positions;
    let stays: Vec<usize> = (0..moved.len()).filter(|n| moved[*n] == model.rest[*n]).collect();
    assert_eq!(stays, [4]);
}

#[test]
fn one_that_diverges_takes_none_with_it() {
    let pattern = SingleCrease::default().pattern().unwrap();
    // The same step is far too long for stiff paper only.
    let solver = Dynamics { time_step: TimeStep::Fixed(0.05), steps: Some(200), ..Dynamics::default() };
    let materials = MaterialGrid { ea: vec![20.0, 1e6, 30.0], ..MaterialGrid::default() }.materials();
    let sweep = Sweep { materials, perturbations: vec![1e-3], percents: vec![40.0, 50.0], ..Sweep::default() };
    let all = fold(&pattern, &sweep, &solver, 3);
    let held: Vec<bool> = all.iter().map(Result::is_ok).collect();
    assert_eq!(held, [true, true, false, false, true, true]);
    assert!(matches!(all[2], Err(Failed::Diverged(_))));
    let mild = Sweep { materials: vec![sweep.materials[2]], ..sweep };
    let alone = fold(&pattern, &mild, &solver, 1);
    assert!(bits(all[5].as_ref().unwrap()) == bits(alone[1].as_ref().unwrap()));
}
