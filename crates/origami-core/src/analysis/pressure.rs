//! Follower pressure: on the corners of a triangle (a, b, c) a third each of `p (b - a) x (c - a) / 2`.
//!
//! Over a closed surface, or one whose rim is held, these forces are the gradient of pressure times volume, and their
//! derivative is symmetric. Over any other they have no energy; the tangent then has the symmetric part of the derivative:
//! the states found are the same, with more iterations, and stability is only as good as that part.

use glam::{DMat3, DVec3};

use super::structure::Loads;

impl Loads {
    /// Adds the forces at load factor 1, dead loads included.
    pub(super) fn add_forces(&self, positions: &[DVec3], forces: &mut [DVec3]) {
        for (node, force) in &self.points {
            forces[node.index()] += *force;
        }
        for (nodes, pressure) in &self.pressures {
            let [a, b, c] = nodes.map(|n| positions[n.index()]);
            let share = (b - a).cross(c - a) * (pressure / 6.0);
            nodes.iter().for_each(|n| forces[n.index()] += share);
        }
    }

    /// Hands `add(i, j, block)` the symmetric part of minus `factor` times their derivative, each pair once.
    pub(super) fn blocks(&self, factor: f64, positions: &[DVec3], add: &mut impl FnMut(usize, usize, DMat3)) {
        for (nodes, pressure) in &self.pressures {
            let [a, b, c] = nodes.map(|n| positions[n.index()]);
            // The force on any corner changes by opposite side x move, cyclically.
            let by = [c - b, a - c, b - a].map(|side| cross_matrix(side) * (-factor * pressure / 6.0));
            let index = nodes.map(|n| n.index());
            for i in 0..3 {
                for j in 0..=i {
                    // Block (i, j) is by[j]; of it and the transpose of block (j, i) the mean.
                    add(index[i], index[j], (by[j] + by[i].transpose()) * 0.5);
                }
            }
        }
    }
}

/// The matrix of `v -> a x v`.
fn cross_matrix(a: DVec3) -> DMat3 {
    DMat3::from_cols(DVec3::new(0.0, a.z, -a.y), DVec3::new(-a.z, 0.0, a.x), DVec3::new(a.y, -a.x, 0.0))
}
