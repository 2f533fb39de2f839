//! The passes of the paper's scheme without anything around them: what benches compare steps with.

use super::State;
use crate::kernel::{Bounds, Kernel};
use crate::model::Model;
use crate::twins::state_bounds::{FARTHEST, LONGEST_MOVE};

/// A sheet in f64 on one thread, moved by the paper's scheme; nothing watches it.
#[doc(hidden)]
#[derive(Debug)]
pub struct BareKernel(Kernel<f64>);

impl BareKernel {
    /// The sheet of `start`, its creases asked for `targets`.
    #[must_use]
    pub fn new(model: &Model, start: &State, targets: &[f64]) -> Self {
        let bounds = Bounds { farthest: FARTHEST, longest_move: LONGEST_MOVE };
        let State { positions, velocities, fold_angles, .. } = start;
        let mut kernel = Kernel::new(model, true, bounds, positions, velocities, fold_angles, 1);
        kernel.set_targets(targets.iter().copied());
        Self(kernel)
    }

    /// One step of `time_step`.
    pub fn step(&mut self, time_step: f64) {
        self.0.springs(true);
        self.0.euler(time_step);
    }
}
