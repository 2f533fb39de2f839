//! Every lane against the plain forces.

mod counting;
mod floors;
mod timing;

pub(super) use counting::Counting;

use glam::DVec3;

use super::isa::{Compute, Isa};
use super::{Bounds, Kernel};
use crate::forces::{Forces, damping};
use crate::generate::catalog;
use crate::ids::VertexId;
use crate::model::{Material, Model, Softening};
use crate::pattern::{Assignment, PatternEdge};
use crate::scene::{Held, Scene};
use crate::twins::fire_update::Decision;

const BOUNDS: Bounds = Bounds { farthest: 100.0, longest_move: 1.0 };

/// Numbers from -1 to 1.
fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut bits = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    move || {
        bits ^= bits << 13;
        bits ^= bits >> 7;
        bits ^= bits << 17;
        (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A state of a model away from rest.
struct Case {
    model: Model,
    positions: Vec<DVec3>,
    velocities: Vec<DVec3>,
    angles: Vec<f64>,
    targets: Vec<f64>,
}

impl Case {
    fn new(model: Model, seed: u64, far: f64) -> Self {
        let mut random = random(seed);
        let mut vector = || DVec3::new(random(), random(), random());
        let positions: Vec<DVec3> = model.rest.iter().map(|p| *p + far * vector()).collect();
        let velocities = positions.iter().map(|_| vector()).collect();
        let angles = model.creases.iter().map(|_| 20.0 * vector().x).collect();
        let targets = model.creases.iter().map(|_| 3.0 * vector().x).collect();
        Self { model, positions, velocities, angles, targets }
    }

    /// Forces by node and angles by crease, by the plain formulas.
    fn plain(&self, damped: bool) -> (Vec<DVec3>, Vec<f64>) {
        let mut angles = self.angles.clone();
        let mut forces = Forces::new(&self.model);
        let values = forces.evaluate(&self.positions, &self.targets, &mut angles);
        if damped {
            // What is held does not move.
            let (mut velocities, held) = (self.velocities.clone(), Held::new(&self.model, &Scene::default()));
            held.clear(&mut velocities);
            damping::add(&self.model, &velocities, values);
        }
        (values.to_vec(), angles)
    }

    fn kernel<R: Compute>(&self, isa: Isa) -> Kernel<R> {
        self.shared(isa, 1)
    }

    fn shared<R: Compute>(&self, isa: Isa, threads: usize) -> Kernel<R> {
        let mut kernel = Kernel::<R>::with(
            (isa, threads),
            &self.model,
            true,
            BOUNDS,
            &self.positions,
            &self.velocities,
            &self.angles,
        );
        kernel.set_targets(self.targets.iter().copied());
        kernel
    }

    fn fast<R: Compute>(&self, isa: Isa, damped: bool) -> (Vec<DVec3>, Vec<f64>) {
        let mut kernel = self.kernel::<R>(isa);
        kernel.springs(damped);
        let (forces, mut angles) = (kernel.positions_and_forces().map(|[_, f]| f).collect(), self.angles.clone());
        kernel.read_angles(&mut angles);
        (forces, angles)
    }
}

/// The largest difference of two lists of vectors as a share of the largest vector.
fn difference(a: &[DVec3], b: &[DVec3]) -> f64 {
    let largest = a.iter().map(|v| v.length()).fold(0.0, f64::max);
    a.iter().zip(b).map(|(a, b)| (*a - *b).length()).fold(0.0, f64::max) / largest
}

fn check(scene: &Case, what: &str, exact: f64, mixed: f64) {
    for damped in [false, true] {
        let (forces, angles) = scene.plain(damped);
        for isa in Isa::all() {
            for (limit, fast) in [(exact, scene.fast::<f64>(isa, damped)), (mixed, scene.fast::<f32>(isa, damped))] {
                let off = difference(&forces, &fast.0);
                assert!(off < limit, "{what}, {isa:?}: forces differ by {off}");
                let turned = angles.iter().zip(&fast.1).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(turned < 10.0 * limit, "{what}, {isa:?}: angles differ by {turned}");
            }
        }
    }
}

#[test]
fn nothing_pulls_at_a_flat_sheet_at_rest() {
    let still =
        |name: &str, forces: &[DVec3], isa: Isa| assert!(forces.iter().all(|f| *f == DVec3::ZERO), "{name}, {isa:?}");
    let mut flat = 0;
    for name in catalog::names() {
        let pattern = catalog::generate(name, &[]).expect("default parameters");
        let model = Model::new(&pattern, &Material::default()).expect("a model");
        if model.rest.iter().any(|p| p.z != 0.0) {
            continue;
        }
        flat += 1;
        let (positions, velocities) = (model.rest.clone(), vec![DVec3::ZERO; model.node_count()]);
        let angles = vec![0.0; model.creases.len()];
        let scene = Case { targets: angles.clone(), model, positions, velocities, angles };
        for isa in Isa::all() {
            still(name, &scene.fast::<f64>(isa, true).0, isa);
            still(name, &scene.fast::<f32>(isa, true).0, isa);
        }
    }
    assert!(flat > 10, "{flat} flat sheets");
}

#[test]
fn every_lane_has_the_plain_forces() {
    for entry in catalog::entries() {
        let pattern = catalog::generate(entry.name, &[]).expect("a pattern");
        for material in [Material::default(), Material { k_face: 0.0, zeta: 0.0, ..Material::default() }] {
            let model = Model::new(&pattern, &material).expect("a model");
            for (seed, far) in [(1, 1e-3), (2, 0.03), (3, 0.3)] {
                check(&Case::new(model.clone(), seed, far), entry.name, 1e-10, 1e-3);
            }
        }
    }
}

/// A Miura sheet with nodes held, stiffnesses of its own, and a rod outside any face.
fn odd_sheet() -> Model {
    let mut pattern = crate::generate::miura(5, 4).expect("valid");
    pattern.fixed = vec![VertexId(0), VertexId(7)];
    pattern.edges[3].ea = Some(3.0);
    pattern.edges[8].k_crease = Some(5.0);
    let end = VertexId::new(pattern.vertices.len());
    pattern.vertices.push(pattern.vertices[0] + DVec3::new(-1.0, 0.5, 0.2));
    let rod = PatternEdge { vertices: [VertexId(2), end], ..pattern.edges[0].clone() };
    pattern.edges.push(PatternEdge { assignment: Assignment::Boundary, fold_angle: None, ..rod });
    Model::new(&pattern, &Material::default()).expect("a model")
}

#[test]
fn held_nodes_own_stiffnesses_and_rods() {
    let model = odd_sheet();
    assert!(!model.fixed.is_empty() && model.mesh.sides.iter().any(|side| side.triangles == [None; 2]));
    for seed in 0..20 {
        check(&Case::new(model.clone(), seed, 0.05), "odd sheet", 1e-10, 1e-3);
    }
    let no_zeta = Material { zeta: 0.0, ..Material::default() };
    check(&Case::new(Model { material: no_zeta, ..model }, 1, 0.05), "undamped", 1e-10, 1e-3);
}

#[test]
fn triangles_that_collapse_pull_at_nothing_and_keep_their_angles() {
    let model = Model::new(&crate::generate::miura(4, 4).expect("valid"), &Material::default()).expect("a model");
    let [a, b, c] = model.mesh.triangles[5].map(|n| n.index());
    for height in [0.0, 1e-9, 1e-5, 1e-3] {
        let mut scene = Case::new(model.clone(), 1, 0.0);
        let away = DVec3::new(0.3, 0.5, 0.7) * height;
        scene.positions[c] = 0.5 * (scene.positions[a] + scene.positions[b]) + away;
        // What is left of a height in f32 has few digits.
        let mixed = if height < 1e-3 { f64::INFINITY } else { 1e-2 };
        check(&scene, "a thin triangle", 1e-6, mixed);
        for isa in Isa::all() {
            let (forces, angles) = scene.fast::<f32>(isa, true);
            assert!(forces.iter().all(|f| f.is_finite()) && angles.iter().all(|a| a.is_finite()), "{height}, {isa:?}");
        }
    }
    let mut scene = Case::new(model, 1, 0.0);
    scene.positions.fill(DVec3::ONE);
    for isa in Isa::all() {
        let (forces, angles) = scene.fast::<f64>(isa, false);
        assert_eq!((forces, angles), (vec![DVec3::ZERO; scene.positions.len()], scene.angles.clone()), "{isa:?}");
    }
}

/// The model as soft as on the way, in all but what turns creases back.
fn softened(model: &Model, softening: Softening) -> Model {
    let mut soft = model.clone();
    soft.beams.iter_mut().for_each(|beam| beam.stiffness = softening.of_beam(model, beam));
    soft.material.k_face *= softening.corner_angles;
    soft
}

#[test]
fn a_softened_sheet_has_the_forces_of_a_softer_one() {
    let softening = Softening::default();
    let mut scene = Case::new(odd_sheet(), 2, 0.05);
    scene.angles.fill(0.0);
    let mut forces = Forces::new(&scene.model);
    forces.evaluate(&scene.positions, &scene.targets, &mut scene.angles);
    // A crease on the wrong side is pulled to flat besides.
    let mut soft = softened(&scene.model, softening);
    let mut targets = scene.targets.clone();
    let mut wrong = 0;
    for ((crease, target), angle) in soft.creases.iter_mut().zip(&mut targets).zip(&scene.angles) {
        if *angle * *target < 0.0 {
            wrong += 1;
            *target /= 1.0 + softening.wrong_side;
            crease.stiffness *= 1.0 + softening.wrong_side;
        }
    }
    assert!(wrong > 5, "{wrong} creases on the wrong side");
    let mut angles = scene.angles.clone();
    let plain = Forces::new(&soft).evaluate(&scene.positions, &targets, &mut angles).to_vec();
    assert!(difference(&plain, &scene.plain(false).0) > 0.1, "softer is something else");
    for isa in Isa::all() {
        let mut kernel = scene.kernel::<f64>(isa);
        let fresh = scene.fast::<f64>(isa, false).0;
        kernel.soften(&scene.model, Some(softening));
        kernel.springs(false);
        let forces: Vec<DVec3> = kernel.positions_and_forces().map(|[_, f]| f).collect();
        assert!(difference(&plain, &forces) < 1e-10, "{isa:?}: {}", difference(&plain, &forces));
        let mut found = Vec::new();
        kernel.read_wrong_sides(&mut found);
        assert_eq!(found.len(), wrong, "{isa:?}");
        kernel.soften(&scene.model, None);
        kernel.springs(false);
        assert!(kernel.positions_and_forces().map(|[_, f]| f).eq(fresh), "{isa:?}: nothing of it is left");
        kernel.read_wrong_sides(&mut found);
        assert!(found.is_empty(), "{isa:?}");
    }
}

#[test]
fn a_difference_is_seen() {
    let scene = Case::new(odd_sheet(), 1, 0.05);
    let (forces, _) = scene.plain(true);
    assert!(difference(&forces, &scene.plain(false).0) > 1e-3, "damping");
    let stiffer = Material { k_face: 0.21, ..scene.model.material };
    let stiffer = Case { model: Model { material: stiffer, ..scene.model.clone() }, ..Case::new(odd_sheet(), 1, 0.05) };
    assert!(difference(&forces, &stiffer.fast::<f64>(Isa::Portable, true).0) > 1e-5, "corner angles");
}

/// 100 steps by the plain formulas.
fn plain_steps(scene: &Case, time_step: f64) -> Vec<DVec3> {
    let (mut positions, mut velocities, mut angles) =
        (scene.positions.clone(), scene.velocities.clone(), scene.angles.clone());
    let mut forces = Forces::new(&scene.model);
    // What is held does not move, however it came; the kernel sees to that by itself.
    Held::new(&scene.model, &Scene::default()).clear(&mut velocities);
    for _ in 0..100 {
        let values = forces.evaluate(&positions, &scene.targets, &mut angles);
        damping::add(&scene.model, &velocities, values);
        for ((x, v), f) in positions.iter_mut().zip(&mut velocities).zip(values) {
            *v += *f * time_step;
            *x += *v * time_step;
        }
    }
    positions
}

fn steps<R: Compute>(scene: &Case, isa: Isa, time_step: f64) -> Vec<DVec3> {
    let mut kernel = scene.kernel::<R>(isa);
    for _ in 0..100 {
        kernel.springs(true);
        assert!(kernel.euler(time_step), "out of bounds");
    }
    let mut positions = Vec::new();
    kernel.read_positions(&mut positions);
    positions
}

fn farthest(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

#[test]
fn a_hundred_steps_agree_and_do_not_depend_on_the_width() {
    let mut scene = Case::new(odd_sheet(), 3, 1e-3);
    scene.velocities.iter_mut().for_each(|v| *v *= 0.1);
    scene.angles.fill(0.0);
    let time_step = crate::solve::time_step::safe(&scene.model, &scene.positions, crate::solve::Integrator::Euler);
    let plain = plain_steps(&scene, 0.5 * time_step);
    assert!(farthest(&plain, &scene.positions) > 1e-2, "it moves");
    let exact = steps::<f64>(&scene, Isa::PortableFused, 0.5 * time_step);
    let mixed = steps::<f32>(&scene, Isa::PortableFused, 0.5 * time_step);
    for isa in Isa::all() {
        let (own_exact, own_mixed) =
            (steps::<f64>(&scene, isa, 0.5 * time_step), steps::<f32>(&scene, isa, 0.5 * time_step));
        let off = [&own_exact, &own_mixed].map(|own| farthest(own, &plain));
        assert!(off[0] < 1e-11 && off[1] < 1e-5, "{isa:?}: {off:?}");
        if !matches!(isa, Isa::Portable) {
            assert!(own_exact == exact && own_mixed == mixed, "{isa:?} has other bits");
        }
    }
}

/// The bits of what a kernel does, step by step, its passes cut into so many tasks.
fn bits<R: Compute>(scene: &Case, tasks: usize, verlet: bool) -> (Vec<DVec3>, Vec<f64>, Vec<f64>) {
    let mut kernel = scene.shared::<R>(Isa::best(), tasks);
    kernel.parallelism = super::Parallelism::steady(tasks);
    let masses = vec![[2.0, 0.5]; scene.positions.len()];
    let (mut positions, mut angles, mut reported) = (Vec::new(), scene.angles.clone(), Vec::new());
    for _ in 0..3 {
        reported.push(kernel.springs(true));
        assert!(if verlet { kernel.verlet(1e-4, 1e-4) } else { kernel.euler(1e-4) }, "out of bounds");
    }
    for _ in 0..3 {
        kernel.springs(false);
        let sums = kernel.reduce_forces(&masses);
        reported.extend([sums.power, sums.speed, sums.pull]);
        assert!(kernel.fire_move(&masses, Decision { step: 1e-4, keep: 0.9, towards_force: 1e-4, back: 1e-5 }));
    }
    kernel.read_positions(&mut positions);
    kernel.read_angles(&mut angles);
    (positions, angles, reported)
}

#[test]
fn where_a_pass_is_cut_changes_no_bit() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("a pool");
    let small = Case::new(odd_sheet(), 1, 1e-3);
    let large = crate::generate::miura(58, 53).expect("valid");
    let mut large = Case::new(Model::new(&large, &Material::default()).expect("a model"), 1, 1e-4);
    assert!(large.positions.len() > 3 * 1024, "several blocks of sums");
    large.velocities.iter_mut().for_each(|v| *v *= 0.1);
    for scene in [small, large] {
        for verlet in [false, true] {
            let (exact, mixed) = (bits::<f64>(&scene, 1, verlet), bits::<f32>(&scene, 1, verlet));
            assert!(exact.0 != scene.positions && exact != mixed, "something is compared");
            for tasks in [2, 3, 5, 64] {
                let same = pool.install(|| {
                    bits::<f64>(&scene, tasks, verlet) == exact && bits::<f32>(&scene, tasks, verlet) == mixed
                });
                assert!(same, "{tasks} tasks of {} nodes", scene.positions.len());
            }
        }
    }
}

#[test]
fn what_leaves_all_bounds_or_is_no_number_is_seen() {
    for isa in Isa::all() {
        for bad in [f64::NAN, f64::INFINITY, 1e3] {
            let mut scene = Case::new(odd_sheet(), 1, 1e-3);
            let mut kernel = scene.kernel::<f64>(isa);
            assert!(kernel.euler(1e-3), "{isa:?}");
            scene.positions[9].y = bad;
            assert!(!scene.kernel::<f64>(isa).euler(1e-3) && !scene.kernel::<f32>(isa).euler(1e-3), "{isa:?}: {bad}");
            scene.positions[9].y = 0.0;
            scene.velocities[9].z = 1e5;
            assert!(!scene.kernel::<f64>(isa).euler(1e-3), "{isa:?}: {bad}");
        }
    }
}
