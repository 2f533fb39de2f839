//! Kinds of lines, and which of them to draw.

use std::str::FromStr;

use origami_core::Error;
use origami_core::pattern::{Assignment, PatternEdge};

/// What a line of a picture stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum LineKind {
    /// Folds away from the viewer of the front.
    Mountain,
    /// Folds towards the viewer of the front.
    Valley,
    /// The rim of the paper.
    Boundary,
    /// Stays flat: lettered so, or a diagonal of the triangulation.
    Facet,
    /// Both lips of a cut.
    Cut,
    /// A hinge that nothing drives.
    Undriven,
}

impl LineKind {
    /// All kinds, in the order in which they are numbered.
    pub const ALL: [Self; 6] = [Self::Mountain, Self::Valley, Self::Boundary, Self::Facet, Self::Cut, Self::Undriven];

    /// What an edge of a pattern is drawn as, cuts apart: in a pattern they are boundaries.
    #[must_use]
    pub fn of(edge: &PatternEdge) -> Self {
        match (edge.assignment, edge.fold_angle) {
            (Assignment::Boundary, _) => Self::Boundary,
            (Assignment::Flat | Assignment::Join, _) => Self::Facet,
            (Assignment::Mountain, Some(_)) => Self::Mountain,
            (Assignment::Valley, Some(_)) => Self::Valley,
            _ => Self::Undriven,
        }
    }

    /// Its letter in a [`LineSet`], as FOLD has it.
    #[must_use]
    pub const fn letter(self) -> char {
        match self {
            Self::Mountain => 'M',
            Self::Valley => 'V',
            Self::Boundary => 'B',
            Self::Facet => 'F',
            Self::Cut => 'C',
            Self::Undriven => 'U',
        }
    }

    /// The name of the kind.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Mountain => "mountain",
            Self::Valley => "valley",
            Self::Boundary => "boundary",
            Self::Facet => "facet",
            Self::Cut => "cut",
            Self::Undriven => "undriven",
        }
    }
}

/// A line between two nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// The nodes at its ends.
    pub nodes: [u32; 2],
    /// How far along its chain each end lies, in radii on the flat sheet: dashes run on from line to line.
    pub along: [f32; 2],
    /// What the line stands for.
    pub kind: LineKind,
    /// The triangles beside it: it is drawn in front of these.
    pub triangles: [Option<u32>; 2],
}

/// Kinds of lines that a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LineSet(u8);

impl LineSet {
    /// No lines.
    pub const NONE: Self = Self(0);
    /// All lines, those of the triangulation included.
    pub const ALL: Self = Self(0b11_1111);

    /// With lines of this kind.
    #[must_use]
    pub const fn with(self, kind: LineKind) -> Self {
        Self(self.0 | 1 << kind as u8)
    }

    /// Whether lines of this kind are drawn.
    #[must_use]
    pub const fn has(self, kind: LineKind) -> bool {
        self.0 & 1 << kind as u8 != 0
    }
}

/// All but [`LineKind::Facet`].
impl Default for LineSet {
    fn default() -> Self {
        Self(Self::ALL.0 & !Self::NONE.with(LineKind::Facet).0)
    }
}

/// From `all`, `none` or letters such as `MVB` (commas and lower case are fine).
impl FromStr for LineSet {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        match text {
            "all" => return Ok(Self::ALL),
            "none" => return Ok(Self::NONE),
            _ => {}
        }
        let mut set = Self::NONE;
        for letter in text.chars().filter(|c| !matches!(c, ',' | ' ')) {
            let kind = LineKind::ALL.into_iter().find(|kind| kind.letter() == letter.to_ascii_uppercase());
            let wrong = || Error::invalid("edges", format!("{letter:?}"), "letters of MVBFCU, all or none");
            set = set.with(kind.ok_or_else(wrong)?);
        }
        Ok(set)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_are_read_as_written() {
        let set: LineSet = "M,v B".parse().unwrap();
        let shown: String = LineKind::ALL.into_iter().filter(|kind| set.has(*kind)).map(LineKind::letter).collect();
        assert_eq!(shown, "MVB");
        assert_eq!("mvbfcu".parse::<LineSet>().unwrap(), LineSet::ALL);
        assert!(!LineSet::default().has(LineKind::Facet) && LineSet::default().has(LineKind::Undriven));
        assert!("MX".parse::<LineSet>().unwrap_err().to_string().starts_with("edges: 'X'"));
        for (number, kind) in LineKind::ALL.into_iter().enumerate() {
            assert_eq!(kind as usize, number);
        }
    }
}
