//! Pairs measured side by side: the distances of [`super::distance`] and the barrier of [`super::barrier`] without a branch.
//!
//! Each is a loop over rows of numbers that the compiler turns into vector instructions, of the best set that the processor
//! has. Products and sums are rounded as written in all of them, so that results have the same bits.

mod barrier;
mod edges;
mod point_triangle;
mod star;
#[cfg(test)]
mod tests;

pub(super) use barrier::{Push, push};
pub(super) use edges::{measure_edges, measure_ends};
pub(super) use point_triangle::measure_points;
pub(super) use star::{Arms, not_below_zero};

use glam::DVec3;

use super::distance::PARALLEL;
use crate::ids::NodeId;

/// How many pairs lie side by side.
pub(super) const WIDTH: usize = 32;

/// A number of each.
pub(super) type Row = [f64; WIDTH];
/// A vector of each, by coordinate.
pub(super) type Rows = [Row; 3];

/// What is known of pairs of one kind before they are measured.
#[derive(Clone, Debug)]
pub(super) struct Given {
    /// The places of their four points.
    pub(super) points: [Rows; 4],
    /// See [`super::pairs::Pair`].
    pub(super) closed: Row,
    pub(super) width: Row,
    pub(super) eased: Row,
}

impl Given {
    pub(super) fn new() -> Self {
        Self { points: [[[0.0; WIDTH]; 3]; 4], closed: [0.0; WIDTH], width: [1.0; WIDTH], eased: [1.0; WIDTH] }
    }

    /// Puts pair `i` at the places of its nodes.
    #[inline(always)]
    pub(super) fn place(&mut self, i: usize, nodes: &[NodeId; 4], positions: &[DVec3]) {
        for (rows, node) in self.points.iter_mut().zip(nodes) {
            let DVec3 { x, y, z } = positions[node.index()];
            (rows[0][i], rows[1][i], rows[2][i]) = (x, y, z);
        }
    }

    #[inline(always)]
    fn points(&self, i: usize) -> [DVec3; 4] {
        let at = |point: &Rows| DVec3::new(point[0][i], point[1][i], point[2][i]);
        [at(&self.points[0]), at(&self.points[1]), at(&self.points[2]), at(&self.points[3])]
    }
}

/// What is measured of them.
#[derive(Clone, Debug)]
pub(super) struct Measured {
    /// See [`super::distance::Nearest`].
    pub(super) weights: [Row; 4],
    /// See [`super::pairs::Near`].
    pub(super) normal: Rows,
    pub(super) gap: Row,
    /// Of edges: the squared sine of the angle that they enclose; 0 where one has no length.
    sine: Row,
}

impl Measured {
    pub(super) fn new() -> Self {
        Self { weights: [[0.0; WIDTH]; 4], normal: [[0.0; WIDTH]; 3], gap: [0.0; WIDTH], sine: [1.0; WIDTH] }
    }

    /// Whether the edges of pair `i` are so nearly parallel that their ends have to be looked at.
    #[inline(always)]
    pub(super) fn is_parallel(&self, i: usize) -> bool {
        self.sine[i] <= PARALLEL
    }

    /// The normal of pair `i`.
    #[inline(always)]
    pub(super) fn normal(&self, i: usize) -> DVec3 {
        DVec3::new(self.normal[0][i], self.normal[1][i], self.normal[2][i])
    }

    /// Which nodes of pair `i` have a weight that is not 0, as bits.
    #[inline(always)]
    pub(super) fn nodes(&self, i: usize) -> u8 {
        let bits = self.weights.iter().enumerate().map(|(node, row)| u8::from(row[i] != 0.0) << node);
        bits.fold(0, |all, bit| all | bit)
    }

    /// Takes the nearest points of pair `i`.
    #[inline(always)]
    fn set(&mut self, i: usize, weights: [f64; 4], apart: DVec3, closed: f64) {
        let distance = apart.length_squared().sqrt();
        let inverse = choose(distance > 0.0, 1.0 / distance, 0.0);
        for (row, weight) in self.weights.iter_mut().zip(weights) {
            row[i] = weight;
        }
        self.normal[0][i] = apart.x * inverse;
        self.normal[1][i] = apart.y * inverse;
        self.normal[2][i] = apart.z * inverse;
        self.gap[i] = distance - closed;
    }
}

/// One of two numbers that are both at hand.
#[inline(always)]
fn choose(first: bool, one: f64, other: f64) -> f64 {
    if first { one } else { other }
}

/// From 0 to 1.
#[inline(always)]
fn clamped(x: f64) -> f64 {
    choose(x > 0.0, choose(x < 1.0, x, 1.0), 0.0)
}
