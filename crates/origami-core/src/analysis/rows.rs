//! The rows of a structure's equations: which degrees of freedom are free.

use glam::DVec3;

use super::dof::Dof;
use super::structure::Structure;

/// The rows of a structure's equations: its free degrees of freedom, in order.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    /// By degree of freedom.
    row: Vec<Option<usize>>,
    free: Vec<usize>,
}

impl Rows {
    pub(super) fn new(structure: &Structure) -> Self {
        let mut row = vec![Some(0); 3 * structure.nodes.len()];
        let moved = structure.supports.moved.iter().map(|(dof, _)| dof);
        for dof in structure.supports.fixed.iter().chain(moved) {
            row[dof.index()] = None;
        }
        let free: Vec<usize> = (0..row.len()).filter(|i| row[*i].is_some()).collect();
        for (number, i) in free.iter().enumerate() {
            row[*i] = Some(number);
        }
        Self { row, free }
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.free.len()
    }

    /// That of node and axis; `None` where it is held or moved.
    pub(super) fn of(&self, node: usize, axis: usize) -> Option<usize> {
        self.row[3 * node + axis]
    }

    /// Those of a list by node.
    pub(super) fn gather(&self, vectors: &[DVec3]) -> Vec<f64> {
        self.free.iter().map(|i| vectors[i / 3][i % 3]).collect()
    }

    /// Adds `share` times a column to a list by node.
    pub(super) fn add(&self, share: f64, column: &[f64], vectors: &mut [DVec3]) {
        for (i, x) in self.free.iter().zip(column) {
            vectors[i / 3][i % 3] += share * x;
        }
    }

    /// A column as a list by node, 0 where nodes are held.
    pub(super) fn scatter(&self, column: &[f64]) -> Vec<DVec3> {
        let mut vectors = vec![DVec3::ZERO; self.row.len() / 3];
        self.add(1.0, column, &mut vectors);
        vectors
    }

    /// Those that are held or moved, in order.
    pub(super) fn held(&self) -> impl Iterator<Item = Dof> + '_ {
        (0..self.row.len()).filter(|i| self.row[*i].is_none()).map(Dof::at)
    }
}
