//! What a file is.

use std::path::Path;

/// A format that can be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Format {
    /// FOLD: JSON.
    Fold,
    /// CP: a line a crease, of Oripa, Orihime, Oriedita and CP Editor.
    Cp,
    /// SVG: strokes whose colours are letters.
    Svg,
}

impl Format {
    /// The format of a file, by its content; what nothing speaks for is taken for FOLD, whose reader says what is wrong.
    #[must_use]
    pub fn of(bytes: &[u8], _name: Option<&Path>) -> Self {
        let first = bytes.iter().find(|byte| !byte.is_ascii_whitespace());
        match first {
            Some(b'<') => Self::Svg,
            Some(first) if first.is_ascii_digit() => Self::Cp,
            _ => Self::Fold,
        }
    }
}
