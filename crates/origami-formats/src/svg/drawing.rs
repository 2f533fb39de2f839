//! What the walk over the tree comes back with.

use kurbo::PathSeg;

use super::dashes::Dashes;
use super::notes::Notes;
use super::places::Element;

/// A stroke as drawn: its colour is not yet a letter.
#[derive(Debug)]
pub(super) struct Mark {
    /// In user units, y up.
    pub(super) path: Vec<PathSeg>,
    pub(super) colour: [u8; 3],
    /// From 0 to 1: of the stroke, its element, the groups around it, and the colour itself.
    pub(super) opacity: f64,
    pub(super) dashes: Dashes,
    pub(super) element: Element,
}

/// All marks of a file.
#[derive(Debug, Default)]
pub(super) struct Drawing {
    pub(super) marks: Vec<Mark>,
    pub(super) title: Option<String>,
    pub(super) notes: Notes,
}
