//! What can be wrong with an input, and what is odd about it but was put right.

use std::fmt;

/// Why a pattern cannot be read, built or written. Every variant names the place.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The operating system refused to read or write.
    #[error("{path}: {source}")]
    Io {
        /// The file, or `-`.
        path: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// The text is not JSON, or a value has the wrong type.
    #[error("{place}: {problem}")]
    Syntax {
        /// Key and index, such as `edges_vertices[3][0]`, or line and column.
        place: String,
        /// What the parser met and what it expected.
        problem: String,
    },
    /// The file is JSON, but what it says is not a crease pattern that can be folded.
    #[error("{place}: {problem}; expected {expected}")]
    Invalid {
        /// Key and index, such as `faces_vertices[12]`.
        place: String,
        /// What is there.
        problem: String,
        /// What should be there.
        expected: String,
    },
}

impl Error {
    /// An [`Error::Invalid`].
    pub fn invalid(place: impl Into<String>, problem: impl Into<String>, expected: impl Into<String>) -> Self {
        Self::Invalid { place: place.into(), problem: problem.into(), expected: expected.into() }
    }
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

/// Something odd in the input that was put right, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// Key and index, such as `edges_assignment[17]`.
    pub place: String,
    /// What is odd, and what was done about it.
    pub message: String,
}

impl Warning {
    /// A warning about `place`.
    pub fn new(place: impl Into<String>, message: impl Into<String>) -> Self {
        Self { place: place.into(), message: message.into() }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.message)
    }
}
