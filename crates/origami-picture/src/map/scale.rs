//! From values to shares of the colour map, and numbers beside its bar.

use super::ColourMap;

/// How values become colours, and what is said about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    /// The colours from the least to the largest value.
    pub colours: ColourMap,
    /// The value of the last colour; the first is that of 0.
    pub clip: f64,
    /// Over the bar: the quantity and its unit.
    pub label: String,
    /// Whether some values are above [`Scale::clip`]: the bar says so.
    pub beyond: bool,
}

impl Scale {
    /// The share of the colour map that a value stands for.
    #[must_use]
    pub fn share(&self, value: f32) -> f32 {
        let share = value / self.clip as f32;
        if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) }
    }

    /// Numbers to stand beside the bar, with their shares of it: 0, the clip value and round ones between.
    #[must_use]
    pub fn ticks(&self) -> Vec<(f64, String)> {
        if !(self.clip > 0.0 && self.clip.is_finite()) {
            return Vec::new();
        }
        let step = next_of(&[1.0, 2.0, 5.0, 10.0], self.clip / 5.0);
        let mut values: Vec<f64> = (0..8).map(|i| f64::from(i) * step).filter(|v| *v < self.clip * 0.999).collect();
        // A round number that would stand on the last one gives way.
        if values.len() > 1 && values.last().is_some_and(|last| self.clip - last < 0.5 * step) {
            values.pop();
        }
        let mut ticks: Vec<(f64, String)> = values.into_iter().map(|v| (v / self.clip, number(v, step))).collect();
        let last = number(self.clip, step.min(round_down_to_digit(self.clip)));
        ticks.push((1.0, if self.beyond { format!("≥ {last}") } else { last }));
        ticks
    }
}

/// The next of 1, 1.5, 2, 3, 4, 5, 6 and 8 times a power of ten: a bar that ends there is used over two thirds of its
/// colours at least. 1 where there is none.
#[must_use]
pub fn round_up(value: f64) -> f64 {
    next_of(&[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0], value)
}

/// The next of these digits times a power of ten; 1 where there is none.
fn next_of(digits: &[f64], value: f64) -> f64 {
    if !(value > 1e-300 && value < 1e300) {
        return 1.0;
    }
    let power = value.log10().floor() as i32;
    let enough = digits.iter().find(|digit| **digit * 10.0_f64.powi(power) >= value * (1.0 - 1e-9));
    // Written as text and read again, so that 0.2 is 0.2.
    enough.and_then(|digit| format!("{digit}e{power}").parse().ok()).unwrap_or(value)
}

/// The worth of the last digit that a number written with three has.
fn round_down_to_digit(value: f64) -> f64 {
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    let mut worth = 10.0_f64.powi(rounded.abs().log10().floor() as i32 - 2);
    while worth < rounded && ((rounded / (worth * 10.0)).round() * worth * 10.0 - rounded).abs() < 1e-9 * rounded {
        worth *= 10.0;
    }
    worth
}

/// With as many digits as steps of this size need.
fn number(value: f64, step: f64) -> String {
    let size = value.abs().max(step);
    if size >= 1e5 || step < 1e-4 {
        return if value == 0.0 { "0".into() } else { trim(&format!("{value:.2e}")) };
    }
    let digits = (-step.log10() - 1e-9).ceil().clamp(0.0, 8.0) as usize;
    format!("{value:.digits$}")
}

/// `2e-5` for `2.00e-5`.
fn trim(text: &str) -> String {
    match text.split_once('e') {
        Some((digits, power)) => format!("{}e{power}", digits.trim_end_matches('0').trim_end_matches('.')),
        None => text.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ticks(clip: f64, beyond: bool) -> Vec<String> {
        let scale = Scale { colours: ColourMap::Viridis, clip, label: String::new(), beyond };
        let ticks = scale.ticks();
        assert!(ticks.windows(2).all(|w| w[0].0 < w[1].0) && ticks.iter().all(|t| (0.0..=1.0).contains(&t.0)));
        ticks.into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn numbers_are_round_and_say_what_is_there() {
        assert_eq!(ticks(1.0, false), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(ticks(5.0, true), ["0", "1", "2", "3", "4", "≥ 5"]);
        assert_eq!(ticks(0.002, false), ["0.0000", "0.0005", "0.0010", "0.0015", "0.0020"]);
        assert_eq!(ticks(2e-6, false), ["0", "5e-7", "1e-6", "1.5e-6", "2e-6"]);
        assert_eq!(ticks(1.5, false), ["0.0", "0.5", "1.0", "1.5"]);
        assert_eq!(ticks(3.0, false), ["0", "1", "2", "3"]);
        assert_eq!(ticks(0.08, false), ["0.00", "0.02", "0.04", "0.06", "0.08"]);
        assert_eq!(ticks(1.3, false).last().unwrap(), "1.3");
        assert_eq!(ticks(f64::NAN, false), Vec::<String>::new());
    }

    #[test]
    fn rounding_goes_up_to_a_short_number_that_is_not_far() {
        for (value, rounded) in [(0.013, 0.015), (0.2, 0.2), (0.21, 0.3), (99.0, 100.0), (1.0, 1.0), (0.0, 1.0)] {
            assert_eq!(round_up(value), rounded);
        }
        for i in 1..2000 {
            let value = 0.003 * 1.007_f64.powi(i);
            let rounded = round_up(value);
            assert!(rounded >= value * (1.0 - 1e-9) && value > 0.66 * rounded, "{value} {rounded}");
        }
        assert_eq!(round_up(f64::NAN), 1.0);
    }
}
