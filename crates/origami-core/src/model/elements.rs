//! The three kinds of spring, with everything about them that never changes.

use crate::ids::{NodeId, SideId, TriangleId};

/// A bar along a side (paper 2.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// Its ends.
    pub nodes: [NodeId; 2],
    /// Rest length l0, in radii.
    pub rest_length: f64,
    /// k = EA / l0.
    pub stiffness: f64,
}

/// A hinge with a spring (paper 2.3). Triangle (3, 4, 1) lies to the left of the line from 3 to 4, (4, 3, 2) to the right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crease {
    /// Apexes 1 and 2, then ends 3 and 4.
    pub nodes: [NodeId; 4],
    /// k = l0 times the stiffness per unit of length.
    pub stiffness: f64,
    /// Fold angle asked for at 100 %, in radians, valley positive.
    pub goal: f64,
    /// Fold angle of the sheet as the file gives it, in radians.
    pub rest_angle: f64,
    /// The side it lies on.
    pub side: SideId,
}

/// The three corner angles of a triangle (paper 2.4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CornerAngles {
    /// Corners, counterclockwise.
    pub nodes: [NodeId; 3],
    /// Cosine and sine of the first two angles at rest; the third follows, as they sum to pi.
    pub rest: [(f64, f64); 2],
    /// The triangle.
    pub triangle: TriangleId,
}
