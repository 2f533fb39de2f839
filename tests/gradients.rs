//! Forces are minus the gradient of the energy, and push nothing as a whole: on random, thin and strongly folded hinges.

mod common;

use common::Springs;
use origami::forces::{Energy, Forces, creases, damping};
use origami::glam::{DQuat, DVec3};
use origami::{Material, Model, State};
use proptest::prelude::*;

/// A hinge at rest and in another position: heights of its triangles, feet of these heights along the crease (0 to 1 lies
/// on it), and its fold angle.
#[derive(Clone, Copy, Debug)]
struct Shape {
    heights: [f64; 2],
    feet: [f64; 2],
    angle: f64,
}

impl Shape {
    fn points(self) -> [DVec3; 4] {
        let turn = DQuat::from_rotation_x(self.angle);
        let left = turn * DVec3::new(0.0, self.heights[0], 0.0) + DVec3::X * self.feet[0];
        [left, DVec3::new(self.feet[1], -self.heights[1], 0.0), DVec3::ZERO, DVec3::X]
    }

    /// The smallest height of either triangle: forces change over that length.
    fn scale(self) -> f64 {
        let [p1, p2, p3, p4] = self.points();
        let height = |p: DVec3| {
            let longest = p.distance(p3).max(p.distance(p4)).max(1.0);
            (p4 - p3).cross(p - p3).length() / longest
        };
        height(p1).min(height(p2))
    }
}

fn shape(heights: std::ops::Range<f64>, angles: std::ops::Range<f64>) -> impl Strategy<Value = Shape> {
    // Uniform in the logarithm: thin triangles are as frequent as thick ones.
    let height = heights.start.ln()..heights.end.ln();
    let heights = [height.clone(), height].prop_map(|h| h.map(f64::exp));
    (heights, [-0.5..1.5, -0.5..1.5], angles).prop_map(|(heights, feet, angle)| Shape { heights, feet, angle })
}

fn springs() -> impl Strategy<Value = Springs> {
    prop_oneof![Just(Springs::Beams), Just(Springs::Creases), Just(Springs::CornerAngles)]
}

fn forces(model: &Model, positions: &[DVec3], targets: &[f64], angles: &mut [f64]) -> Vec<DVec3> {
    Forces::new(model).evaluate(positions, targets, angles).to_vec()
}

/// Largest difference between the forces and central differences of the energy, relative to the largest force.
fn gradient_error(model: &Model, positions: &[DVec3], targets: &[f64], scale: f64) -> f64 {
    let mut angles = creases::fold_angles(model, positions, &vec![0.0; model.creases.len()]);
    let forces = forces(model, positions, targets, &mut angles);
    let largest = forces.iter().map(|f| f.length()).fold(0.0, f64::max);
    let energy = |moved: &[DVec3]| {
        let angles = creases::fold_angles(model, moved, &angles);
        Energy::of(model, moved, &angles, targets).total()
    };
    let step = 1e-5 * scale;
    let mut error = 0.0_f64;
    for node in 0..positions.len() {
        for axis in DVec3::AXES {
            let at = |sign: f64| {
                let mut moved = positions.to_vec();
                moved[node] += axis * (sign * step);
                energy(&moved)
            };
            let slope = (at(1.0) - at(-1.0)) / (2.0 * step);
            error = error.max((forces[node].dot(axis) + slope).abs());
        }
    }
    // Rounding of the energies themselves, where they are large and the forces small.
    error / (largest + 1e-9 * energy(positions) / scale + 1e-12)
}

