//! Folding step by step: which creases fold when, how far, and which of them are free or held meanwhile.
//!
//! A [`Sequence`] is what a file says ([`Sequence::from_slice`], [`Sequence::in_frame`], [`Sequence::of_frames`]). For a sheet
//! it becomes a list of [`Stage`]s ([`Sequence::stages`]), which a solver goes through one after the other
//! ([`crate::solve::fold_sequence`]). `docs/SEQUENCES.md` in the repository has the format.

mod frames;
mod read;
mod select;
mod stages;
mod timeline;

pub use read::{Ease, Mode, Selector, Step, To};
pub use stages::{Stage, Stiffness};

use crate::error::{Error, ErrorCode, Place};

/// The key of a sequence in a FOLD file.
pub const SEQUENCE: &str = "origami:sequence";
/// The key of the groups that edges belong to.
pub const GROUP: &str = "edges_origami:group";
/// The key of the short form: when each crease folds.
pub const TIMELINE: &str = "edges_origami:timeline";
/// The key of a folded frame for the step that it shows.
pub const STEP: &str = "origami:step";

/// A folding sequence as a file has it.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Sequence {
    /// The steps in their order; at least one.
    pub steps: Vec<Step>,
    /// For each edge of the file the groups that it belongs to; may be shorter.
    pub groups: Vec<Vec<String>>,
}

/// What is wrong with a step.
fn wrong(index: usize, step: &Step, problem: impl std::fmt::Display, expected: &str) -> Error {
    let place = Place::key(SEQUENCE).within(&format!(".steps[{index}]"));
    let problem = if step.name.is_empty() { problem.to_string() } else { format!("`{}`: {problem}", step.name) };
    Error::new(ErrorCode::WrongValue, place, problem, expected)
}
