//! Why a sheet has no flat-folded state.

use crate::ids::VertexId;

/// Why a sheet has no flat-folded state that can be found by reflecting its facets.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NotFlat {
    /// The file gives a sheet that is folded or bent already.
    #[error("the sheet does not lie in a plane of constant height; expected a flat crease pattern")]
    Sheet,
    /// A crease is asked for an angle between flat and folded.
    #[error(
        "the crease between vertices {} and {} is asked for {degrees:.6} degrees; expected 0 or 180: 100 % or -100 % of a \
         pattern that folds flat",
        vertices[0].0, vertices[1].0
    )]
    Angle {
        /// Its ends.
        vertices: [VertexId; 2],
        /// The angle, in degrees.
        degrees: f64,
    },
    /// Two facets meet at an edge that has no spring, so that nothing says how it folds.
    #[error("nothing asks for an angle between vertices {} and {}; expected a crease with a target", .0[0].0, .0[1].0)]
    Undriven([VertexId; 2]),
    /// The facets do not meet again around a vertex or a hole.
    #[error("folded flat the sheet misses itself by {spread:.1e} of its radius at vertex {}; expected {tolerance:e} at most", vertex.0)]
    Open {
        /// The farthest that an image of a vertex, by one of its facets, lies from the mean of all of them, in radii.
        spread: f64,
        /// The vertex.
        vertex: VertexId,
        /// How far it may.
        tolerance: f64,
    },
    /// Vertices are held at places that they do not have in the flat-folded sheet.
    #[error("vertex {} is held {distance:.1e} of the radius from where it lies in the flat-folded sheet; expected the vertices of one face", vertex.0)]
    Held {
        /// One of them.
        vertex: VertexId,
        /// How far it is from there, in radii.
        distance: f64,
    },
}
