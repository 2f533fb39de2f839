//! Where a structure is.

use glam::DVec3;

/// Positions of the nodes and angles of the hinges. Angles are kept besides positions, which do not know whole turns.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Configuration {
    /// By node, in the structure's unit of length.
    pub positions: Vec<DVec3>,
    /// By hinge, in radians.
    pub fold_angles: Vec<f64>,
}
