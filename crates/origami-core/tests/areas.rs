//! Areas: what keeps a triangle from collapsing is a gradient, has its Hessian and row sum, and acts nowhere else.

use glam::{DMat3, DQuat, DVec3, EulerRot};
use origami_core::forces::areas::{THRESHOLD, resisting};
use origami_core::forces::{Energy, Forces, creases, hessian};
use origami_core::generate::Miura;
use origami_core::ids::TriangleId;
use origami_core::solve::row_sums::row_sums;
use origami_core::{Material, Model};

/// The triangles that are squeezed: far from each other.
const SQUEEZED: [usize; 2] = [3, 40];

/// A Miura sheet that has nothing but areas, if it has these, turned so that no coordinate is special; two triangles have
/// `share` of their areas.
fn squeezed(share: f64, collapse: f64) -> (Model, Vec<DVec3>) {
    let material = Material { ea: 1e-12, k_face: 0.0, collapse, ..Material::default() };
    let mut model = Model::new(&Miura::default().pattern().expect("valid"), &material).expect("valid");
    model.creases.iter_mut().for_each(|crease| crease.stiffness = 0.0);
    let mut positions = model.rest.clone();
    for t in SQUEEZED {
        let [a, b, c] = model.mesh.triangles[t].map(|n| n.index());
        let along = model.rest[c] - model.rest[b];
        positions[a] -= (model.rest[a] - model.rest[b]).reject_from(along) * (1.0 - share);
    }
    let turn = DQuat::from_euler(EulerRot::XYZ, 0.4, -1.1, 2.0);
    positions.iter_mut().for_each(|p| *p = turn * *p);
    (model, positions)
}

fn forces(model: &Model, positions: &[DVec3]) -> Vec<DVec3> {
    let mut angles = vec![0.0; model.creases.len()];
    Forces::new(model).evaluate(positions, &angles.clone(), &mut angles).to_vec()
}

fn energy(model: &Model, positions: &[DVec3]) -> f64 {
    let angles = vec![0.0; model.creases.len()];
    Energy::of(model, positions, &angles, &angles).areas
}

fn blocks(model: &Model, positions: &[DVec3]) -> Vec<Vec<DMat3>> {
    let mut blocks = vec![vec![DMat3::ZERO; positions.len()]; positions.len()];
    let angles = creases::fold_angles(model, positions, &vec![0.0; model.creases.len()]);
    hessian::blocks(model, positions, &angles, &angles, &mut |i, j, block| {
        blocks[i][j] += block;
        if i != j {
            blocks[j][i] += block.transpose();
        }
    });
    blocks
}

/// The largest differences of forces from slopes of the energy, and of the Hessian from slopes of the forces, as shares of the
/// largest of each.
fn errors(energy: &dyn Fn(&[DVec3]) -> f64, model: &Model, positions: &[DVec3], step: f64) -> [f64; 2] {
    let (own, blocks) = (forces(model, positions), blocks(model, positions));
    let largest = own.iter().map(|f| f.length()).fold(0.0, f64::max);
    let stiffest = blocks.iter().flatten().flat_map(DMat3::to_cols_array).fold(0.0, |m: f64, x| m.max(x.abs()));
    let mut errors = [0.0_f64; 2];
    for node in 0..own.len() {
        for axis in 0..3 {
            let [down, up] = [-1.0, 1.0].map(|sign| {
                let mut moved = positions.to_vec();
                moved[node][axis] += sign * step;
                moved
            });
            let slope = (energy(&up) - energy(&down)) / (2.0 * step);
            errors[0] = errors[0].max((own[node][axis] + slope).abs() / largest);
            for ((row, up), down) in blocks.iter().zip(forces(model, &up)).zip(forces(model, &down)) {
                let off = row[node].col(axis) + (up - down) / (2.0 * step);
                errors[1] = errors[1].max(off.length() / stiffest);
            }
        }
    }
    errors
}

