//! Held nodes and loaded nodes.

use std::ops::BitOr;

use glam::DVec3;

use crate::ids::NodeId;

/// Directions in which a node is held.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Axes {
    /// Along x.
    pub x: bool,
    /// Along y.
    pub y: bool,
    /// Along z.
    pub z: bool,
}

impl Axes {
    /// Along x alone.
    pub const X: Self = Self { x: true, y: false, z: false };
    /// Along y alone.
    pub const Y: Self = Self { x: false, y: true, z: false };
    /// Along z alone.
    pub const Z: Self = Self { x: false, y: false, z: true };
    /// In every direction.
    pub const ALL: Self = Self { x: true, y: true, z: true };

    /// The part of `vector` along these axes.
    #[must_use]
    pub fn of(self, vector: DVec3) -> DVec3 {
        let part = |held: bool, x: f64| if held { x } else { 0.0 };
        DVec3::new(part(self.x, vector.x), part(self.y, vector.y), part(self.z, vector.z))
    }

    /// The rest of `vector`.
    #[must_use]
    pub fn without(self, vector: DVec3) -> DVec3 {
        Self { x: !self.x, y: !self.y, z: !self.z }.of(vector)
    }

    /// `held` along these axes, `free` along the others.
    #[must_use]
    pub fn choose(self, held: DVec3, free: DVec3) -> DVec3 {
        self.of(held) + self.without(free)
    }

    /// The three in order.
    #[must_use]
    pub fn to_array(self) -> [bool; 3] {
        [self.x, self.y, self.z]
    }
}

impl BitOr for Axes {
    type Output = Self;

    fn bitor(self, other: Self) -> Self {
        Self { x: self.x || other.x, y: self.y || other.y, z: self.z || other.z }
    }
}

/// A node that is held along some axes: there it has no velocity, and stays where it is or where it is put.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Support {
    /// The node.
    pub node: NodeId,
    /// The directions in which it is held.
    pub axes: Axes,
    /// Where it is held along these axes, in radii of the sheet; `None`: where it is when the run begins.
    pub position: Option<DVec3>,
}

impl Support {
    /// Holds `node` where it is, in every direction.
    #[must_use]
    pub fn fixed(node: NodeId) -> Self {
        Self { node, axes: Axes::ALL, position: None }
    }

    /// Holds `node` where it is, along some axes.
    #[must_use]
    pub fn along(node: NodeId, axes: Axes) -> Self {
        Self { node, axes, position: None }
    }

    /// The same at a prescribed position, in radii of the sheet.
    #[must_use]
    pub fn at(self, position: DVec3) -> Self {
        Self { position: Some(position), ..self }
    }
}

/// A dead load: a force on a node that keeps its direction and size as the sheet moves.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Load {
    /// The node.
    pub node: NodeId,
    /// The force, in the model's unit of force (that of [`Material::ea`](crate::Material::ea)).
    pub force: DVec3,
}

/// What a support does to the node that it holds.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Reaction {
    /// The node.
    pub node: NodeId,
    /// The force of the support on the node; 0 along axes that are free.
    pub force: DVec3,
}
