//! What both solvers do around their steps: reading the kernel's state, watching it, and handing it over.

use glam::DVec3;

use super::guard::{COPY_EVERY, Diverged, FARTHEST, Guard, LONGEST_MOVE};
use super::settle::Settling;
use super::{Folded, State, Stop, largest};
use crate::forces::Forces;
use crate::kernel::{Bounds, Compute, Kernel};
use crate::model::Model;

/// A sheet in motion. `state` is what was last read; it has no targets, and nothing but positions at first.
pub(super) struct Motion<'m, R: Compute> {
    pub(super) model: &'m Model,
    pub(super) kernel: Kernel<R>,
    pub(super) state: State,
    pub(super) settling: Settling,
    guard: Guard<'m>,
    /// Where velocities are extrapolated by them.
    accelerations: Vec<DVec3>,
}

impl<'m, R: Compute> Motion<'m, R> {
    /// The sheet of `start`, which is handed back where it diverges at once, with its nodes at `positions` and moving at
    /// `velocities`; all at rest where there are none. Forces of damping are there to be asked for where it is `damped`.
    /// `threads` of this thread's pool share the passes.
    pub(super) fn new(
        model: &'m Model,
        start: &'m State,
        (positions, velocities): (Vec<DVec3>, &[DVec3]),
        damped: bool,
        tolerance: f64,
        threads: usize,
    ) -> Self {
        let bounds = Bounds { farthest: FARTHEST, longest_move: LONGEST_MOVE };
        Self {
            model,
            kernel: Kernel::new(model, damped, bounds, &positions, velocities, &start.fold_angles, threads),
            state: State { positions, ..State::default() },
            settling: Settling::new(model, tolerance),
            guard: Guard::new(model, start),
            accelerations: Vec::new(),
        }
    }

    /// Takes note of an evaluation whose forces are those of the springs alone; true when the state has settled.
    pub(super) fn settled(&mut self) -> bool {
        let kernel = &self.kernel;
        self.settling.observe(|positions, forces| {
            kernel.read_positions(positions);
            kernel.read_forces(forces);
        })
    }

    /// After step `step`, which moved every node by about `time_step` times its velocity: an error where the state is
    /// out of bounds, which `holds` says that it surely is not; now and then a copy of the state. Velocities that are
    /// extrapolated (Verlet's) are taken back by the time `ahead` to those that moved the nodes.
    pub(super) fn check(&mut self, holds: bool, step: u64, time_step: f64, ahead: f64) -> Result<(), Diverged> {
        if holds && !step.is_multiple_of(COPY_EVERY) {
            return Ok(());
        }
        self.read();
        if ahead > 0.0 {
            self.read_accelerations();
            for (velocity, acceleration) in self.state.velocities.iter_mut().zip(&self.accelerations) {
                *velocity -= *acceleration * ahead;
            }
        }
        self.guard.check(step, &self.state, time_step)
    }

    pub(super) fn read_positions(&mut self) {
        self.kernel.read_positions(&mut self.state.positions);
    }

    pub(super) fn read_nodes(&mut self) {
        self.read_positions();
        self.kernel.read_velocities(&mut self.state.velocities);
    }

    pub(super) fn read(&mut self) {
        self.read_nodes();
        self.state.fold_angles.resize(self.model.creases.len(), 0.0);
        self.kernel.read_angles(&mut self.state.fold_angles);
    }

    pub(super) fn read_accelerations(&mut self) {
        self.kernel.read_accelerations(&mut self.accelerations);
    }

    /// The state, asked for `targets`; `end` gets it with the accelerations that were last read and its forces.
    pub(super) fn into_folded(
        mut self,
        targets: Vec<f64>,
        (percent, stop, steps, time_step): (f64, Stop, u64, f64),
        end: impl FnOnce(&mut State, &[DVec3], &mut [DVec3]),
    ) -> Folded {
        self.read();
        let Self { model, kernel, state, settling, guard, accelerations } = self;
        let distance = settling.distance();
        // A large sheet's forces need the memory.
        drop((kernel, settling, guard));
        let mut state = State { targets, ..state };
        let mut forces = Forces::new(model);
        let values = forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles);
        let residual = largest(values);
        end(&mut state, &accelerations, values);
        Folded { state, percent, stop, steps, time_step, residual, distance, attempts: 1 }
    }
}
