//! One step of dynamics in double precision, and how far another is from it.

use glam::DVec3;
use origami_core::forces::{Forces, damping};

use crate::layout::{Node, vector};
use crate::testing::cases::{Case, ROUNDING, worst};
use crate::testing::magnitudes;

/// Velocities, in roundings of all that is summed: those of the forces, and their sum.
pub(crate) const TOLERANCE: f64 = 3.0;

pub(crate) const STEP: f32 = 0.03;
pub(crate) const STEP_BEFORE: f32 = 0.02;

/// One step in double precision: velocities, then positions. `accelerations` are those of the step before.
pub(crate) fn stepped(case: &Case, accelerations: &[DVec3], verlet: bool, step: f64) -> [Vec<DVec3>; 2] {
    let (model, state) = (&case.model, &case.state);
    let mut angles = state.fold_angles.clone();
    let mut forces = Forces::new(model);
    let springs = forces.evaluate(&state.positions, &state.targets, &mut angles);
    let forces = springs.iter().zip(damping::forces(model, &state.velocities)).map(|(s, d)| *s + d);
    let mut next = [Vec::new(), Vec::new()];
    for (((f, v), p), a) in forces.zip(&state.velocities).zip(&state.positions).zip(accelerations) {
        let (midway, end) = if verlet {
            let midway = *v + (f - *a) * (0.5 * f64::from(STEP_BEFORE)) + f * (0.5 * step);
            (midway, midway + f * (0.5 * step))
        } else {
            (*v + f * step, *v + f * step)
        };
        next[0].push(end);
        next[1].push(*p + midway * step);
    }
    next
}

pub(crate) fn errors(case: &Case, nodes: &[Node], wanted: &[Vec<DVec3>; 2]) -> [f64; 2] {
    let sizes = magnitudes::of_forces(case, true);
    let scales =
        || sizes.iter().zip(&case.state.velocities).map(|(f, v)| v.length() + 2.0 * f64::from(STEP) * (1.0 + f));
    let velocities = nodes.iter().zip(&wanted[0]).zip(scales());
    let velocities = velocities.map(|((n, v), s)| (vector(n.velocity).distance(*v), ROUNDING * s));
    let positions = nodes.iter().zip(&wanted[1]).zip(scales());
    // The low part of a position has steps of 7e-12.
    let positions = positions.map(|((n, p), s)| (n.position().distance(*p), ROUNDING * f64::from(STEP) * s + 1.5e-11));
    [worst(velocities), worst(positions)]
}