/// Positions of `now` in the units of a model that was built from `rest`.
fn in_model(model: &Model, now: Shape) -> Vec<DVec3> {
    now.points().iter().map(|p| model.normalisation.to_model(*p)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, ..ProptestConfig::default() })]

    #[test]
    fn forces_are_minus_the_gradient(
        springs in springs(),
        rest in shape(0.05..2.0, -0.5..0.5),
        now in shape(0.05..2.0, -3.1..3.1),
        target in -3.2..3.2,
    ) {
        let model = common::hinge(rest.points(), target, &springs.material());
        let scale = now.scale() / model.normalisation.radius;
        let error = gradient_error(&model, &in_model(&model, now), &model.targets(100.0), scale);
        prop_assert!(error < 1e-6, "relative error {error}");
    }

    #[test]
    fn forces_are_minus_the_gradient_on_thin_triangles(
        springs in springs(),
        rest in shape(1e-4..1e-2, -0.5..0.5),
        stretch in 0.8..1.25,
        angle in -3.1..3.1,
        target in -3.2..3.2,
    ) {
        let model = common::hinge(rest.points(), target, &springs.material());
        let now = Shape { heights: rest.heights.map(|h| h * stretch), angle, ..rest };
        let scale = now.scale() / model.normalisation.radius;
        let error = gradient_error(&model, &in_model(&model, now), &model.targets(100.0), scale);
        prop_assert!(error < 1e-5, "relative error {error}");
    }

    #[test]
    fn springs_push_and_turn_nothing_as_a_whole(
        rest in shape(1e-3..2.0, -0.5..0.5),
        now in shape(1e-3..2.0, -3.1..3.1),
        target in -7.0..7.0,
    ) {
        let model = common::hinge(rest.points(), target, &Material::default());
        let positions = in_model(&model, now);
        let forces = forces(&model, &positions, &model.targets(100.0), &mut [0.0]);
        let largest = forces.iter().map(|f| f.length()).fold(0.0, f64::max);
        let sum: DVec3 = forces.iter().sum();
        let torque: DVec3 = positions.iter().zip(&forces).map(|(p, f)| p.cross(*f)).sum();
        prop_assert!(sum.length() < 1e-12 * largest, "a sum of {sum} of forces up to {largest}");
        prop_assert!(torque.length() < 1e-12 * largest, "a torque of {torque}, forces up to {largest}");
    }

    #[test]
    fn damping_keeps_linear_momentum_and_takes_energy(
        velocities in [[-1.0..1.0, -1.0..1.0, -1.0..1.0], [-1.0..1.0, -1.0..1.0, -1.0..1.0],
                       [-1.0..1.0, -1.0..1.0, -1.0..1.0], [-1.0..1.0, -1.0..1.0, -1.0..1.0]],
    ) {
        let rest = Shape { heights: [1.0, 0.7], feet: [0.3, 0.6], angle: 0.0 };
        let model = common::hinge(rest.points(), 1.0, &Material::default());
        let velocities = velocities.map(DVec3::from_array);
        let forces = damping::forces(&model, &velocities);
        let sum: DVec3 = forces.iter().sum();
        let power: f64 = forces.iter().zip(&velocities).map(|(f, v)| f.dot(*v)).sum();
        prop_assert!(sum.length() < 1e-13);
        prop_assert!(power <= 0.0);
        // Each beam by itself, in the paper's words.
        let mut expected = [DVec3::ZERO; 4];
        for beam in &model.beams {
            let [i, j] = beam.nodes.map(|n| n.index());
            let c = 2.0 * 0.45 * (20.0 / beam.rest_length).sqrt();
            expected[i] += c * (velocities[j] - velocities[i]);
            expected[j] += c * (velocities[i] - velocities[j]);
        }
        prop_assert!(common::largest_distance(&forces, &expected) < 1e-12);
    }
}

#[test]
fn a_wrong_force_is_found() {
    let rest = Shape { heights: [1.0, 0.7], feet: [0.3, 0.6], angle: 0.0 };
    let now = Shape { angle: 1.0, ..rest };
    let model = common::hinge(rest.points(), 0.5, &Springs::Creases.material());
    // The energy of another target: its gradient is not minus the force at this one.
    let positions = in_model(&model, now);
    let mut wrong = model.clone();
    wrong.creases[0].stiffness *= 1.001;
    let mut angles = [1.0];
    let (right, wrong) =
        (forces(&model, &positions, &[0.5], &mut angles), forces(&wrong, &positions, &[0.5], &mut angles));
    assert!(common::largest_distance(&right, &wrong) > 1e-4, "a thousandth more is a difference");
    assert!(gradient_error(&model, &positions, &[0.5], 0.1) < 1e-6);
    let coarse = gradient_error(&model, &positions, &[0.5], 1e5);
    assert!(coarse > 1e-3, "differences over a whole radius are no gradient: {coarse}");
}

#[test]
fn energies_are_those_of_the_springs() {
    let rest = Shape { heights: [1.0, 1.0], feet: [0.5, 0.5], angle: 0.0 };
    let model = common::hinge(rest.points(), 2.0, &Material::default());
    let mut state = State::at_rest(&model);
    assert_eq!(state.energy(&model).total(), 0.0, "a sheet at rest");
    state.targets = model.targets(50.0);
    let energy = state.energy(&model);
    let length = 1.0 / model.normalisation.radius;
    assert!((energy.creases - 0.5 * 0.7 * length).abs() < 1e-15, "k l0 (1 rad)^2 / 2");
    assert_eq!(energy.total(), energy.creases);

    // Twice as large: every beam of length l0 is l0 longer, every angle the same.
    for p in &mut state.positions {
        *p *= 2.0;
    }
    let energy = state.energy(&model);
    let lengths: f64 = model.beams.iter().map(|b| b.rest_length).sum();
    assert!((energy.beams - 0.5 * 20.0 * lengths).abs() < 1e-12, "EA l0 / 2 each");
    assert!(energy.corner_angles < 1e-28);
}

#[test]
fn fold_angle_is_valley_positive_and_unwrapped() {
    let rest = Shape { heights: [1.0, 1.0], feet: [0.5, 0.5], angle: 0.0 };
    let model = common::hinge(rest.points(), 1.0, &Material::default());
    let angle = |angle: f64, previous: f64| {
        creases::fold_angles(&model, &in_model(&model, Shape { angle, ..rest }), &[previous])[0]
    };
    for turn in [-3.0, -1.0, -1e-9, 0.0, 1e-9, 0.5, 3.0] {
        // The apex to the left rises: a valley seen from above.
        assert!((angle(turn, 0.0) - turn).abs() < 1e-14, "{turn}");
    }
    assert!((angle(3.2, 3.1) - 3.2).abs() < 1e-14, "past half a turn");
    assert!((angle(0.2, 12.5) - (0.2 + 4.0 * std::f64::consts::PI)).abs() < 1e-13, "two turns");
}
