//! The Hessian as a sparse matrix: its lower triangle by columns, the rows of fixed nodes left out.

use std::sync::Arc;

use faer::Side;
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use glam::{DMat3, DVec3};

use crate::forces::hessian;
use crate::model::Model;
use crate::scene::{Axes, Force, Held, Scene};
use crate::solve::State;
use crate::solve::row_sums::{OnTheWay, all_row_sums};

/// Which of the two triangles of a symmetric matrix is stored.
pub(super) const STORED: Side = Side::Lower;

/// The Hessian of a sheet's energy. Where its entries may be depends on the model, the supports and forces of one's own.
#[derive(Debug)]
pub(super) struct Matrix<'m> {
    model: &'m Model,
    /// By node: its number among those that move.
    place: Vec<Option<usize>>,
    /// By node that moves: those of at least its own number that it shares a spring with, itself first, in order.
    below: Vec<Vec<usize>>,
    /// By node that moves: where its values begin.
    starts: Vec<usize>,
    structure: SymbolicSparseColMat<usize>,
    values: Vec<f64>,
    shifted: Vec<f64>,
    /// By node that moves: the row sum of its stiffness, with which shifts are weighted.
    weights: Vec<f64>,
    row_sums: Vec<f64>,
    own: Vec<Arc<dyn Force>>,
    /// Nodes that move along some axes only: their number among those that move, and the axes that are held.
    guided: Vec<(usize, Axes)>,
}

impl<'m> Matrix<'m> {
    pub(super) fn new(model: &'m Model, scene: &Scene) -> Self {
        let held = Held::new(model, scene);
        let mut place = vec![Some(0); model.node_count()];
        for (node, _) in held.iter().filter(|(_, axes)| *axes == Axes::ALL) {
            place[node.index()] = None;
        }
        let mut moving = 0;
        for place in place.iter_mut().flatten() {
            *place = moving;
            moving += 1;
        }
        let guided = held.iter().filter_map(|(node, axes)| place[node.index()].map(|place| (place, axes))).collect();
        let below = neighbours(model, &scene.forces, &place, moving);
        let starts: Vec<usize> = below
            .iter()
            .scan(0, |next, list| {
                let start = *next;
                *next += 9 * list.len() - 3;
                Some(start)
            })
            .collect();
        let structure = structure(&below);
        let values = vec![0.0; structure.row_idx().len()];
        let (weights, row_sums) = (vec![0.0; moving], vec![0.0; model.node_count()]);
        let own = scene.forces.clone();
        Self { model, place, below, starts, structure, shifted: values.clone(), values, weights, row_sums, own, guided }
    }

    /// Rows.
    pub(super) fn size(&self) -> usize {
        3 * self.below.len()
    }

    pub(super) fn structure(&self) -> &SymbolicSparseColMat<usize> {
        &self.structure
    }

    /// Computes the values at `state`, and the weights.
    pub(super) fn assemble(&mut self, state: &State) {
        self.values.fill(0.0);
        let (place, below, starts, values) = (&self.place, &self.below, &self.starts, &mut self.values);
        let mut enter = |i: usize, j: usize, block: DMat3| {
            let (Some(i), Some(j)) = (place[i], place[j]) else { return };
            let (row, column, block) = if i >= j { (i, j, block) } else { (j, i, block.transpose()) };
            // All nodes of a spring are among each other's neighbours.
            let Ok(at) = below[column].binary_search(&row) else { return };
            add(&mut values[starts[column]..], below[column].len(), at, &free(&self.guided, row, column, block));
        };
        hessian::blocks(self.model, &state.positions, &state.targets, &state.fold_angles, &mut enter);
        for own in &self.own {
            own.add_hessian(&state.positions, &mut |i, j, block| enter(i.index(), j.index(), block));
        }
        all_row_sums(false, (self.model, &OnTheWay::default(), &self.own), &state.positions, &mut self.row_sums);
        for (place, sum) in self.place.iter().zip(&self.row_sums) {
            if let Some(place) = place {
                self.weights[*place] = *sum;
            }
        }
        // What is held does not move: its own entry alone is left, and no force acts on it.
        for (node, axes) in &self.guided {
            for (column, _) in axes.to_array().iter().enumerate().filter(|(_, held)| **held) {
                self.values[self.starts[*node] + offset(column, self.below[*node].len())] = self.weights[*node];
            }
        }
    }

    /// The matrix plus `shift` times the weights on its diagonal.
    pub(super) fn shifted(&mut self, shift: f64) -> SparseColMatRef<'_, usize, f64> {
        self.shifted.copy_from_slice(&self.values);
        for ((start, list), weight) in self.starts.iter().zip(&self.below).zip(&self.weights) {
            for column in 0..3 {
                self.shifted[start + offset(column, list.len())] += shift * weight;
            }
        }
        SparseColMatRef::new(self.structure.as_ref(), &self.shifted)
    }

    /// `v . W v` with the weights W.
    pub(super) fn weighted_square(&self, v: &[DVec3]) -> f64 {
        let each =
            self.place.iter().zip(v).filter_map(|(place, v)| place.map(|p| self.weights[p] * v.length_squared()));
        each.sum()
    }

    /// The weights by node, those of fixed ones included.
    pub(super) fn row_sums(&self) -> &[f64] {
        &self.row_sums
    }

    /// The largest weight.
    pub(super) fn largest_weight(&self) -> f64 {
        self.weights.iter().copied().fold(0.0, f64::max)
    }

    /// The smallest weight.
    pub(super) fn least_weight(&self) -> f64 {
        self.weights.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// The weights on `v`, by node.
    pub(super) fn weigh(&self, v: &[DVec3]) -> Vec<DVec3> {
        self.place.iter().zip(v).map(|(place, v)| place.map_or(DVec3::ZERO, |p| *v * self.weights[p])).collect()
    }

    /// Vectors of nodes as a column, and back.
    pub(super) fn gather(&self, of_nodes: &[DVec3], column: &mut [f64]) {
        for (place, v) in self.place.iter().zip(of_nodes) {
            if let Some(place) = place {
                column[3 * place..3 * place + 3].copy_from_slice(&v.to_array());
            }
        }
    }

    pub(super) fn scatter(&self, column: &[f64], of_nodes: &mut [DVec3]) {
        for (place, v) in self.place.iter().zip(of_nodes) {
            *v = place.map_or(DVec3::ZERO, |p| DVec3::from_slice(&column[3 * p..]));
        }
    }
}

