//! What a page is told.

use serde::Serialize;

use super::catalog::CatalogEntry;
use super::frame::FrameHead;
use super::opened::Opened;
use super::wishes::Wishes;

/// What a page is told.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "is", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Reply {
    /// What can be generated.
    Catalog {
        /// All of it.
        entries: Vec<CatalogEntry>,
    },
    /// A pattern was opened; the body has, of four bytes each: x, y, z of each node at rest in radii; three nodes of each
    /// triangle; two nodes of each edge; the fold angle of each edge in degrees, not a number where it has none; the face of each
    /// triangle.
    Opened(Box<Opened>),
    /// What is asked of the sheet, where that has changed by other means than what the page has just asked.
    Wishes {
        /// Now.
        wishes: Wishes,
        /// Whether there is a mark to go back to.
        can_undo: bool,
        /// Whether there is one to go forward to.
        can_redo: bool,
    },
    /// What there is to go back and forward to, once a mark was set.
    Marked {
        /// Whether there is a mark to go back to.
        can_undo: bool,
        /// Whether there is one to go forward to.
        can_redo: bool,
    },
    /// A picture; the body has x, y, z and the map's value of each node as f32.
    Frame(Box<FrameHead>),
    /// A file, in the body.
    File {
        /// Its name.
        name: String,
        /// Its media type.
        media: &'static str,
    },
    /// Something could not be done. The sheet is as it was.
    Error {
        /// The kind, as in reports of the command line; `request` where the page has asked for what there is not.
        code: String,
        /// For a person, as the command line says it.
        text: String,
    },
}
