//! The crease pattern as data: vertices at rest, lettered edges, faces.

use glam::DVec3;

use super::joins::Join;
use super::plane::{extent, is_flat};
use crate::error::Warning;
use crate::ids::{EdgeId, VertexId};

/// The kind of a line of the pattern (FOLD's `edges_assignment`; paper section 2.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Assignment {
    /// `B`: one side is not paper. Cut edges (`C`) become pairs of these.
    Boundary,
    /// `M`: folds away from the viewer, negative angles.
    Mountain,
    /// `V`: folds towards the viewer, positive angles.
    Valley,
    /// `F`: stays flat, with a spring.
    Flat,
    /// `U`: a hinge without a spring.
    Unassigned,
    /// `J`: the two faces are one; what a triangulation adds. Folds as [`Assignment::Flat`].
    Join,
}

impl Assignment {
    /// Its letter in a FOLD file.
    #[must_use]
    pub const fn letter(self) -> &'static str {
        match self {
            Self::Boundary => "B",
            Self::Mountain => "M",
            Self::Valley => "V",
            Self::Flat => "F",
            Self::Unassigned => "U",
            Self::Join => "J",
        }
    }
}

/// One edge of a [`CreasePattern`].
#[derive(Clone, Debug, PartialEq)]
pub struct PatternEdge {
    /// Its ends, in the file's order.
    pub vertices: [VertexId; 2],
    /// Its letter.
    pub assignment: Assignment,
    /// Target fold angle at 100 %, in radians, valley positive. `None`: nothing drives it (free, or no crease at all).
    pub fold_angle: Option<f64>,
    /// Crease stiffness in place of the material's (`edges_origami:k_crease`): as `k_fold` a moment per radian and per unit
    /// of length, that is a force per radian.
    pub k_crease: Option<f64>,
    /// Axial rigidity in place of the material's (`edges_origami:ea`): as `ea` a force.
    pub ea: Option<f64>,
    /// The edge that stands for this one, where the file has it twice (or it vanished in a merge).
    pub alias_of: Option<EdgeId>,
}

/// A crease pattern in the file's units. Its first vertices, edges and faces are numbered as in the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CreasePattern {
    /// Positions at rest, in the file's unit of length. All rest lengths and angles come from these.
    pub vertices: Vec<DVec3>,
    /// The vertex that stands for this one, where several lay at one point and were merged.
    pub alias_of: Vec<Option<VertexId>>,
    /// Lettered edges.
    pub edges: Vec<PatternEdge>,
    /// Polygons, counterclockwise seen from the side that letters and angles are meant for. No two corners of one face
    /// at one point, except where a slit or dangling crease makes its loop touch itself.
    pub faces: Vec<Vec<VertexId>>,
    /// Vertices that do not move (`vertices_origami:fixed`).
    pub fixed: Vec<VertexId>,
    /// How many vertices the file has; later ones were added (crossings, both lips of a cut).
    pub vertices_in_file: usize,
    /// How many edges the file has; later ones were added.
    pub edges_in_file: usize,
    /// Near misses of the file that were joined.
    pub joins: Vec<Join>,
    /// Area that the file's lines span and the faces do not: see [`Paper::lost`](super::Paper::lost).
    pub lost_area: f64,
    /// Oddities of the file that were put right.
    pub warnings: Vec<Warning>,
    /// For each edge where it was written in a file of another format, such as `line 12`; empty where nothing says it.
    pub sources: Vec<Box<str>>,
}

impl CreasePattern {
    /// The longest side of the box, along the axes, that holds all vertices; 0 without vertices. In the file's unit.
    #[must_use]
    pub fn size(&self) -> f64 {
        extent(&self.vertices).max_element()
    }

    /// Whether all vertices lie at one height z, to a billionth of the [`size`](Self::size).
    #[must_use]
    pub fn is_flat(&self) -> bool {
        is_flat(&self.vertices)
    }
}
