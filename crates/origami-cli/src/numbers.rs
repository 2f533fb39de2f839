//! Numbers as a person reads them.

use std::time::Duration;

use origami::solve::Folded;

/// With two significant digits, such as `0.41`, `2.1`, `170`; tiny and huge ones as `3.1e-5`.
pub(crate) fn short(x: f64) -> String {
    let size = x.abs();
    match size {
        0.0 => "0".to_owned(),
        _ if !size.is_finite() => "unknown".to_owned(),
        _ if !(9.95e-4..1e6).contains(&size) => format!("{x:.1e}"),
        _ if size >= 9.95 => format!("{x:.0}"),
        _ if size >= 0.995 => format!("{x:.1}"),
        _ if size >= 0.0995 => format!("{x:.2}"),
        _ if size >= 0.00995 => format!("{x:.3}"),
        _ => format!("{x:.4}"),
    }
}

/// A share as a percentage, such as `0.41 %`.
pub(crate) fn share(x: f64) -> String {
    format!("{} %", short(100.0 * x))
}

/// With at most six significant digits, such as `90` or `33.3333`; tiny and huge ones as `1e300`.
pub(crate) fn plain(x: f64) -> String {
    // The nearest number that is six digits long is written with no more.
    let x = format!("{x:.5e}").parse().unwrap_or(x);
    if x == 0.0 || (1e-6..1e9).contains(&x.abs()) { x.to_string() } else { format!("{x:e}") }
}

/// Such as `90 %` and `33.33 %`: two decimals; of tiny and huge ones as many digits as [`plain`] has.
#[cfg(feature = "render")]
pub(crate) fn percent(x: f64) -> String {
    let rounded = (100.0 * x).round() / 100.0;
    format!("{} %", if (0.1..1e6).contains(&x.abs()) { rounded.to_string() } else { plain(x) })
}

/// In groups of three digits, such as `1 240`.
pub(crate) fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let mut text = String::with_capacity(digits.len() * 4 / 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// Such as `1 vertex` and `2 vertices`.
pub(crate) fn count(n: usize, one: &str, many: &str) -> String {
    format!("{} {}", grouped(n as u64), if n == 1 { one } else { many })
}

/// Such as `12 ms` or `3.4 s`.
pub(crate) fn duration(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    if seconds < 0.9995 { format!("{:.0} ms", 1e3 * seconds) } else { format!("{seconds:.1} s") }
}

/// Such as `128 MiB` and `2.0 GiB`.
pub(crate) fn bytes(n: u64) -> String {
    let power = n.max(1).ilog2() / 10;
    let unit = ["B", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"][power as usize];
    format!("{} {unit}", short(n as f64 / (1_u64 << (10 * power)) as f64))
}

/// The percentage that a state was folded to: the command line asks for nothing else.
pub(crate) fn percent_of(folded: &Folded) -> f64 {
    folded.percent().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_digits_are_left() {
        let cases = [
            (0.0, "0"),
            (3.14e-5, "3.1e-5"),
            (0.00123, "0.0012"),
            (0.0123, "0.012"),
            (0.4149, "0.41"),
            (0.997, "1.0"),
            (2.06, "2.1"),
            (-21.4, "-21"),
            (170.2, "170"),
            (2.5e7, "2.5e7"),
            (f64::INFINITY, "unknown"),
        ];
        for (x, text) in cases {
            assert_eq!(short(x), text);
        }
        assert_eq!(share(0.0041), "0.41 %");
    }

    #[test]
    fn plain_numbers_stay_short() {
        assert_eq!([0.0, -90.0, 33.25, 1e300, 2e-9].map(plain), ["0", "-90", "33.25", "1e300", "2e-9"]);
        let unrounded = [8.571428571428571, 5.999999919246756, 0.1 + 0.2, 123456.789, 1.0 / 3.0 * 1e-7, f64::NAN];
        assert_eq!(unrounded.map(plain), ["8.57143", "6", "0.3", "123457", "3.33333e-8", "NaN"]);
    }

    #[test]
    fn groups_and_times() {
        assert_eq!([0, 999, 1240, 1_234_567].map(grouped), ["0", "999", "1 240", "1 234 567"]);
        assert_eq!(count(1, "face", "faces"), "1 face");
        let sizes = [0, 1000, 16 << 10, (2 << 30) - 1, u64::MAX].map(bytes);
        assert_eq!(sizes, ["0 B", "1000 B", "16 KiB", "2.0 GiB", "16 EiB"]);
        assert_eq!(duration(Duration::from_micros(12_345)), "12 ms");
        assert_eq!(duration(Duration::from_millis(3_440)), "3.4 s");
    }

    #[cfg(feature = "render")]
    #[test]
    fn percentages_have_two_decimals() {
        let cases = [100.0, 8.571428571428571, 33.333333333333336, 66.66666666666667, -12.5, 0.0, 0.01234567, 1e300];
        let texts = ["100 %", "8.57 %", "33.33 %", "66.67 %", "-12.5 %", "0 %", "0.0123457 %", "1e300 %"];
        assert_eq!(cases.map(percent), texts);
    }
}
