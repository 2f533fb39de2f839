//! A point and a triangle, or two edges, that have no node in common and may touch.
//!
//! Pairs with a common node are left out: two triangles that share a corner or a side can only meet where a side of one meets
//! the other with which it has no node in common, so that such a pair has closed its gap before.

use glam::DVec3;

use super::barrier::{Barrier, NEARER, mollifier};
use super::distance::{Nearest, of_edges, of_point_and_triangle};
use crate::ids::NodeId;

/// A point and a triangle, or two edges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pair {
    /// The point and the corners, or the ends of both edges.
    pub(super) nodes: [NodeId; 4],
    /// How many of these the first thing has: 1 of a point and a triangle, 2 of two edges.
    pub(super) split: usize,
    /// The distance at which it is closed, in radii: 0 of paper without thickness.
    pub(super) closed: f64,
    /// The gap from which it pushes, in radii.
    pub(super) width: f64,
    /// Of two edges what [`super::barrier::mollifier`] wants.
    pub(super) eased: f64,
}

/// A pair, measured at the present positions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    /// Its place in the list.
    pub(super) pair: u32,
    pub(super) weights: [f64; 4],
    /// From the second thing to the first, of length 1.
    pub(super) normal: DVec3,
    /// The distance but for what is closed.
    pub(super) gap: f64,
}

impl Pair {
    /// One of which nothing is known but its nodes; it never pushes.
    pub(super) fn unmeasured(nodes: [NodeId; 4], split: usize) -> Self {
        Self { nodes, split, closed: 0.0, width: 0.0, eased: 0.0 }
    }

    pub(super) fn points(&self, positions: &[DVec3]) -> [DVec3; 4] {
        self.nodes.map(|n| positions[n.index()])
    }

    pub(super) fn nearest(&self, points: &[DVec3; 4]) -> Nearest {
        if self.split == 1 { of_point_and_triangle(points) } else { of_edges(points) }
    }

    /// Measures it; `number` is its place in the list.
    pub(super) fn near(&self, number: u32, positions: &[DVec3]) -> Near {
        let Nearest { weights, apart } = self.nearest(&self.points(positions));
        let distance = apart.length();
        let normal = if distance > 0.0 { apart / distance } else { DVec3::ZERO };
        Near { pair: number, weights, normal, gap: distance - self.closed }
    }

    /// The force on each of its nodes as it is measured, and a bound on the row sum of its stiffness.
    pub(super) fn push(&self, near: &Near, positions: &[DVec3], stiffness: f64) -> [(DVec3, f64); 4] {
        let (factor, gradient) = eased(self, positions);
        let Barrier { energy, slope, .. } = Barrier::of(near.gap, self.width, stiffness);
        let curvature = Barrier::of(NEARER * near.gap, self.width, stiffness).curvature;
        std::array::from_fn(|i| {
            let weight = near.weights[i];
            let force = -(factor * slope * weight * near.normal + energy * gradient[i]);
            (force, 2.0 * factor * curvature * weight.abs())
        })
    }
}

/// The factor by which a pair at these positions pushes less, with its gradient by the four points.
pub(super) fn eased(pair: &Pair, positions: &[DVec3]) -> (f64, [DVec3; 4]) {
    if pair.split == 2 { mollifier(&pair.points(positions), pair.eased) } else { (1.0, [DVec3::ZERO; 4]) }
}
