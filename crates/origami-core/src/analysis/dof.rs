//! Degrees of freedom.

use glam::DVec3;

use crate::ids::NodeId;

/// One of the three directions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Axis {
    /// Along x.
    X,
    /// Along y.
    Y,
    /// Along z.
    Z,
}

impl Axis {
    /// The three in order.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// 0, 1 or 2.
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }

    /// `x`, `y` or `z`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        ["x", "y", "z"][self.index()]
    }
}

/// A node in one direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
pub struct Dof {
    /// The node.
    pub node: NodeId,
    /// The direction.
    pub axis: Axis,
}

impl Dof {
    /// The degree of freedom of `node` along `axis`.
    #[must_use]
    pub const fn new(node: NodeId, axis: Axis) -> Self {
        Self { node, axis }
    }

    /// Its entry in a list by node.
    #[must_use]
    pub fn of(self, vectors: &[DVec3]) -> f64 {
        vectors[self.node.index()][self.axis.index()]
    }

    pub(super) fn index(self) -> usize {
        3 * self.node.index() + self.axis.index()
    }

    pub(super) fn at(index: usize) -> Self {
        Self { node: NodeId::new(index / 3), axis: Axis::ALL[index % 3] }
    }
}
