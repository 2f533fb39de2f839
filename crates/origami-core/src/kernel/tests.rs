//! Every lane against the plain forces.

use std::time::Instant;

use glam::DVec3;

use super::isa::{Compute, Isa};
use super::{Bounds, Kernel};
use crate::forces::{Forces, damping};
use crate::generate::catalog;
use crate::model::{Material, Model};

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
struct Scene {
    model: Model,
    positions: Vec<DVec3>,
    velocities: Vec<DVec3>,
    angles: Vec<f64>,
    targets: Vec<f64>,
}

impl Scene {
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
            damping::add(&self.model, &self.velocities, values);
        }
        (values.to_vec(), angles)
    }

    fn kernel<R: Compute>(&self, isa: Isa) -> Kernel<R> {
        let mut kernel = Kernel::<R>::with(isa, &self.model, BOUNDS, &self.positions, &self.velocities, &self.angles);
        kernel.aim(&self.targets);
        kernel
    }

    fn fast<R: Compute>(&self, isa: Isa, damped: bool) -> (Vec<DVec3>, Vec<f64>) {
        let mut kernel = self.kernel::<R>(isa);
        kernel.edges();
        kernel.faces(damped);
        let (mut forces, mut angles) = (Vec::new(), self.angles.clone());
        kernel.read_forces(&mut forces);
        kernel.read_angles(&mut angles);
        (forces, angles)
    }
}

/// The largest difference of two lists of vectors as a share of the largest vector.
fn difference(a: &[DVec3], b: &[DVec3]) -> f64 {
    let largest = a.iter().map(|v| v.length()).fold(0.0, f64::max);
    a.iter().zip(b).map(|(a, b)| (*a - *b).length()).fold(0.0, f64::max) / largest
}

fn check(scene: &Scene, what: &str, exact: f64, mixed: f64) {
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
fn every_lane_has_the_plain_forces() {
    for entry in catalog::entries() {
        let pattern = catalog::generate(entry.name, &[]).expect("a pattern");
        for material in [Material::default(), Material { k_face: 0.0, zeta: 0.0, ..Material::default() }] {
            let model = Model::new(&pattern, &material).expect("a model");
            for (seed, far) in [(1, 1e-3), (2, 0.03), (3, 0.3)] {
                check(&Scene::new(model.clone(), seed, far), entry.name, 1e-10, 1e-3);
            }
        }
    }
}

#[test]
#[ignore = "measures"]
fn timing() {
    for panels in [9_usize, 31, 99, 315] {
        let pattern = crate::generate::miura(panels, panels).expect("valid");
        let model = Model::new(&pattern, &Material::default()).expect("valid");
        let nodes = model.node_count();
        let scene = Scene::new(model, 1, 1e-4);
        let repeat = (30_000 / nodes).max(1);
        time::<f64>(&scene, repeat);
        time::<f32>(&scene, repeat);
    }
}

fn time<R: Compute>(scene: &Scene, repeat: usize) {
    let nodes = scene.positions.len();
    for isa in Isa::all() {
        if matches!(isa, Isa::PortableFused) {
            continue;
        }
        let mut kernel = scene.kernel::<R>(isa);
        let mut each = [f64::INFINITY; 4];
        for _ in 0..60 {
            let mut of = |place: usize, pass: &mut dyn FnMut(&mut Kernel<R>)| {
                let start = Instant::now();
                for _ in 0..repeat {
                    pass(&mut kernel);
                }
                each[place] = each[place].min(start.elapsed().as_secs_f64() * 1e9 / (nodes * repeat) as f64);
            };
            of(0, &mut |k| {
                k.edges();
            });
            of(1, &mut |k| k.faces(true));
            of(2, &mut |k| {
                k.euler(0.0);
            });
            of(3, &mut |k| {
                k.edges();
                k.faces(true);
                k.euler(1e-9);
            });
        }
        let name = format!("{isa:?}");
        println!(
            "{nodes:>7} {} {:>9} edges {:5.1} faces {:5.1} nodes {:5.1} all {:5.1}",
            size_of::<R>() * 8,
            &name[..name.len().min(8)],
            each[0],
            each[1],
            each[2],
            each[3]
        );
    }
}
