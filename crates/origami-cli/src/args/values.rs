//! Numbers with a range, and what is said of those outside it.

use std::num::NonZeroUsize;
use std::ops::RangeInclusive;

use origami::solve::TimeStep;

use super::look::check_size;

/// Any finite number.
pub(super) fn finite(text: &str) -> Result<f64, String> {
    number(text, |_| true, "a finite number")
}

/// Above 0.
pub(super) fn positive(text: &str) -> Result<f64, String> {
    number(text, |x| x > 0.0, "a finite number greater than 0")
}

/// 0 or above.
pub(super) fn at_least_zero(text: &str) -> Result<f64, String> {
    number(text, |x| x >= 0.0, "a finite number of at least 0")
}

/// From 0 to 1.
pub(super) fn share(text: &str) -> Result<f64, String> {
    number(text, |x| (0.0..=1.0).contains(&x), "a number from 0 to 1")
}

/// Times the theme's: thinner lines are not seen, wider ones hide the sheet and take minutes.
pub(super) fn line_width(text: &str) -> Result<f64, String> {
    number(text, |x| (0.05..=50.0).contains(&x), "a number from 0.05 to 50")
}

/// A whole number in this range; no end is told where it is [`u64::MAX`].
pub(super) fn whole<T: TryFrom<u64>>(range: RangeInclusive<u64>) -> impl Fn(&str) -> Result<T, String> + Clone {
    move |text| {
        let number = text.trim().parse::<u64>().ok().filter(|n| range.contains(n)).and_then(|n| T::try_from(n).ok());
        number.ok_or_else(|| match (range.start(), range.end()) {
            (least, &u64::MAX) => format!("expected a whole number of at least {least}"),
            (least, most) => format!("expected a whole number from {least} to {most}"),
        })
    }
}

/// A place in a list, from 0.
pub(super) fn index(text: &str) -> Result<usize, String> {
    whole(0..=u64::MAX)(text)
}

/// A number of steps.
pub(super) fn steps(text: &str) -> Result<u64, String> {
    whole(0..=u64::MAX)(text)
}

/// At least one.
pub(super) fn threads(text: &str) -> Result<NonZeroUsize, String> {
    // More than can be counted are too many in any case.
    whole(1..=u64::MAX)(text)
        .map(|n: u64| NonZeroUsize::new(n.try_into().unwrap_or(usize::MAX)).unwrap_or(NonZeroUsize::MIN))
}

/// `paper`, `safe` or a number.
pub(super) fn time_step(text: &str) -> Result<TimeStep, String> {
    match text {
        "paper" => Ok(TimeStep::Paper),
        "safe" => Ok(TimeStep::Safe),
        _ => number(text, |x| x > 0.0, "`paper`, `safe` or a finite number greater than 0").map(TimeStep::Fixed),
    }
}

/// `WxH`: pixels across and down.
pub(super) fn size(text: &str) -> Result<[u32; 2], String> {
    let expected = || "expected pixels across and down, such as 1000x800".to_owned();
    let (width, height) = text.split_once(['x', 'X']).ok_or_else(expected)?;
    let pixels = |text: &str| text.trim().parse().ok().filter(|n: &u32| *n > 0).ok_or_else(expected);
    let size = [pixels(width)?, pixels(height)?];
    check_size(size)?;
    Ok(size)
}

/// `KEY=VALUE`.
pub(super) fn key_value(text: &str) -> Result<(String, f64), String> {
    match text.split_once('=') {
        Some((key, value)) if !key.trim().is_empty() => {
            let value = number(value, |_| true, "a finite number after the `=`")?;
            Ok((key.trim().to_owned(), value))
        }
        _ => Err("expected KEY=VALUE, such as columns=6".to_owned()),
    }
}

fn number(text: &str, holds: impl Fn(f64) -> bool, expected: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        // Adding 0 makes -0 and 0 the same number.
        Ok(x) if x.is_finite() && holds(x) => Ok(x + 0.0),
        _ => Err(format!("expected {expected}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_in_range_is_refused() {
        for text in ["", "x", "nan", "inf", "1e999", "1,5"] {
            for parse in [finite, positive, at_least_zero] {
                assert!(parse(text).is_err(), "{text}");
            }
            assert!(time_step(text).is_err() && key_value(&format!("a={text}")).is_err(), "{text}");
        }
        for text in ["", "640", "x", "640x", "0x480", "-1x1", "1e3x1", "640x480x2"] {
            assert!(size(text).is_err(), "{text}");
        }
        assert!(share("-0.1").is_err() && share("1.1").is_err() && share("nan").is_err());
        assert!(positive("0").is_err() && at_least_zero("-0.1").is_err() && time_step("-1").is_err());
        for text in ["", "-1", "1.5", "1e3", "10", "18446744073709551616"] {
            assert_eq!(whole::<u32>(1..=9)(text), Err("expected a whole number from 1 to 9".to_owned()), "{text}");
        }
        assert_eq!(threads("0"), Err("expected a whole number of at least 1".to_owned()));
        for text in ["0", "0.049", "50.1", "1e300", "-1"] {
            assert!(line_width(text).is_err(), "{text}");
        }
        assert!(key_value("columns").is_err() && key_value("=3").is_err());
    }

    #[test]
    fn numbers_in_range_are_read() {
        assert_eq!(finite("-90"), Ok(-90.0));
        assert_eq!(finite("-0").map(f64::to_bits), Ok(0));
        assert_eq!(whole::<u32>(1..=9)("9"), Ok(9));
        assert_eq!(threads("18446744073709551615").map(usize::from), Ok(usize::MAX));
        assert_eq!(positive("1e-4"), Ok(1e-4));
        assert_eq!(at_least_zero("0"), Ok(0.0));
        assert_eq!(time_step("0.01"), Ok(TimeStep::Fixed(0.01)));
        assert_eq!(time_step("safe"), Ok(TimeStep::Safe));
        assert_eq!(size("640x480"), Ok([640, 480]));
        assert_eq!(key_value("angle = 60"), Ok(("angle".to_owned(), 60.0)));
    }
}