/// Where the diagonal entry of a node's column 0, 1 or 2 lies among its values, if it has so many neighbours.
fn offset(column: usize, neighbours: usize) -> usize {
    match column {
        0 => 0,
        1 => 3 * neighbours,
        _ => 6 * neighbours - 1,
    }
}

/// Adds a block to the values of its column of nodes; `at` is the place of its row among the neighbours.
fn add(values: &mut [f64], neighbours: usize, at: usize, block: &DMat3) {
    for column in 0..3 {
        let start = offset(column, neighbours);
        let entries = block.col(column).to_array();
        if at == 0 {
            for (value, entry) in values[start..].iter_mut().zip(&entries[column..]) {
                *value += entry;
            }
        } else {
            for (value, entry) in values[start + 3 * at - column..].iter_mut().zip(entries) {
                *value += entry;
            }
        }
    }
}

/// A block without the rows and columns that are held.
fn free(guided: &[(usize, Axes)], row: usize, column: usize, block: DMat3) -> DMat3 {
    let axes = |node: usize| guided.iter().find(|(own, _)| *own == node).map(|(_, axes)| *axes);
    let block = axes(row).map_or(block, |axes| {
        DMat3::from_cols(axes.without(block.x_axis), axes.without(block.y_axis), axes.without(block.z_axis))
    });
    axes(column).map_or(block, |axes| {
        let kept = |held: bool, column: DVec3| if held { DVec3::ZERO } else { column };
        DMat3::from_cols(kept(axes.x, block.x_axis), kept(axes.y, block.y_axis), kept(axes.z, block.z_axis))
    })
}

fn neighbours(model: &Model, own: &[Arc<dyn Force>], place: &[Option<usize>], moving: usize) -> Vec<Vec<usize>> {
    let mut below: Vec<Vec<usize>> = (0..moving).map(|i| vec![i]).collect();
    let mut connect = |nodes: &[usize]| {
        for (i, a) in nodes.iter().enumerate() {
            for b in &nodes[..i] {
                if let (Some(a), Some(b)) = (place[*a], place[*b]) {
                    below[a.min(b)].push(a.max(b));
                }
            }
        }
    };
    model.beams.iter().for_each(|beam| connect(&beam.nodes.map(|n| n.index())));
    model.creases.iter().for_each(|crease| connect(&crease.nodes.map(|n| n.index())));
    model.corner_angles.iter().for_each(|corners| connect(&corners.nodes.map(|n| n.index())));
    for pair in own.iter().flat_map(|own| own.pairs()) {
        connect(&pair.map(|n| n.index()));
    }
    for list in &mut below {
        list.sort_unstable();
        list.dedup();
    }
    below
}

fn structure(below: &[Vec<usize>]) -> SymbolicSparseColMat<usize> {
    let (mut columns, mut rows) = (vec![0], Vec::new());
    for list in below {
        for column in 0..3 {
            let all = list.iter().flat_map(|node| 3 * node..3 * node + 3);
            rows.extend(all.skip(column));
            columns.push(rows.len());
        }
    }
    let size = 3 * below.len();
    SymbolicSparseColMat::new_checked(size, size, columns, None, rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::catalog;
    use crate::ids::NodeId;
    use crate::model::Material;
    use crate::solve::row_sums::row_sums;

    #[test]
    fn holds_the_lower_triangle_of_what_the_springs_say() {
        let pattern = catalog::generate("bird-base", &[]).expect("a pattern");
        let mut model = Model::new(&pattern, &Material::default()).expect("valid");
        model.fixed = vec![NodeId(2), NodeId(7)];
        let mut state = State::perturbed(&model, 0.1, 1);
        state.targets = model.targets(40.0);
        let size = 3 * model.node_count();
        let mut dense = vec![vec![0.0; size]; size];
        hessian::blocks(&model, &state.positions, &state.targets, &state.fold_angles, &mut |i, j, block| {
            for row in 0..3 {
                for column in 0..3 {
                    dense[3 * i + row][3 * j + column] += block.col(column)[row];
                    if i != j {
                        dense[3 * j + column][3 * i + row] += block.col(column)[row];
                    }
                }
            }
        });
        let moving: Vec<usize> = (0..size).filter(|k| ![2, 7].contains(&(k / 3))).collect();
        let mut matrix = Matrix::new(&model, &Scene::default());
        matrix.assemble(&state);
        let mut sums = vec![0.0; model.node_count()];
        row_sums(&model, &state.positions, &mut sums);
        assert_eq!(matrix.size(), moving.len());
        let shifted = matrix.shifted(0.5);
        for (column, j) in moving.iter().enumerate() {
            for (row, i) in moving.iter().enumerate().skip(column) {
                let expected = dense[*i][*j] + if i == j { 0.5 * sums[i / 3] } else { 0.0 };
                let got = shifted.get(row, column).copied().unwrap_or(0.0);
                assert!((got - expected).abs() < 1e-12, "row {i}, column {j}: {got} is not {expected}");
            }
        }
    }
}