#[test]
fn forces_and_hessian_are_derivatives() {
    for share in [0.02, 0.1, 0.19] {
        let (model, positions) = squeezed(share, 0.1);
        let [force, hessian] = errors(&|moved| energy(&model, moved), &model, &positions, 1e-5 * share);
        assert!(force < 1e-5 && hessian < 1e-5, "{share}: {force}, {hessian}");
        let (stiffer, _) = squeezed(share, 0.101);
        let [force, _] = errors(&|moved| energy(&stiffer, moved), &model, &positions, 1e-5 * share);
        assert!(force > 1e-3, "a hundredth more is a difference: {force}");
    }
}

#[test]
fn the_row_sum_is_that_of_its_curvature() {
    let (model, positions) = squeezed(0.1, 0.1);
    let (without, _) = squeezed(0.1, 0.0);
    let sums = |model: &Model| {
        let mut sums = vec![0.0; positions.len()];
        row_sums(model, &positions, &mut sums);
        sums
    };
    let own: Vec<f64> = sums(&model).iter().zip(sums(&without)).map(|(all, others)| all - others).collect();
    let corners = SQUEEZED.map(|t| model.mesh.triangles[t].map(|n| n.index()));
    for corners in corners {
        // A triangle that grows by a share does so in all its sides.
        let [a, b, c] = corners.map(|n| positions[n]);
        let (heights, doubled) = ([c - b, a - c, b - a].map(DVec3::length), (b - a).cross(c - a).length());
        let at = |more: f64| {
            let mut moved = model.rest.clone();
            let normal = (b - a).cross(c - a).normalize();
            let up = normal.cross(c - b).normalize() * more * doubled / (c - b).length();
            for (n, p) in corners.into_iter().zip([a + up, b, c]) {
                moved[n] = p;
            }
            // Neighbours are drawn along: only the energy of this triangle is wanted.
            let rest = corners.map(|n| model.rest[n]);
            let perimeter = (rest[1] - rest[0]).length() + (rest[2] - rest[1]).length() + (rest[0] - rest[2]).length();
            let ratio = (moved[corners[1]] - moved[corners[0]]).cross(moved[corners[2]] - moved[corners[0]]).length()
                / (rest[1] - rest[0]).cross(rest[2] - rest[0]).length();
            let r = ratio / THRESHOLD;
            model.k_area() * perimeter * (1.0 / r - 2.0 + r)
        };
        let step = 1e-3;
        let curvature = (at(step) - 2.0 * at(0.0) + at(-step)) / (step * doubled).powi(2);
        let total: f64 = heights.iter().sum();
        for (n, height) in corners.into_iter().zip(heights) {
            let expected = curvature * height * total;
            assert!((own[n] / expected - 1.0).abs() < 1e-4, "{} is not {expected}", own[n]);
        }
    }
}

#[test]
fn what_has_a_fifth_of_its_area_is_left_alone() {
    let (model, positions) = squeezed(1.0, 0.1);
    assert_eq!((energy(&model, &positions), resisting(&model, &positions).count()), (0.0, 0));
    let (model, positions) = squeezed(THRESHOLD + 1e-9, 0.1);
    assert_eq!(energy(&model, &positions), 0.0);
    let (model, positions) = squeezed(THRESHOLD - 1e-3, 0.1);
    let acting: Vec<TriangleId> = resisting(&model, &positions).collect();
    assert_eq!(acting, SQUEEZED.map(TriangleId::new));
    assert!(energy(&model, &positions) > 0.0);
    let (model, positions) = squeezed(0.1, 0.0);
    assert_eq!((energy(&model, &positions), resisting(&model, &positions).count()), (0.0, 0), "no such springs");
}

#[test]
fn no_energy_brings_an_area_to_nothing() {
    let energies = [0.1, 0.01, 1e-4, 1e-8].map(|share| {
        let (model, positions) = squeezed(share, 0.1);
        energy(&model, &positions)
    });
    assert!(energies.is_sorted() && energies[3] > 1e4, "{energies:?}");
    let (model, positions) = squeezed(0.0, 0.1);
    assert!(forces(&model, &positions).iter().all(|f| f.is_finite()), "what is a line already has no direction");
}
