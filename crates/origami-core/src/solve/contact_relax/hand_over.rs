//! Newton's method for a sheet on which the relaxation crawls.

use std::ops::ControlFlow;

use glam::DVec3;

use super::super::Progress;
use super::super::newton::approach::{Approach, approach_touching};
use super::super::relax::default_ramp;
use super::run::Run;

/// Under contact it takes over after this share of the time that [`Relax::hand_over`](super::super::Relax::hand_over) says: where
/// layers slide on each other nodes are as heavy as they are pressed, and FIRE is slow long before it stops.
const SHARE: f64 = 0.5;
/// Sheets of more nodes are not handed over: in a stack each node has to do with all that lie on it.
const LARGEST: usize = 2000;
/// Factorisations after which Newton's method gives a sheet back to FIRE.
const FACTORISATIONS: u32 = 60;

impl Run<'_> {
    /// Whether it is time for Newton's method.
    pub(super) fn crawls(&self) -> bool {
        let relax = &self.solver.relax;
        let may = !self.handed_over && self.ramp.done() && relax.steps.is_none() && self.model.node_count() <= LARGEST;
        let ramp = f64::from(default_ramp(self.model));
        let is_over = |ramps| (self.steps - self.arrived) as f64 > SHARE * f64::from(ramps) * ramp;
        may && relax.hand_over.is_some_and(is_over)
    }

    /// Goes downhill by Newton's method, of which steps are shortened as moves are; FIRE goes on from there, and has the last word.
    /// A sheet that contact holds up is left to FIRE.
    pub(super) fn hand_over(
        &mut self,
        limit: u64,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
        look: &mut dyn FnMut(u64, &[DVec3]),
    ) -> ControlFlow<()> {
        self.handed_over = true;
        if self.is_held_up() {
            return ControlFlow::Continue(());
        }
        let mut state = self.state();
        state.targets = self.ramp.asked().to_vec();
        let mut layers = self.layers.clone();
        layers.measure(&self.positions);
        let limits = (self.solver.relax.tolerance, FACTORISATIONS, limit - self.steps);
        let (so_far, distance) = (self.steps, self.settling.distance());
        let mut watch = |evaluations, positions: &[DVec3]| {
            let step = so_far + evaluations;
            look(step, positions);
            observe(Progress { step, ramp: 1.0, distance })
        };
        let approached = approach_touching((self.model, self.scene), (state, layers), limits, &mut watch);
        let Some(Approach { state, cancelled, factorisations, evaluations }) = approached else {
            return ControlFlow::Continue(());
        };
        self.steps += evaluations;
        self.factorisations += factorisations;
        self.go_on_from(&state);
        if cancelled { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
