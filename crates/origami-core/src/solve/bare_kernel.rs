//! The passes of the paper's scheme without anything around them: what benches compare steps with.

use super::{Precision, State};
use crate::kernel::{Bounds, Isa, Kernel};
use crate::model::Model;
use crate::twins::state_bounds::{FARTHEST, LONGEST_MOVE};

/// A sheet on one thread, moved by the paper's scheme; nothing watches it.
#[doc(hidden)]
#[derive(Debug)]
pub struct BareKernel(Numbers);

#[derive(Debug)]
enum Numbers {
    F64(Kernel<f64>),
    Mixed(Kernel<f32>),
}

impl BareKernel {
    /// The sheet of `start` in f64, its creases asked for `targets`, by the best instructions of this processor.
    #[must_use]
    pub fn new(model: &Model, start: &State, targets: &[f64]) -> Self {
        Self::on(Isa::best(), Precision::F64, model, start, targets)
    }

    /// The sets of instructions of this processor, the best one last.
    #[must_use]
    pub fn instructions() -> Vec<&'static str> {
        Isa::all().into_iter().map(Isa::name).collect()
    }

    /// The same by one of these sets, in f64 or mixed; `None` for a set that this processor has not.
    #[must_use]
    pub fn by(name: &str, precision: Precision, model: &Model, start: &State, targets: &[f64]) -> Option<Self> {
        let isa = Isa::all().into_iter().find(|isa| isa.name() == name)?;
        Some(Self::on(isa, precision, model, start, targets))
    }

    fn on(isa: Isa, precision: Precision, model: &Model, start: &State, targets: &[f64]) -> Self {
        let bounds = Bounds { farthest: FARTHEST, longest_move: LONGEST_MOVE };
        let State { positions, velocities, fold_angles, .. } = start;
        let mut numbers = match precision {
            Precision::F64 => {
                Numbers::F64(Kernel::with((isa, 1), model, true, bounds, positions, velocities, fold_angles))
            }
            Precision::Mixed => {
                Numbers::Mixed(Kernel::with((isa, 1), model, true, bounds, positions, velocities, fold_angles))
            }
        };
        match &mut numbers {
            Numbers::F64(kernel) => kernel.set_targets(targets.iter().copied()),
            Numbers::Mixed(kernel) => kernel.set_targets(targets.iter().copied()),
        }
        Self(numbers)
    }

    /// One step of `time_step`.
    pub fn step(&mut self, time_step: f64) {
        match &mut self.0 {
            Numbers::F64(kernel) => {
                kernel.springs(true);
                kernel.euler(time_step);
            }
            Numbers::Mixed(kernel) => {
                kernel.springs(true);
                kernel.euler(time_step);
            }
        }
    }
}
