//! Contact as Newton's method sees it: one more force, with an energy and a Hessian.

use std::collections::BTreeSet;
use std::sync::{Mutex, MutexGuard, PoisonError};

use glam::{DMat3, DVec3};

use crate::contact::Layers;
use crate::contact::hessian::{blocks, pairs};
use crate::ids::NodeId;
use crate::model::Built;
use crate::scene::Force;

/// The layers of a sheet, wherever they were last measured.
#[derive(Debug)]
pub(super) struct Pressed(Mutex<Inner>);

#[derive(Debug)]
struct Inner {
    layers: Layers,
    /// Where they were measured last.
    at: Vec<DVec3>,
    /// Nodes between which the Hessian may have a block.
    pattern: BTreeSet<[NodeId; 2]>,
    /// Whether the Hessian is without what curves downwards.
    projected: bool,
}

impl Inner {
    fn measure(&mut self, positions: &[DVec3]) {
        if self.at == positions {
            return;
        }
        let moved = self.at.iter().zip(positions).map(|(a, b)| (*b - *a).length()).fold(0.0, f64::max);
        self.layers.moved(moved);
        self.layers.measure(positions);
        self.at.clear();
        self.at.extend_from_slice(positions);
    }
}

impl Pressed {
    /// Those of layers that were measured at `positions`.
    pub(super) fn new(layers: Layers, positions: &[DVec3]) -> Self {
        let pattern = BTreeSet::new();
        Self(Mutex::new(Inner { layers, at: positions.to_vec(), pattern, projected: false }))
    }

    fn inner(&self) -> MutexGuard<'_, Inner> {
        // Nothing is left half done by who panics.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes up all that pushes at `positions` into what [`Force::pairs`] tells, and says which Hessian is wanted.
    pub(super) fn grow(&self, positions: &[DVec3], projected: bool) {
        let mut inner = self.inner();
        inner.measure(positions);
        inner.projected = projected;
        let Inner { layers, pattern, .. } = &mut *inner;
        pattern.extend(pairs(layers));
    }

    /// Whether something pushes that was not taken up, where it was last measured.
    pub(super) fn outgrown(&self) -> bool {
        let inner = self.inner();
        pairs(&inner.layers).any(|pair| !inner.pattern.contains(&pair))
    }

    /// The largest share of all moves alike with which nothing goes through anything.
    pub(super) fn share(&self, positions: &[DVec3], moves: &[DVec3]) -> f64 {
        let mut inner = self.inner();
        inner.measure(positions);
        let longest = moves.iter().map(|by| by.length()).fold(0.0, f64::max);
        let share = (inner.layers.longest_move() / longest).min(1.0);
        let moves: Vec<DVec3> = moves.iter().map(|by| *by * share).collect();
        inner.layers.limit_alike(positions, &moves) * share
    }

    /// Looks at the layers as they are at `positions`.
    pub(super) fn look<T>(&self, positions: &[DVec3], at: impl FnOnce(&Layers) -> T) -> T {
        let mut inner = self.inner();
        inner.measure(positions);
        at(&inner.layers)
    }
}

impl Force for Pressed {
    fn inventory(&self) -> Built {
        Built { what: "contact", count: self.inner().layers.count() }
    }

    fn add_forces(&self, positions: &[DVec3], _: &[DVec3], forces: &mut [DVec3]) {
        let mut sums = vec![0.0; forces.len()];
        self.look(positions, |layers| layers.add(positions, forces, &mut sums));
    }

    fn energy(&self, positions: &[DVec3]) -> Option<f64> {
        Some(self.look(positions, |layers| layers.energy(positions)))
    }

    fn add_row_sums(&self, positions: &[DVec3], sums: &mut [f64]) -> bool {
        let mut forces = vec![DVec3::ZERO; sums.len()];
        self.look(positions, |layers| layers.add(positions, &mut forces, sums));
        true
    }

    fn add_hessian(&self, positions: &[DVec3], add: &mut dyn FnMut(NodeId, NodeId, DMat3)) -> bool {
        let projected = self.inner().projected;
        self.look(positions, |layers| blocks(layers, positions, projected, add));
        true
    }

    fn pairs(&self) -> Vec<[NodeId; 2]> {
        self.inner().pattern.iter().copied().collect()
    }
}
