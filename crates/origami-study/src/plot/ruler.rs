//! An axis: which values it spans, where its lines are and what is written there.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

use super::Scale;

/// Air beyond the outermost points, as a share of the span.
const AIR: f64 = 0.04;
/// Labels on one axis, at most.
const LABELS: i64 = 10;
/// A linear axis that would begin within this share of its end from 0 begins at 0.
const NEAR_ZERO: f64 = 0.3;
/// Values of which this share is all that they differ by are one.
const SAME: f64 = 1e-9;
/// Smaller ones cannot be told from 0 on a linear axis.
const TINY: f64 = 1e-300;

/// An axis in its own coordinate, the "position": the power of ten, or the value in [`unit`](Self::unit)s.
#[derive(Clone, Debug)]
pub(super) struct Ruler {
    scale: Scale,
    /// Power of ten that linear positions are multiples of: differences of huge values stay finite.
    power: i32,
    low: f64,
    high: f64,
    /// Positions of lines with labels.
    labelled: Vec<(f64, String)>,
    /// Positions of those without.
    light: Vec<f64>,
}

impl Ruler {
    /// For all of `values` that it can show.
    pub(super) fn new(scale: Scale, values: impl Iterator<Item = f64> + Clone) -> Self {
        let largest = values.clone().filter(|v| v.is_finite()).fold(0.0, |largest: f64, v| largest.max(v.abs()));
        let mut ruler = Self { scale, power: 0, low: 0.0, high: 1.0, labelled: Vec::new(), light: Vec::new() };
        if largest >= TINY {
            ruler.power = power_of(largest);
        }
        let positions = values.filter_map(|v| ruler.position(v));
        let (low, high) =
            positions.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
        // Without points an axis from 0 to 1, or from 1 to 10.
        let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
        match scale {
            Scale::Log => ruler.divide_by_powers(low, high),
            Scale::Linear => ruler.divide_evenly(low, high),
        }
        ruler
    }

    /// Where `value` is; none where it cannot be shown.
    pub(super) fn position(&self, value: f64) -> Option<f64> {
        match self.scale {
            _ if !self.scale.shows(value) => None,
            Scale::Log => Some(value.log10()),
            Scale::Linear if value.abs() < TINY => Some(0.0),
            // In two steps: neither power is out of range.
            Scale::Linear => Some(value / 10_f64.powi(self.power / 2) / 10_f64.powi(self.power - self.power / 2)),
        }
    }

    /// Characters of its longest label.
    pub(super) fn longest_label(&self) -> usize {
        self.labelled.iter().map(|(_, text)| text.chars().count()).max().unwrap_or(0)
    }

    fn divide_by_powers(&mut self, low: f64, high: f64) {
        // A decade at least.
        let air = (AIR * (high - low)).max(0.5 * (1.0 - (high - low)));
        (self.low, self.high) = (low - air, high + air);
        let (first, last) = (whole(self.low.ceil()), whole(self.high.floor()));
        let within = |p: &f64| (self.low..=self.high).contains(p);
        let multiples = |digits: &'static [u8]| {
            let decades = first - 1..=last;
            let of = move |power: i64| digits.iter().map(move |digit| (power, *digit));
            decades.flat_map(of).map(|(power, digit)| (power as f64 + f64::from(digit).log10(), power, digit))
        };
        // Labels at 1, 2 and 5 where there are few powers of ten.
        let digits: &[u8] = if last - first < 2 { &[1, 2, 5] } else { &[1] };
        let stride = stride(last - first);
        self.labelled = multiples(digits)
            .filter(|(p, power, _)| within(p) && power.rem_euclid(stride) == 0)
            .map(|(p, power, digit)| (p, power_label(power, digit)))
            .collect();
        let light: &[u8] = match last - first {
            ..5 => &[1, 2, 3, 4, 5, 6, 7, 8, 9],
            5..=40 => &[1],
            _ => &[],
        };
        self.light = multiples(light).map(|(p, ..)| p).filter(within).collect();
    }

    fn divide_evenly(&mut self, low: f64, high: f64) {
        let size = low.abs().max(high.abs());
        let (mut low, mut high) = (low, high);
        if high - low <= SAME * size || size == 0.0 {
            let half = if size == 0.0 { 1.0 } else { 0.5 * size };
            (low, high) = (low - half, high + half);
        }
        let air = AIR * (high - low);
        (self.low, self.high) = (low - air, high + air);
        if low >= 0.0 && low < NEAR_ZERO * high {
            self.low = 0.0;
        }
        let step = nice((self.high - self.low) / 7.0);
        let power = power_of(step);
        let lines = |step: f64| {
            (whole((self.low / step).ceil())..=whole((self.high / step).floor())).map(move |i| i as f64 * step)
        };
        self.labelled = lines(step).map(|p| (p, linear_label(p, power, self.power))).collect();
        self.light = lines(0.5 * step).collect();
    }
}

#[expect(clippy::cast_possible_truncation, reason = "rounded, and a few thousand at most")]
fn whole(x: f64) -> i64 {
    x as i64
}

