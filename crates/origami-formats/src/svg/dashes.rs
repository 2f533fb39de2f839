//! Diagrams in one colour: the pattern of dashes is the letter.

use crate::colours::Letter;

/// How a stroke is dashed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dashes {
    /// Not at all.
    Solid,
    /// One length of dash.
    Dashed,
    /// Dashes of two lengths or more.
    DashDotted,
}

impl Dashes {
    /// From the lengths of dashes and gaps.
    pub(super) fn of(lengths: &[f64]) -> Self {
        // An odd number of lengths is gone through twice.
        let twice = if lengths.len().is_multiple_of(2) { lengths.to_vec() } else { [lengths, lengths].concat() };
        let dashes: Vec<f64> = twice.iter().copied().step_by(2).collect();
        let longest = dashes.iter().copied().fold(0.0, f64::max);
        let gaps: f64 = twice.iter().copied().skip(1).step_by(2).sum();
        match dashes.iter().copied().fold(f64::INFINITY, f64::min) {
            _ if longest <= 0.0 || gaps <= 0.0 => Self::Solid,
            // Two dashes are of two lengths if one is shorter by a quarter.
            shortest if lengths.len() > 1 && shortest < 0.75 * longest => Self::DashDotted,
            _ => Self::Dashed,
        }
    }

    /// What it stands for where all lines are of one colour.
    pub(super) fn letter(self) -> Letter {
        match self {
            Self::Solid => Letter::Boundary,
            Self::Dashed => Letter::Valley,
            Self::DashDotted => Letter::Mountain,
        }
    }
}
