//! Errors, for an input that cannot be used, and warnings, for one that is odd and was put right. Both have a code, which
//! says of which kind they are, and a [`Place`]: text for a person by `Display`, data for a program.

mod code;
mod place;
mod warning;

use std::fmt;

pub use code::{ErrorCode, WarningCode};
pub use place::{CreasePlace, Place};
pub use warning::Warning;

/// Why a pattern cannot be read, built or written. Every error names the place.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The operating system refused to read or write.
    #[error("{path}: {source}")]
    Io {
        /// The file, or `-` for a stream.
        path: String,
        /// The message of the operating system.
        source: std::io::Error,
    },
    /// The text is not JSON, or a value has the wrong type.
    #[error("{0}")]
    Syntax(Box<Syntax>),
    /// The input can be read, but what it says has no sensible meaning.
    #[error("{0}")]
    Invalid(Box<Invalid>),
}

/// The content of an [`Error::Syntax`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Syntax {
    /// Which kind of error it is.
    pub code: ErrorCode,
    /// Key and index where they are known, such as `edges_vertices[3][0]`; else line and column.
    pub place: Place,
    /// The line where the parser stopped, counted from 1.
    pub line: usize,
    /// The column where the parser stopped, counted in bytes.
    pub column: usize,
    /// The text that the parser met, and the one that it expected.
    pub problem: String,
}

impl fmt::Display for Syntax {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { place, line, column, problem, .. } = self;
        match place {
            Place::Line { .. } => write!(f, "{place}: {problem}"),
            _ => write!(f, "{place}: {problem} (line {line} column {column})"),
        }
    }
}

/// The content of an [`Error::Invalid`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Invalid {
    /// Which kind of error it is.
    pub code: ErrorCode,
    /// Where it is, such as `faces_vertices[12]`.
    pub place: Place,
    /// The problem, in words.
    pub problem: String,
    /// The values that would have been accepted, in words.
    pub expected: String,
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}; expected {}", self.place, self.problem, self.expected)
    }
}

impl Error {
    /// An [`Error::Invalid`] about a setting or an argument of a call, with the code [`ErrorCode::Setting`].
    pub fn invalid(setting: impl Into<Place>, problem: impl Into<String>, expected: impl Into<String>) -> Self {
        Self::new(ErrorCode::Setting, setting, problem, expected)
    }

    /// An [`Error::Invalid`] of any kind.
    pub fn new(
        code: ErrorCode,
        place: impl Into<Place>,
        problem: impl Into<String>,
        expected: impl Into<String>,
    ) -> Self {
        let (place, problem, expected) = (place.into(), problem.into(), expected.into());
        Self::Invalid(Box::new(Invalid { code, place, problem, expected }))
    }

    /// Which kind of error it is.
    #[must_use]
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::Io { .. } => ErrorCode::Io,
            Self::Syntax(syntax) => syntax.code,
            Self::Invalid(invalid) => invalid.code,
        }
    }

    /// Where it is.
    #[must_use]
    pub fn place(&self) -> Place {
        match self {
            Self::Io { path, .. } => Place::File(path.clone()),
            Self::Syntax(syntax) => syntax.place.clone(),
            Self::Invalid(invalid) => invalid.place.clone(),
        }
    }
}

/// To three digits, for a message.
pub(crate) fn rounded(x: f64) -> f64 {
    // No more than powers of ten have, which 0 would be.
    let size = x.abs().log10().floor().clamp(-400.0, 400.0);
    let power = 10f64.powi(2 - size as i32);
    if power.is_normal() { (x * power).round() / power } else { x }
}

/// A number in a message: huge and tiny ones as `1e300`, not with all their digits.
pub(crate) struct Short(pub(crate) f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(x) = *self;
        if x == 0.0 || !x.is_finite() || (1e-6..1e15).contains(&x.abs()) {
            write!(f, "{x}")
        } else {
            write!(f, "{x:e}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_three_digits_have_no_more() {
        let told = [1.0, 0.015, 0.0307, 1.619_99, 30.67, 1234.0, 0.0, 2.5e-7].map(|x| Short(rounded(x)).to_string());
        assert_eq!(told, ["1", "0.015", "0.0307", "1.62", "30.7", "1230", "0", "2.5e-7"]);
    }
}
