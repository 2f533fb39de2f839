//! Warnings: of oddities in an input that were put right, and of dangers in a scene.

use std::fmt;

use super::{Place, WarningCode};

/// Something odd in the input that was put right, or a danger in a scene, and where. Nothing needs to be done about it.
///
/// ```
/// use origami_core::error::WarningCode;
/// use origami_core::{CreasePattern, fold::Document};
///
/// let square = r#"{
///     "vertices_coords": [[0, 0], [1, 0], [1, 1], [0, 1]],
///     "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]],
///     "edges_assignment": ["B", "B", "B", "B", "v"]
/// }"#;
/// let mut pattern = CreasePattern::from_document(&Document::from_slice(square.as_bytes())?, 0)?;
/// let lower_case = pattern.warnings.iter().find(|warning| warning.code == WarningCode::LowerCase);
/// assert_eq!(lower_case.and_then(|warning| warning.place.edge()).map(|edge| edge.index()), Some(4));
/// // Muted: one kind of warning.
/// pattern.warnings.retain(|warning| warning.code != WarningCode::LowerCase);
/// # Ok::<(), origami_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Warning {
    /// Its kind.
    pub code: WarningCode,
    /// Its place; where several are alike, the first of them.
    pub place: Place,
    /// The oddity, what was done about it, and how many more of its kind there are.
    pub message: String,
}

impl Warning {
    /// A warning about `place`.
    pub fn new(code: WarningCode, place: impl Into<Place>, message: impl Into<String>) -> Self {
        Self { code, place: place.into(), message: message.into() }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.message)
    }
}
