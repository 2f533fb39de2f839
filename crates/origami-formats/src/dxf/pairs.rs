//! Pairs of lines: a group code, which says what the next line is, and that line.

use origami_core::error::{Error, ErrorCode, Place};

use crate::{number, text};

/// A group code and its value, with the line of the value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair<'t> {
    pub(super) code: i32,
    pub(super) value: &'t str,
    pub(super) line: usize,
}

impl Pair<'_> {
    pub(super) fn number(&self) -> Result<f64, Error> {
        number::finite(self.value, || self.place(), &format!("group {}", self.code))
    }

    /// A whole number; one that is written with decimals is cut off.
    pub(super) fn integer(&self) -> Result<i64, Error> {
        self.number().map(|number| number as i64)
    }

    pub(super) fn place(&self) -> Place {
        Place::Line { line: self.line, column: None }
    }
}

/// The pairs of a file, up to its end or what says so.
pub(super) fn pairs(text: &str) -> Result<Vec<Pair<'_>>, Error> {
    let mut lines = text::numbered_lines(text);
    let mut pairs = Vec::new();
    while let Some((line, code)) = lines.next() {
        let code = code.trim();
        let Some((value_line, value)) = lines.next() else {
            if code.is_empty() {
                break;
            }
            let (place, expected) = (Place::Line { line, column: None }, "a line with its value");
            return Err(Error::new(
                ErrorCode::MissingKey,
                place,
                format!("group code {} is the last", text::quoted(code)),
                expected,
            ));
        };
        let code = code.parse().map_err(|_| {
            let problem = format!("{} is no group code", text::quoted(code));
            Error::new(
                ErrorCode::WrongType,
                Place::Line { line, column: None },
                problem,
                "a whole number on every other line",
            )
        })?;
        let value = value.trim();
        if code == 0 && value == "EOF" {
            break;
        }
        pairs.push(Pair { code, value, line: value_line });
    }
    Ok(pairs)
}
