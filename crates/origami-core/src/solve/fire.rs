//! FIRE, the fast inertial relaxation engine (Bitzek et al., Phys. Rev. Lett. 97, 170201, 2006), on masses equal to the
//! row sums of the stiffness: every node then moves at its own local step, and a step of 2 would be the stability limit.

use super::motion::Motion;
use super::row_sums::shared_row_sums;
use crate::kernel::{Compute, Decision, Sums};
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
pub(super) struct Fire {
    /// By node, with their inverses.
    masses: Vec<[f64; 2]>,
    sums: Vec<f64>,
    step: f64,
    mixing: f64,
    downhill: u32,
    evaluations: u64,
}

impl Fire {
    pub(super) fn new(model: &Model) -> Self {
        let (masses, sums) = (vec![[0.0; 2]; model.node_count()], vec![0.0; model.node_count()]);
        Self { masses, sums, step: FIRST_STEP, mixing: MIXING, downhill: 0, evaluations: 0 }
    }

    /// The present step, in units of each node's own.
    pub(super) fn step(&self) -> f64 {
        self.step
    }

    /// Moves the sheet by the forces at its positions; false where a node may be out of bounds.
    pub(super) fn advance<R: Compute>(&mut self, motion: &mut Motion<'_, R>) -> bool {
        if self.evaluations.is_multiple_of(RENEWAL) {
            motion.read_positions();
            shared_row_sums(motion.kernel.shared(), motion.model, &motion.state.positions, &mut self.sums);
            self.masses.clear();
            self.masses.extend(self.sums.iter().map(|mass| [*mass, 1.0 / mass]));
        }
        self.evaluations += 1;
        let decision = self.decide(motion.kernel.reduce_forces(&self.masses));
        motion.kernel.fire_move(&self.masses, decision)
    }

    fn decide(&mut self, Sums { power, speed, pull }: Sums) -> Decision {
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
        let step = self.step;
        if uphill {
            return Decision { step, keep: 0.0, towards_force: step, back: -0.5 * step };
        }
        let turn = if pull > 0.0 { self.mixing * (speed / pull).sqrt() } else { 0.0 };
        Decision { step, keep: 1.0 - self.mixing, towards_force: turn + step, back: 0.0 }
    }
}
