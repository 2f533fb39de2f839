//! What a page is told of a pattern that was opened.

use serde::Serialize;

use super::wishes::Wishes;

/// What a page needs to know of a pattern.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Opened {
    /// The file's name.
    pub name: String,
    /// The file's format, or that it was generated.
    pub format: String,
    /// The title in the file, where it has one.
    pub title: Option<String>,
    /// Nodes of the sheet.
    pub nodes: usize,
    /// Triangles of the sheet.
    pub triangles: usize,
    /// Edges of the pattern, borders included.
    pub edges: usize,
    /// Creases with a spring, diagonals of faces among them.
    pub creases: usize,
    /// Letters of the edges in FOLD, one for each.
    pub letters: String,
    /// Whether the pattern lies in one plane.
    pub flat: bool,
    /// What computes.
    pub computer: String,
    /// The steps of the sequence in the file; empty where it has none.
    pub steps: Vec<String>,
    /// What is odd about it.
    pub warnings: Vec<Note>,
    /// What is asked of it.
    pub wishes: Wishes,
}

/// Something odd, and where.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Note {
    /// The kind, as in reports of the command line.
    pub code: &'static str,
    /// For a person.
    pub text: String,
    /// Nodes where it is.
    pub nodes: Vec<u32>,
    /// Edges where it is.
    pub edges: Vec<u32>,
}
