//! Hessians are the derivatives of the forces: on random, thin and strongly folded hinges and whole sheets.

mod common;

use common::Springs;
use origami::forces::{Forces, creases, hessian};
use origami::generate::catalog;
use origami::glam::{DMat3, DQuat, DVec3};
use origami::{Material, Model, Relax, Solver};
use proptest::prelude::*;

/// The whole Hessian, blocks by row and column of nodes.
fn dense(model: &Model, positions: &[DVec3], targets: &[f64]) -> Vec<Vec<DMat3>> {
    let angles = creases::fold_angles(model, positions, &vec![0.0; model.creases.len()]);
    let mut blocks = vec![vec![DMat3::ZERO; positions.len()]; positions.len()];
    hessian::blocks(model, positions, targets, &angles, &mut |i, j, block| {
        blocks[i][j] += block;
        if i != j {
            blocks[j][i] += block.transpose();
        }
    });
    blocks
}

/// Fold angles go on from `near`: a hinge close to half a turn does not jump by a whole one.
fn forces(model: &Model, positions: &[DVec3], targets: &[f64], near: &[f64]) -> Vec<DVec3> {
    let mut angles = creases::fold_angles(model, positions, near);
    Forces::new(model).evaluate(positions, targets, &mut angles).to_vec()
}

/// Largest difference between the Hessian and differences of the forces over four points, relative to its largest entry.
/// `scale` is the length over which forces change.
fn error(model: &Model, positions: &[DVec3], targets: &[f64], scale: f64) -> f64 {
    let blocks = dense(model, positions, targets);
    let angles = creases::fold_angles(model, positions, &vec![0.0; model.creases.len()]);
    let largest = blocks.iter().flatten().flat_map(DMat3::to_cols_array).fold(0.0, |m: f64, x| m.max(x.abs()));
    let mut worst = 0.0_f64;
    for j in 0..positions.len() {
        for axis in 0..3 {
            let step = 1e-3 * scale;
            let at = |shift: f64| {
                let mut moved = positions.to_vec();
                moved[j][axis] += shift * step;
                forces(model, &moved, targets, &angles)
            };
            let [far_below, below, above, far_above] = [-2.0, -1.0, 1.0, 2.0].map(at);
            for i in 0..positions.len() {
                let slope = (8.0 * (above[i] - below[i]) - (far_above[i] - far_below[i])) / (12.0 * step);
                worst = worst.max((blocks[i][j].col(axis) + slope).length() / largest);
            }
        }
    }
    worst
}

/// A hinge by the heights of its triangles, the feet of these along the crease, and its fold angle.
fn points(heights: [f64; 2], feet: [f64; 2], angle: f64) -> [DVec3; 4] {
    let left = DQuat::from_rotation_x(angle) * DVec3::new(0.0, heights[0], 0.0) + DVec3::X * feet[0];
    [left, DVec3::new(feet[1], -heights[1], 0.0), DVec3::ZERO, DVec3::X]
}

fn springs() -> impl Strategy<Value = Springs> {
    prop_oneof![Just(Springs::Beams), Just(Springs::Creases), Just(Springs::CornerAngles), Just(Springs::All)]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn derivatives_of_the_forces_on_random_hinges(
        springs in springs(),
        heights in [-3.0..0.7, -3.0..0.7_f64],
        feet in [-0.5..1.5, -0.5..1.5],
        angle in -3.1..3.1,
        target in -7.0..7.0,
        jitter in prop::array::uniform4(prop::array::uniform3(-0.2..0.2)),
        turn in prop::array::uniform3(-3.0..3.0),
    ) {
        let heights = heights.map(f64::exp);
        let model = common::hinge(points(heights, feet, 0.0), 1.0, &springs.material());
        // Turned, so that no coordinate is special, and strained by a part of the smaller height.
        let turn = DQuat::from_euler(origami::glam::EulerRot::XYZ, turn[0], turn[1], turn[2]);
        let small = heights[0].min(heights[1]).min(1.0);
        let folded: Vec<DVec3> = points(heights, feet, angle)
            .iter()
            .zip(jitter)
            .map(|(p, jitter)| turn * (*p + DVec3::from_array(jitter) * small) / model.normalisation.radius)
            .collect();
        let error = error(&model, &folded, &[target], 0.2 * small / model.normalisation.radius);
        prop_assert!(error < 1e-6, "{error}");
    }
}

