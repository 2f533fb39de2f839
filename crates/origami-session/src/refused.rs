//! Why a request was refused.

use origami_core::Error;
use origami_core::solve::Failed;

/// A kind, as in reports of the command line, and a text for a person.
pub(crate) struct Refused {
    pub(crate) code: String,
    pub(crate) text: String,
}

impl From<Error> for Refused {
    fn from(error: Error) -> Self {
        Self { code: error.code().name().to_owned(), text: error.to_string() }
    }
}

impl From<Failed> for Refused {
    fn from(failed: Failed) -> Self {
        Self { code: "solver".to_owned(), text: failed.to_string() }
    }
}

impl Refused {
    pub(crate) fn request(text: &str) -> Self {
        Self { code: "request".to_owned(), text: text.to_owned() }
    }

    pub(crate) fn reading(name: &str, error: &Error) -> Self {
        Self { code: error.code().name().to_owned(), text: format!("{name}: {error}") }
    }
}
