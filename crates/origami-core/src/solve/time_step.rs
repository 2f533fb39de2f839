//! Time steps of [`super::Dynamics`]: the paper's, and one that holds.

use std::f64::consts::PI;

use glam::DVec3;

use super::Integrator;
use super::row_sums::shared_row_sums;
use crate::forces::damping;
use crate::model::Model;

/// How long a step of [`super::Dynamics`] is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TimeStep {
    /// [`paper`]: what the reference program takes. Blows up on thin triangles, hubs, stiff creases.
    Paper,
    /// [`safe`], [`renewed`] as the geometry changes.
    Safe,
    /// So many units of model time.
    Fixed(f64),
}

/// The paper's step (2.5): `0.9 / (2 pi omega)` with omega the largest `sqrt(k)` of a beam, masses 1.
///
/// It is no bound: creases, corner angles, valence and damping are not in it.
#[must_use]
pub fn paper(model: &Model) -> f64 {
    let stiffest = model.beams.iter().map(|b| b.stiffness).fold(0.0, f64::max);
    0.9 / (2.0 * PI * stiffest.sqrt())
}

/// How much of the longest step that surely holds is taken.
pub const SAFE_SHARE: f64 = 0.9;

/// [`SAFE_SHARE`] of the longest step for which `K dt^2 + 2 D dt < 4`, with K the largest row sum of the stiffness at
/// `positions` and D the largest sum of twice the damping coefficients at a node. [`Integrator::Verlet`], whose damping is
/// that of an extrapolated velocity, bears half as much of it: `K dt^2 + 4 D dt < 4`.
#[must_use]
pub fn safe(model: &Model, positions: &[DVec3], integrator: Integrator) -> f64 {
    Safe::new(model, integrator).step(false, model, positions)
}

/// What [`safe`] needs of a model that stays as the geometry changes.
#[derive(Debug)]
pub(super) struct Safe {
    damping: f64,
    /// Memory for the row sums.
    sums: Vec<f64>,
}

impl Safe {
    pub(super) fn new(model: &Model, integrator: Integrator) -> Self {
        Self { damping: damping_sum(model, integrator), sums: vec![0.0; model.node_count()] }
    }

    /// Found by all threads of this thread's pool where it is `shared`.
    pub(super) fn step(&mut self, shared: bool, model: &Model, positions: &[DVec3]) -> f64 {
        shared_row_sums(shared, model, positions, &mut self.sums);
        let stiffness = self.sums.iter().fold(0.0, |a: f64, b| a.max(*b));
        // (-D + sqrt(D^2 + 4 K)) / K without the difference of nearly equal numbers.
        SAFE_SHARE * 4.0 / (self.damping + (self.damping * self.damping + 4.0 * stiffness).sqrt())
    }
}

/// How far the swiftest node may get in one step of [`TimeStep::Safe`], in radii: what moves farther has left the shape for
/// which the step was found, which very stiff creases do at a jump.
pub const SAFE_MOVE: f64 = 0.1;
/// How much longer a renewed step may be than the one before: heights shrink again, within fewer steps than a renewal.
/// `origami study stability` found narrow pleats to fail at 1.12.
pub const SAFE_GROWTH: f64 = 1.025;

/// The step that follows `previous`, of which there is none at first, where [`safe`] says `safe` and the nodes have
/// `velocities`.
#[must_use]
pub fn renewed(safe: f64, velocities: &[DVec3], previous: Option<f64>) -> f64 {
    let swiftest = velocities.iter().map(|v| v.length_squared()).fold(0.0, f64::max).sqrt();
    let slow_enough = if safe * swiftest > SAFE_MOVE { SAFE_MOVE / swiftest } else { safe };
    previous.map_or(slow_enough, |previous| slow_enough.min(SAFE_GROWTH * previous))
}

/// The D of [`safe`]: the largest sum of twice the damping coefficients at a node, and twice that for
/// [`Integrator::Verlet`].
#[must_use]
pub fn damping_sum(model: &Model, integrator: Integrator) -> f64 {
    let mut sums = vec![0.0; model.node_count()];
    for (beam, c) in model.beams.iter().zip(damping::coefficients(model)) {
        for n in beam.nodes {
            sums[n.index()] += 2.0 * c;
        }
    }
    let share = match integrator {
        Integrator::Euler => 1.0,
        Integrator::Verlet => 2.0,
    };
    share * sums.iter().fold(0.0, |a: f64, b| a.max(*b))
}
