//! FIRE, the fast inertial relaxation engine (Bitzek et al., Phys. Rev. Lett. 97, 170201, 2006), on masses equal to the
//! row sums of the stiffness: every node then moves at its own local step, and a step of 2 would be the stability limit.

use glam::DVec3;

use super::State;
use super::guard::Guard;
use super::row_sums::row_sums;
use crate::model::Model;

/// The first step, in units of each node's own; 2 would be the limit of stability.
pub const FIRST_STEP: f64 = 0.42;
/// The longest step.
pub const LONGEST_STEP: f64 = 1.5;
/// The shortest step.
pub const SHORTEST_STEP: f64 = 0.028;
/// Factor of the step while it goes downhill.
pub const LONGER: f64 = 1.1;
/// Factor of the step where it went uphill.
pub const SHORTER: f64 = 0.5;
/// How much the velocity is turned towards the force.
pub const MIXING: f64 = 0.15;
/// How that share decays while it goes downhill.
pub const LESS_MIXING: f64 = 0.99;
/// Downhill steps before the step may grow.
pub const PATIENCE: u32 = 5;
/// Evaluations between two renewals of the masses: heights shrink as the sheet folds.
pub const RENEWAL: u64 = 50;

/// The minimiser's own state.
#[derive(Debug)]
pub(super) struct Fire<'m> {
    model: &'m Model,
    masses: Vec<f64>,
    step: f64,
    mixing: f64,
    downhill: u32,
    evaluations: u64,
}

impl<'m> Fire<'m> {
    pub(super) fn new(model: &'m Model) -> Self {
        let masses = vec![0.0; model.node_count()];
        Self { model, masses, step: FIRST_STEP, mixing: MIXING, downhill: 0, evaluations: 0 }
    }

    /// The present step, in units of each node's own.
    pub(super) fn step(&self) -> f64 {
        self.step
    }

    /// Moves the state by the forces at its positions; false where a node went out of bounds.
    pub(super) fn advance(&mut self, state: &mut State, forces: &[DVec3]) -> bool {
        if self.evaluations.is_multiple_of(RENEWAL) {
            row_sums(self.model, &state.positions, &mut self.masses);
        }
        self.evaluations += 1;

        // Power, and the squared lengths of velocity and acceleration in the norm of the masses.
        let (mut power, mut speed, mut pull) = (0.0, 0.0, 0.0);
        for ((v, f), m) in state.velocities.iter().zip(forces).zip(&self.masses) {
            power += f.dot(*v);
            speed += m * v.length_squared();
            pull += f.length_squared() / m;
        }

        let uphill = power < 0.0;
        if uphill {
            self.step = (SHORTER * self.step).max(SHORTEST_STEP);
            self.mixing = MIXING;
            self.downhill = 0;
        } else {
            self.downhill += 1;
            if self.downhill > PATIENCE {
                self.step = (LONGER * self.step).min(LONGEST_STEP);
                self.mixing *= LESS_MIXING;
            }
        }
        let turn = if pull > 0.0 { self.mixing * (speed / pull).sqrt() } else { 0.0 };
        let (keep, towards_force, back) =
            if uphill { (0.0, self.step, -0.5 * self.step) } else { (1.0 - self.mixing, turn + self.step, 0.0) };

        let mut holds = true;
        let nodes = state.positions.iter_mut().zip(&mut state.velocities).zip(forces).zip(&self.masses);
        for (((x, v), f), m) in nodes {
            let retreat = *v * back;
            *v = *v * keep + *f * (towards_force / m);
            *x += *v * self.step + retreat;
            holds &= Guard::holds(*x, *v * self.step);
        }
        holds
    }
}
