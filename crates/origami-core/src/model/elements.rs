//! The three kinds of spring, with everything about them that never changes.

use crate::ids::{NodeId, SideId, TriangleId};

/// Which number a crease's stiffness comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum StiffnessSource {
    /// [`Material::k_fold`](super::Material::k_fold): mountains, valleys, and flat creases with a target angle.
    Fold,
    /// [`Material::k_facet`](super::Material::k_facet): flat creases and the diagonals of faces.
    Facet,
    /// The pattern's own for that edge, `edges_origami:k_crease`.
    Own,
}

/// A beam along a side (paper 2.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// Its ends.
    pub nodes: [NodeId; 2],
    /// Rest length l0, in radii.
    pub rest_length: f64,
    /// k = EA / l0.
    pub stiffness: f64,
    /// Whether EA is the pattern's own for that edge (`edges_origami:ea`), not the material's.
    pub own: bool,
}

/// A hinge with a spring (paper 2.3). Triangle (3, 4, 1) lies to the left of the line from 3 to 4, (4, 3, 2) to the right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crease {
    /// Apexes 1 and 2, then ends 3 and 4.
    pub nodes: [NodeId; 4],
    /// k = l0 times the stiffness per unit of length, a moment per radian.
    pub stiffness: f64,
    /// Where the stiffness per unit of length comes from.
    pub source: StiffnessSource,
    /// Target angle at 100 %, in radians, valley positive.
    pub full_target: f64,
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
