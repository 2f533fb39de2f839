//! Numbers as programs write them.

use origami_core::error::{Error, ErrorCode, Place};

use crate::text::quoted;

/// The greatest size of a pattern that can be computed with; arcs and splines stay finite up to there.
const MOST: f64 = 1e100;

/// The finite number that `word` is. A decimal comma is taken for a point; whoever splits at commas leaves none.
///
/// # Errors
/// At `place`: what `word` is in place of a number, with `what` it stands for.
pub(crate) fn finite(word: &str, place: impl FnOnce() -> Place, what: &str) -> Result<f64, Error> {
    let refuse = |code, problem: &str, expected: String| {
        Err(Error::new(code, place(), format!("{} {problem}", quoted(word)), expected))
    };
    match parse(word) {
        Some(number) if number.abs() <= MOST => Ok(number),
        Some(_) if word.bytes().any(|byte| byte.is_ascii_digit()) => {
            refuse(ErrorCode::NumberTooLarge, "is too large", format!("at most {MOST:e} for {what}"))
        }
        Some(_) => refuse(ErrorCode::NotFinite, "is not finite", format!("a number for {what}")),
        None => refuse(ErrorCode::WrongType, "is no number", format!("a number for {what}")),
    }
}

/// Whether `word` is written as a number, be it finite or not.
pub(crate) fn is_number(word: &str) -> bool {
    parse(word).is_some()
}

fn parse(word: &str) -> Option<f64> {
    let point = || word.replacen(',', ".", 1);
    word.parse().ok().or_else(|| if word.contains('.') { None } else { point().parse().ok() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_what_is_finite() {
        let place = || Place::Line { line: 7, column: None };
        for (word, number) in [("1", 1.0), ("-2.5E-3", -0.0025), ("+.5", 0.5), ("1,25", 1.25), ("5.", 5.0)] {
            assert_eq!(finite(word, place, "x1").expect(word), number);
        }
        for (word, code) in [
            ("NaN", ErrorCode::NotFinite),
            ("-Infinity", ErrorCode::NotFinite),
            ("1e999", ErrorCode::NumberTooLarge),
            ("-1e101", ErrorCode::NumberTooLarge),
            ("l", ErrorCode::WrongType),
            ("", ErrorCode::WrongType),
            ("1,2,3", ErrorCode::WrongType),
            ("0x10", ErrorCode::WrongType),
        ] {
            let error = finite(word, place, "x1").expect_err(word);
            assert_eq!(error.code(), code, "{word}");
            assert!(error.to_string().starts_with("line 7: "), "{error}");
        }
    }
}
