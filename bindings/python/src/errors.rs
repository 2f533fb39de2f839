//! Errors as the exceptions of `origami_sim.errors`, with their place as attributes.

use origami::Error;
use origami::error::Place;
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::{Map, Value};

use crate::notes::at;

/// Results whose errors Python knows as exceptions.
pub(crate) trait OrRaise<T> {
    /// The value, or the exception.
    fn or_raise(self) -> PyResult<T>;
}

impl<T> OrRaise<T> for Result<T, Error> {
    fn or_raise(self) -> PyResult<T> {
        self.map_err(|error| raised(&error))
    }
}

/// A setting or an argument that cannot be.
pub(crate) fn refused(name: impl Into<String>, problem: &str, expected: &str) -> PyErr {
    raised(&Error::invalid(name.into(), problem, expected))
}

/// What computes gave up, or is not to be had.
#[cfg(feature = "gpu")]
pub(crate) fn backend_error(message: &str) -> PyErr {
    exception("BackendError", message, Map::new(), |_| Ok(()))
}

/// A program's own word for what is wrong with a call.
pub(crate) fn refused_as(message: &str) -> PyErr {
    exception("Refused", message, Map::new(), |_| Ok(()))
}

fn raised(error: &Error) -> PyErr {
    let message = error.to_string();
    let mut details = place(&error.place());
    details.insert("code".into(), error.code().name().into());
    match error {
        Error::Io { path, source } => match source.raw_os_error() {
            // Python finds the subclass that the number stands for, such as `FileNotFoundError`.
            Some(number) => PyOSError::new_err((number, reason(source), path.clone())),
            None => PyOSError::new_err(message),
        },
        Error::Syntax(syntax) => {
            details.insert("line".into(), syntax.line.into());
            details.insert("column".into(), syntax.column.into());
            details.insert("problem".into(), syntax.problem.as_str().into());
            exception("PatternError", &message, details, |_| Ok(()))
        }
        Error::Invalid(invalid) => {
            details.insert("problem".into(), invalid.problem.as_str().into());
            details.insert("expected".into(), invalid.expected.as_str().into());
            let class = if matches!(invalid.place, Place::Setting(_)) { "Refused" } else { "PatternError" };
            exception(class, &message, details, |_| Ok(()))
        }
        other => exception("OrigamiError", &other.to_string(), details, |_| Ok(())),
    }
}

/// What the operating system says, without the number that it says it by.
fn reason(source: &std::io::Error) -> String {
    let text = source.to_string();
    text.split(" (os error").next().unwrap_or(&text).to_owned()
}

/// A place as attributes: as text, and what it consists of.
fn place(place: &Place) -> Map<String, Value> {
    let mut details = Map::new();
    details.insert("place".into(), place.to_string().into());
    if let Value::Object(parts) = at(place) {
        details.extend(parts);
    }
    details
}

/// An exception of `origami_sim.errors` by its name, with attributes; `more` adds those that are no JSON.
pub(crate) fn exception(
    class: &str,
    message: &str,
    details: Map<String, Value>,
    more: impl FnOnce(&Bound<'_, PyDict>) -> PyResult<()>,
) -> PyErr {
    Python::attach(|py| {
        let make = || {
            let class = py.import("origami_sim.errors")?.getattr(class)?;
            let keywords = PyDict::new(py);
            for (name, value) in details {
                keywords.set_item(name, pythonize::pythonize(py, &value)?)?;
            }
            more(&keywords)?;
            class.call((message,), Some(&keywords))
        };
        make().map_or_else(|error| error, PyErr::from_value)
    })
}