/// Of the power of ten that is not above `x`, its exponent.
#[expect(clippy::cast_possible_truncation, reason = "from -308 to 308")]
fn power_of(x: f64) -> i32 {
    x.log10().floor() as i32
}

/// 1, 2 or 5 times a power of ten, and not below `x`.
fn nice(x: f64) -> f64 {
    let power = 10_f64.powi(power_of(x));
    [1.0, 2.0, 5.0].into_iter().map(|digit| digit * power).find(|step| *step >= x).unwrap_or(10.0 * power)
}

/// Every how many powers of ten one has a label.
fn stride(powers: i64) -> i64 {
    [1, 2, 3, 5, 10, 20, 50].into_iter().find(|stride| powers / stride < LABELS).unwrap_or(100)
}

/// `digit` times ten to the `power`.
fn power_label(power: i64, digit: u8) -> String {
    match power {
        0..=3 => format!("{digit}{}", "0".repeat(usize::try_from(power).unwrap_or(0))),
        -3..0 => format!("0.{}{digit}", "0".repeat(usize::try_from(-power - 1).unwrap_or(0))),
        _ => format!("{digit}e{power}"),
    }
}

/// `position` times ten to the `power`, with as many digits as lines ten to the `step` apart need.
fn linear_label(position: f64, step: i32, power: i32) -> String {
    let (shown, unit, suffix) = match power {
        -3..=4 => (position * 10_f64.powi(power), step + power, String::new()),
        _ => (position, step, format!("e{power}")),
    };
    let decimals = usize::try_from(-unit).unwrap_or(0);
    if position == 0.0 { "0".to_owned() } else { format!("{shown:.decimals$}{suffix}") }
}

impl Ranged for Ruler {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    #[expect(clippy::cast_possible_truncation, reason = "a pixel")]
    fn map(&self, position: &f64, (first, last): (i32, i32)) -> i32 {
        let share = ((position - self.low) / (self.high - self.low)).clamp(0.0, 1.0);
        first + (share * f64::from(last - first)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() {
            self.light.clone()
        } else {
            self.labelled.iter().map(|(p, _)| *p).collect()
        }
    }

    fn range(&self) -> Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Ruler {
    fn format_ext(&self, position: &f64) -> String {
        self.labelled.iter().find(|(p, _)| p == position).map_or_else(String::new, |(_, text)| text.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: Scale, values: &[f64]) -> Vec<String> {
        Ruler::new(scale, values.iter().copied()).labelled.into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn powers_of_ten_have_labels() {
        assert_eq!(labels(Scale::Log, &[1e-3, 1e2]), ["0.001", "0.01", "0.1", "1", "10", "100"]);
        assert_eq!(labels(Scale::Log, &[1e-9, 1e-5, 0.0, -3.0]), ["1e-9", "1e-8", "1e-7", "1e-6", "1e-5"]);
        assert_eq!(labels(Scale::Log, &[3.0, 8.0]), ["2", "5", "10"]);
        assert_eq!(labels(Scale::Log, &[1e-300, 1e300]).len(), 7);
    }

    #[test]
    fn round_numbers_have_labels() {
        assert_eq!(labels(Scale::Linear, &[-100.0, 100.0]), ["-100", "-50", "0", "50", "100"]);
        assert_eq!(
            labels(Scale::Linear, &[0.1, 0.9]),
            ["0.0", "0.2", "0.4", "0.6", "0.8"].map(|l| l.replace("0.0", "0"))
        );
        assert_eq!(labels(Scale::Linear, &[1e7, 4e7]), ["0", "1e7", "2e7", "3e7", "4e7"]);
    }

    #[test]
    fn any_values_give_a_few_labels_and_positions_within() {
        let values = [0.0, 1.0, -1.0, 5e-324, 1e-300, 1e300, f64::MAX, f64::MIN, 1.0 + 1e-12, f64::NAN, f64::INFINITY];
        let mut sets: Vec<Vec<f64>> = vec![Vec::new()];
        for a in values {
            sets.push(vec![a]);
            sets.extend(values.iter().map(|b| vec![a, *b]));
        }
        for set in sets {
            for scale in [Scale::Linear, Scale::Log] {
                let ruler = Ruler::new(scale, set.iter().copied());
                assert!(ruler.low < ruler.high && (ruler.high - ruler.low).is_finite(), "{set:?} {ruler:?}");
                assert!((2..=13).contains(&ruler.labelled.len()), "{set:?} {ruler:?}");
                assert!(ruler.light.len() < 70, "{set:?} {ruler:?}");
                for (i, (p, text)) in ruler.labelled.iter().enumerate() {
                    assert!((ruler.low..=ruler.high).contains(p) && text.len() < 12, "{set:?} {ruler:?}");
                    assert!(ruler.labelled[..i].iter().all(|(_, other)| other != text), "{set:?} {ruler:?}");
                }
                for p in set.iter().filter_map(|v| ruler.position(*v)) {
                    assert!((ruler.low..=ruler.high).contains(&p), "{set:?} {ruler:?}");
                }
            }
        }
    }
}
