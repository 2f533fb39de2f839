//! Pairs that press so hard that they are much stiffer than springs.

use glam::DVec3;

use crate::ids::NodeId;

/// Pairs with less than this share of their width left are stiff.
pub(super) const STIFF: f64 = 0.1;

/// A stiff pair, or several with the same two nearest points. Its stiffness pulls at the distance of these points and at nothing
/// else: `stiffness u u^T`, where u is the normal at each node, times its weight. A bound on the rows of that would hold its nodes
/// in all directions, and with them whatever else they are to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stiff {
    pub(crate) nodes: [NodeId; 4],
    /// Of the nearest points; those of the second thing are below 0, and one that does not count is 0.
    pub(crate) weights: [f64; 4],
    /// From the second thing to the first.
    pub(crate) normal: DVec3,
    pub(crate) stiffness: f64,
}

impl Stiff {
    /// How far vectors at its nodes take its nearest points apart.
    pub(crate) fn apart(&self, vectors: &[DVec3]) -> f64 {
        self.nodes.iter().zip(self.weights).map(|(node, weight)| weight * vectors[node.index()].dot(self.normal)).sum()
    }

    /// By node, what takes the nearest points apart.
    pub(crate) fn pulls(&self) -> impl Iterator<Item = (NodeId, DVec3)> {
        self.nodes.into_iter().zip(self.weights.map(|weight| weight * self.normal))
    }
}
