//! Time steps of [`super::Dynamics`]: the paper's, and one that holds.

use std::f64::consts::PI;
use std::sync::Arc;

use glam::DVec3;

use super::Integrator;
use super::row_sums::{OnTheWay, all_row_sums};
use crate::forces::damping;
use crate::model::Model;
use crate::scene::Force;
use crate::twins::safe_time_step::{longest, safe_time_step};

/// How long a step of [`super::Dynamics`] is.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
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

/// 0.9 of the longest step for which `K dt^2 + 2 D dt < 4`, with K the largest row sum of the stiffness at
/// `positions` and D the largest sum of twice the damping coefficients at a node. [`Integrator::Verlet`], whose damping is
/// that of an extrapolated velocity, bears half as much of it: `K dt^2 + 4 D dt < 4`.
#[must_use]
pub fn safe(model: &Model, positions: &[DVec3], integrator: Integrator) -> f64 {
    Safe::new(model, integrator).step(false, (model, &[]), positions)
}

/// What [`safe`] needs of a model that stays as the geometry changes.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Safe {
    damping: f64,
    /// Memory for the row sums.
    sums: Vec<f64>,
}

impl Safe {
    pub(super) fn new(model: &Model, integrator: Integrator) -> Self {
        Self { damping: damping_sum(model, integrator), sums: vec![0.0; model.node_count()] }
    }

    /// With the forces of one's own that act on `model`. Found by all threads of this thread's pool where it is `shared`.
    pub(super) fn step(&mut self, shared: bool, (model, own): (&Model, &[Arc<dyn Force>]), positions: &[DVec3]) -> f64 {
        all_row_sums(shared, (model, &OnTheWay::default(), own), positions, &mut self.sums);
        longest(self.sums.iter().fold(0.0, |a: f64, b| a.max(*b)), self.damping)
    }
}

/// The step that follows `previous`, of which there is none at first, where [`safe`] says `safe` and the nodes have
/// `velocities`.
#[must_use]
pub fn renewed(safe: f64, velocities: &[DVec3], previous: Option<f64>) -> f64 {
    let swiftest = velocities.iter().map(|v| v.length_squared()).fold(0.0, f64::max).sqrt();
    safe_time_step(safe, swiftest, previous)
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
