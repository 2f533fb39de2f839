//! What was joined in a pattern though its file has it apart.

use crate::ids::{EdgeId, VertexId};

/// A near miss: a vertex that was joined to another one, or to a line, though it lay farther away than rounding explains.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Join {
    /// The vertex.
    pub vertex: VertexId,
    /// What it is now one with, or on.
    pub with: JoinedTo,
    /// How far apart they are in the file, in its unit of length.
    pub distance: f64,
    /// Whether a border ends there: then the outline of the sheet has changed.
    pub border: bool,
}

/// What a vertex was joined to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum JoinedTo {
    /// Another vertex, which stands for both.
    Vertex(VertexId),
    /// An edge of the file, which is split there.
    Edge(EdgeId),
}
