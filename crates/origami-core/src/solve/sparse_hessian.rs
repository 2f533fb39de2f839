//! The Hessian of a state as data.

use glam::DMat3;

use super::State;
use crate::forces::hessian::blocks;
use crate::model::Model;
use crate::scene::Scene;

/// The second derivatives of the energy by all positions, as compressed columns: `3 n` rows and columns for `n` nodes, x, y
/// and z of one node after the other. Symmetric, and both triangles are there. Column `c` has its entries in
/// `starts[c]..starts[c + 1]` of `rows` and `values`, rows ascending. Supports have no part in it: held nodes have their rows
/// and columns too.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SparseHessian {
    /// Where each column begins, and the end of the last: `3 n + 1` numbers.
    pub starts: Vec<usize>,
    /// The row of each entry.
    pub rows: Vec<usize>,
    /// The entries, in the model's unit of force per radius.
    pub values: Vec<f64>,
}

impl SparseHessian {
    /// How many rows and columns there are.
    #[must_use]
    pub fn size(&self) -> usize {
        self.starts.len() - 1
    }

    /// The product with a column of as many numbers as there are rows.
    #[must_use]
    pub fn times(&self, column: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; self.size()];
        for (c, x) in column.iter().enumerate().take(self.size()) {
            for entry in self.starts[c]..self.starts[c + 1] {
                product[self.rows[entry]] += self.values[entry] * x;
            }
        }
        product
    }
}

impl State {
    /// The Hessian of the energy of springs and of the scene's own forces; dead loads have none. `None` where a force has
    /// no Hessian.
    #[must_use]
    pub fn hessian(&self, model: &Model, scene: &Scene) -> Option<SparseHessian> {
        // Block (row, column) and its transpose, for each pair of nodes.
        let mut entries: Vec<(usize, usize, DMat3)> = Vec::new();
        let mut enter = |i: usize, j: usize, block: DMat3| {
            entries.push((j, i, block));
            if i != j {
                entries.push((i, j, block.transpose()));
            }
        };
        blocks(model, &self.positions, &self.targets, &self.fold_angles, &mut enter);
        for own in &scene.forces {
            if !own.add_hessian(&self.positions, &mut |i, j, block| enter(i.index(), j.index(), block)) {
                return None;
            }
        }
        // Stable: blocks of one pair are added in the order of the springs.
        entries.sort_by_key(|(column, row, _)| (*column, *row));
        let merged = entries.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1));
        let merged: Vec<(usize, usize, DMat3)> = merged
            .map(|same| (same[0].0, same[0].1, same.iter().fold(DMat3::ZERO, |sum, entry| sum + entry.2)))
            .collect();
        let mut of_nodes = merged.chunk_by(|a, b| a.0 == b.0).peekable();
        let mut hessian = SparseHessian { starts: vec![0], rows: Vec::new(), values: Vec::new() };
        for node in 0..model.node_count() {
            let own = of_nodes.next_if(|own| own[0].0 == node).unwrap_or_default();
            for axis in 0..3 {
                for (_, row, block) in own {
                    hessian.rows.extend(3 * row..3 * row + 3);
                    hessian.values.extend(block.col(axis).to_array());
                }
                hessian.starts.push(hessian.rows.len());
            }
        }
        Some(hessian)
    }
}