#[test]
fn a_thin_sliver_has_its_hessian_too() {
    for height in [0.1, 0.01, 1e-3] {
        for angle in [0.0, 1.0, -3.0] {
            let model = common::hinge(points([height, 0.5], [0.3, 0.6], 0.0), 1.0, &Springs::All.material());
            let folded = points([height, 0.5], [0.3, 0.6], angle).map(|p| p / model.normalisation.radius);
            let error = error(&model, &folded, &[0.5], 0.2 * height);
            assert!(error < 1e-6, "height {height} at {angle}: {error}");
        }
    }
}

#[test]
fn whole_folded_sheets_have_theirs() {
    for name in ["bird-base", "miura", "square-twist", "kresling"] {
        let model = Model::new(&catalog::generate(name, &[]).expect("a pattern"), &Material::default()).expect("valid");
        let state = Relax { steps: Some(600), ..Relax::default() }.fold_from_rest(&model, 70.0).expect("holds").state;
        let shortest = model.beams.iter().map(|b| b.rest_length).fold(f64::INFINITY, f64::min);
        let error = error(&model, &state.positions, &state.targets, 0.05 * shortest);
        assert!(error < 1e-6, "{name}: {error}");
    }
}

#[test]
fn hessians_are_symmetric_and_blind_to_translation() {
    let model = Model::new(&catalog::generate("miura", &[]).expect("a pattern"), &Material::default()).expect("valid");
    let state = Relax { steps: Some(300), ..Relax::default() }.fold_from_rest(&model, 60.0).expect("holds").state;
    let blocks = dense(&model, &state.positions, &state.targets);
    for (i, row) in blocks.iter().enumerate() {
        let diagonal = row[i] - row[i].transpose();
        let sum = row.iter().fold(DMat3::ZERO, |sum, block| sum + *block);
        for (what, x) in [("not symmetric", diagonal), ("resists a translation", sum)] {
            assert!(x.to_cols_array().iter().all(|x| x.abs() < 1e-9), "node {i}: {what}: {x}");
        }
    }
}

#[test]
fn without_force_rotations_cost_nothing() {
    // A valley at the angle that it is asked for: no spring pulls.
    for angle in [0.0, 0.7, -2.5] {
        let model = common::hinge(points([0.4, 0.7], [0.2, 0.9], 0.0), 1.0, &Material::default());
        let positions = points([0.4, 0.7], [0.2, 0.9], angle).map(|p| p / model.normalisation.radius);
        let resistance = |targets: &[f64]| {
            let blocks = dense(&model, &positions, targets);
            let axes = [DVec3::X, DVec3::Y, DVec3::Z];
            let forces = axes.iter().flat_map(|axis| {
                let moved = positions.map(|p| axis.cross(p));
                blocks.iter().map(move |row| row.iter().zip(moved).map(|(b, m)| *b * m).sum::<DVec3>().length())
            });
            forces.fold(0.0, f64::max)
        };
        assert!(resistance(&[angle]) < 1e-12, "{}", resistance(&[angle]));
        assert!(resistance(&[angle + 1.0]) > 1e-2, "under load the forces turn with the sheet");
    }
}

#[test]
fn the_comparison_can_fail() {
    let model = common::hinge(points([0.4, 0.7], [0.2, 0.9], 0.0), 1.0, &Material::default());
    let positions = points([0.4, 0.7], [0.2, 0.9], 1.0).map(|p| p / model.normalisation.radius);
    assert!(error(&model, &positions, &[0.3], 0.1) < 1e-6);
    // Hessian at one target against forces at another.
    let blocks = dense(&model, &positions, &[0.3]);
    let other = dense(&model, &positions, &[0.4]);
    let difference = blocks.iter().flatten().zip(other.iter().flatten()).map(|(a, b)| (*a - *b).to_cols_array());
    assert!(difference.flatten().fold(0.0, |m: f64, x| m.max(x.abs())) > 1e-2);
}
