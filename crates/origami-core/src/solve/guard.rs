//! Divergence: found by magnitude, reported with its place, and the last good state handed back.

use std::fmt;

use glam::DVec3;

use super::State;
use crate::error::Short;
use crate::ids::{NodeId, VertexId};
use crate::model::Model;
use crate::twins::checkpoint::{COPY_EVERY, is_good};
use crate::twins::state_bounds::{FARTHEST, LONGEST_MOVE, in_bounds};

/// What grew beyond sense.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Quantity {
    /// The distance of a node from the centre, in radii.
    Position,
    /// How far a node moved in one step, in radii.
    Move,
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Position => "distance from the centre",
            Self::Move => "move in one step",
        })
    }
}

/// The state stopped being finite or grew beyond any sense.
#[derive(Clone, Debug, thiserror::Error)]
#[error(
    "diverged at step {step}: vertex {} has a {quantity} of {} radii (expected at most {})",
    vertex.0, Short(*value), quantity.limit()
)]
#[non_exhaustive]
pub struct Diverged {
    /// The first vertex, by number, that is out of bounds.
    pub vertex: VertexId,
    /// The step at which it was found.
    pub step: u64,
    /// What is out of bounds.
    pub quantity: Quantity,
    /// How large it is; may be NaN or infinite.
    pub value: f64,
    /// The last copy of the state that was still in bounds by far.
    pub last_good: Box<State>,
    /// The step of that copy.
    pub last_good_step: u64,
}

impl Quantity {
    fn limit(self) -> f64 {
        match self {
            Self::Position => FARTHEST,
            Self::Move => LONGEST_MOVE,
        }
    }
}

/// Watches a state from step to step.
#[derive(Clone, Debug, Default)]
pub(super) struct Guard {
    /// The last good state; none before the first one is copied: until then that is the start. Without targets.
    copy: Option<State>,
    copied_at: u64,
}

impl Guard {
    /// After step `step`, which moved every node by `time_step` times its velocity: an error where one is out of bounds;
    /// at every [`COPY_EVERY`]th a copy of a good state, whose targets are those of `start`, where the run began.
    pub(super) fn check(
        &mut self,
        (model, start): (&Model, &State),
        step: u64,
        state: &State,
        time_step: f64,
    ) -> Result<(), Diverged> {
        let nodes = || state.positions.iter().zip(&state.velocities).map(|(p, v)| (*p, *v * time_step));
        if let Some((node, (p, moved))) = nodes().enumerate().find(|(_, (p, moved))| !in_bounds(*p, *moved)) {
            let last_good = Box::new(self.last_good(start));
            return Err(Diverged::new(model, (NodeId::new(node), p, moved), step, last_good, self.copied_at));
        }
        if step.is_multiple_of(COPY_EVERY) && nodes().all(|(p, moved)| is_good(p, moved)) {
            self.copy(state);
            self.copied_at = step;
        }
        Ok(())
    }

    /// Into the memory of the copy before.
    fn copy(&mut self, state: &State) {
        let State { positions, velocities, fold_angles, .. } = state;
        let copy = self.copy.get_or_insert_default();
        copy.positions.clone_from(positions);
        copy.velocities.clone_from(velocities);
        copy.fold_angles.clone_from(fold_angles);
    }

    fn last_good(&self, start: &State) -> State {
        let copy = self.copy.as_ref().map(|copy| State { targets: start.targets.clone(), ..copy.clone() });
        copy.unwrap_or_else(|| start.clone())
    }
}

impl Diverged {
    /// Of a node that was found out of bounds after step `step`: where it is and how far it has just moved, both in radii.
    #[must_use]
    pub fn new(
        model: &Model,
        (node, position, moved): (NodeId, DVec3, DVec3),
        step: u64,
        last_good: Box<State>,
        last_good_step: u64,
    ) -> Self {
        let (quantity, value) = match position.length() {
            distance if distance <= FARTHEST => (Quantity::Move, moved.length()),
            distance => (Quantity::Position, distance),
        };
        Self { vertex: model.mesh.vertex_of_node[node.index()], step, quantity, value, last_good, last_good_step }
    }
}
