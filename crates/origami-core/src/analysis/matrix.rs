//! The tangent stiffness as a sparse matrix: the lower triangle, a row for each free degree of freedom.

use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use glam::DMat3;

use super::rows::Rows;
use super::structure::Structure;

/// A symmetric matrix with entries where members join degrees of freedom.
#[derive(Debug)]
pub(super) struct Matrix {
    structure: SymbolicSparseColMat<usize>,
    values: Vec<f64>,
    shifted: Vec<f64>,
}

impl Matrix {
    pub(super) fn new(structure: &Structure, rows: &Rows) -> Self {
        let below = neighbours(structure);
        let (mut columns, mut entries) = (vec![0], Vec::new());
        for (node, below) in below.iter().enumerate() {
            for column in (0..3).filter_map(|axis| rows.of(node, axis)) {
                let all = below.iter().flat_map(|node| (0..3).filter_map(|axis| rows.of(*node, axis)));
                entries.extend(all.filter(|row| *row >= column));
                columns.push(entries.len());
            }
        }
        let structure = SymbolicSparseColMat::new_checked(rows.len(), rows.len(), columns, None, entries);
        let values = vec![0.0; structure.row_idx().len()];
        Self { structure, shifted: values.clone(), values }
    }

    pub(super) fn structure(&self) -> &SymbolicSparseColMat<usize> {
        &self.structure
    }

    pub(super) fn clear(&mut self) {
        self.values.fill(0.0);
    }

    /// Adds the block of two nodes, or of one with itself; what is held has no row.
    pub(super) fn add(&mut self, rows: &Rows, i: usize, j: usize, block: DMat3) {
        let (row_node, column_node, block) = if i >= j { (i, j, block) } else { (j, i, block.transpose()) };
        for axis in 0..3 {
            let Some(column) = rows.of(column_node, axis) else { continue };
            let start = self.structure.col_ptr()[column];
            let entries = &self.structure.row_idx()[start..self.structure.col_ptr()[column + 1]];
            for (across, value) in block.col(axis).to_array().into_iter().enumerate() {
                let Some(row) = rows.of(row_node, across).filter(|row| *row >= column) else { continue };
                // All nodes of a member are among each other's neighbours.
                if let Ok(at) = entries.binary_search(&row) {
                    self.values[start + at] += value;
                }
            }
        }
    }

    /// All entries, in their order.
    pub(super) fn values(&self) -> &[f64] {
        &self.values
    }

    /// Other ones in their places.
    pub(super) fn set_values(&mut self, values: impl Iterator<Item = f64>) {
        self.values.iter_mut().zip(values).for_each(|(own, value)| *own = value);
    }

    pub(super) fn as_ref(&self) -> SparseColMatRef<'_, usize, f64> {
        SparseColMatRef::new(self.structure.as_ref(), &self.values)
    }

    /// The matrix with `shift` times `weights` on its diagonal.
    pub(super) fn shifted(&mut self, shift: f64, weights: &[f64]) -> SparseColMatRef<'_, usize, f64> {
        self.shifted.copy_from_slice(&self.values);
        for (start, weight) in self.structure.col_ptr().iter().zip(weights) {
            self.shifted[*start] += shift * weight;
        }
        SparseColMatRef::new(self.structure.as_ref(), &self.shifted)
    }

    /// The product with a column.
    pub(super) fn times(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; x.len()];
        for (column, bounds) in self.structure.col_ptr().windows(2).enumerate() {
            for entry in bounds[0]..bounds[1] {
                let (row, value) = (self.structure.row_idx()[entry], self.values[entry]);
                product[row] += value * x[column];
                if row != column {
                    product[column] += value * x[row];
                }
            }
        }
        product
    }

    /// The largest entry of the diagonal.
    pub(super) fn largest_diagonal(&self) -> f64 {
        let size = self.structure.ncols();
        self.structure.col_ptr()[..size].iter().map(|start| self.values[*start].abs()).fold(0.0, f64::max)
    }
}

/// By node: those of at least its own number that it shares a member with, itself first, in order.
fn neighbours(structure: &Structure) -> Vec<Vec<usize>> {
    let mut below: Vec<Vec<usize>> = (0..structure.nodes.len()).map(|i| vec![i]).collect();
    let mut connect = |nodes: &[crate::ids::NodeId]| {
        for (i, a) in nodes.iter().enumerate() {
            for b in &nodes[..i] {
                below[a.index().min(b.index())].push(a.index().max(b.index()));
            }
        }
    };
    structure.bars.iter().for_each(|bar| connect(&bar.nodes));
    structure.hinges.iter().for_each(|hinge| connect(&hinge.nodes));
    structure.corners.iter().for_each(|corners| connect(&corners.angles.nodes));
    structure.loads.pressures.iter().for_each(|(nodes, _)| connect(nodes));
    for list in &mut below {
        list.sort_unstable();
        list.dedup();
    }
    below
}
