//! `edges_assignment`: what the letters say.

use super::notes::Notes;
use crate::error::{Error, ErrorCode, Place, WarningCode};
use crate::fold::Frame;
use crate::pattern::crease_pattern::Assignment;

/// A letter of FOLD 1.2, cuts included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Letter {
    Boundary,
    Mountain,
    Valley,
    Flat,
    Unassigned,
    Cut,
    Join,
}

impl Letter {
    fn parse(text: &str) -> Option<Self> {
        Some(match text {
            "B" => Self::Boundary,
            "M" => Self::Mountain,
            "V" => Self::Valley,
            "F" => Self::Flat,
            "U" => Self::Unassigned,
            "C" => Self::Cut,
            "J" => Self::Join,
            _ => return None,
        })
    }

    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Cut => "C",
            other => other.assignment().letter(),
        }
    }

    /// Mountain or valley.
    pub(super) const fn drives(self) -> bool {
        matches!(self, Self::Mountain | Self::Valley)
    }

    /// Whether it stands where a second line of the same ends says mountain or valley.
    pub(super) const fn wins_over_driving(self) -> bool {
        matches!(self, Self::Mountain | Self::Valley | Self::Boundary | Self::Cut)
    }

    /// The assignment of the finished pattern; a cut that is still there is a free hinge.
    pub(super) const fn assignment(self) -> Assignment {
        match self {
            Self::Boundary => Assignment::Boundary,
            Self::Mountain => Assignment::Mountain,
            Self::Valley => Assignment::Valley,
            Self::Flat => Assignment::Flat,
            Self::Unassigned | Self::Cut => Assignment::Unassigned,
            Self::Join => Assignment::Join,
        }
    }
}

/// The letter of each edge; `None` where the frame has none.
pub(super) fn read(frame: &Frame, edges: usize, notes: &mut Notes) -> Result<Vec<Option<Letter>>, Error> {
    let Some(texts) = &frame.edges_assignment else { return Ok(vec![None; edges]) };
    same_length("edges_assignment", texts.len(), edges)?;
    let mut letters = Vec::with_capacity(edges);
    for (index, text) in texts.iter().enumerate() {
        let letter = Letter::parse(text).or_else(|| {
            let upper = Letter::parse(&text.to_ascii_uppercase())?;
            let message = "lower-case letter, taken as upper case";
            notes.add(WarningCode::LowerCase, "edges_assignment", index, message);
            Some(upper)
        });
        let letter = letter.unwrap_or_else(|| {
            let shown: String = text.chars().take(12).collect();
            notes.add_with(WarningCode::UnknownLetter, "is none of B, M, V, F, U, C and J; taken as U", || {
                (Place::entry("edges_assignment", index), format!("{shown:?}"))
            });
            Letter::Unassigned
        });
        letters.push(Some(letter));
    }
    Ok(letters)
}

/// Refuses an array under `key` that does not have one entry for each edge.
pub(super) fn same_length(key: &'static str, entries: usize, edges: usize) -> Result<(), Error> {
    if entries == edges {
        return Ok(());
    }
    let problem = format!("has {entries} entries where edges_vertices has {edges}");
    Err(Error::new(ErrorCode::WrongLength, Place::key(key), problem, "one entry for each edge"))
}
