//! Lists of numbers: `0.1,0.7,7`, `0:100:5`, or both mixed.

use std::fmt;

/// Values in a list that are still sensible; a sweep of more would not end.
const MOST: usize = 1_000_000;

/// The numbers of a list, in the order in which they are written.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct List(pub(crate) Vec<f64>);

impl List {
    /// Of one number.
    pub(super) fn of(x: f64) -> Self {
        Self(vec![x])
    }

    /// Numbers and ranges separated by commas; `number` reads each number and holds it to its bounds.
    pub(super) fn parse(text: &str, number: fn(&str) -> Result<f64, String>) -> Result<Self, String> {
        let mut values = Vec::new();
        for item in text.split(',') {
            let parts: Vec<&str> = item.split(':').collect();
            match parts[..] {
                [one] => values.push(number(one).map_err(|expected| format!("`{one}`: {expected}"))?),
                [from, to, step] => values.extend(range(item, [from, to], step, number)?),
                _ => return Err(format!("`{item}`: expected a number or a range FROM:TO:STEP, such as 0:100:5")),
            }
            if values.len() > MOST {
                return Err(format!("more than {MOST} values; expected fewer"));
            }
        }
        Ok(Self(values))
    }
}

impl fmt::Display for List {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let values: Vec<String> = self.0.iter().map(f64::to_string).collect();
        f.write_str(&values.join(","))
    }
}

/// All values of `FROM:TO:STEP`, its end included if a step leads there but for rounding. Its ends are held to the
/// bounds of the numbers, and so is all that lies between them.
fn range(
    item: &str,
    ends: [&str; 2],
    step: &str,
    number: fn(&str) -> Result<f64, String>,
) -> Result<impl Iterator<Item = f64>, String> {
    let said = |expected| format!("`{item}`: {expected}");
    let [from, to] = ends.map(|end| number(end).map_err(said));
    let (from, to, step) = (from?, to?, super::values::finite(step).map_err(said)?);
    if step == 0.0 {
        return Err(said("the step is 0; expected another".to_owned()));
    }
    if from != to && (to > from) != (step > 0.0) {
        let sign = if to > from { "positive" } else { "negative" };
        return Err(said(format!("the step leads away from {to}; expected a {sign} one")));
    }
    // A step that ends a billionth of itself before the end ends there.
    let steps = ((to - from) / step + 1e-9).floor();
    // Also where that is infinite.
    if steps >= MOST as f64 {
        return Err(said(format!("more than {MOST} values; expected a longer step")));
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to a million")]
    let steps = steps as u32;
    // 3 steps of 0.1 are 0.3, not 0.30000000000000004: what is written is that many decimals long.
    let decimals = decimals(from).max(decimals(step));
    let value = move |i: u32| {
        let x = from + f64::from(i) * step;
        let x: f64 = format!("{x:.decimals$}").parse().unwrap_or(x);
        // Within the ends, which were held to the bounds; adding 0 makes -0 and 0 the same number.
        x.clamp(from.min(to), from.max(to)) + 0.0
    };
    Ok((0..=steps).map(value))
}

/// Digits after the point.
fn decimals(x: f64) -> usize {
    x.to_string().split_once('.').map_or(0, |(_, digits)| digits.len())
}

#[cfg(test)]
mod tests {
    use super::super::values::{finite, positive};
    use super::*;

    fn values(text: &str) -> Vec<f64> {
        List::parse(text, finite).expect(text).0
    }

    #[test]
    fn numbers_ranges_and_both() {
        assert_eq!(values("7"), [7.0]);
        assert_eq!(values("0.1, 0.7,7"), [0.1, 0.7, 7.0]);
        assert_eq!(values("0:100:25"), [0.0, 25.0, 50.0, 75.0, 100.0]);
        assert_eq!(values("100:-100:-50"), [100.0, 50.0, 0.0, -50.0, -100.0]);
        assert_eq!(values("-1,0:2:1,5,4:3:-1"), [-1.0, 0.0, 1.0, 2.0, 5.0, 4.0, 3.0]);
        assert_eq!(values("3:3:1"), [3.0]);
        assert_eq!(values("3:3:-1"), [3.0]);
        assert_eq!(values("1e-4:3e-4:1e-4"), [1e-4, 2e-4, 3e-4]);
    }

    #[test]
    fn the_end_is_reached_within_rounding_and_not_passed() {
        assert_eq!(values("0:0.3:0.1"), [0.0, 0.1, 0.2, 0.3]);
        assert_eq!(values("0:1:0.1"), [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0]);
        assert_eq!(values("1:0:-0.25"), [1.0, 0.75, 0.5, 0.25, 0.0]);
        assert_eq!(values("0:10:4"), [0.0, 4.0, 8.0]);
        assert_eq!(values("0:1:2"), [0.0]);
        assert_eq!(values("0.3:0:-0.1")[3].to_bits(), 0, "not -0");
        let fine = values("0:1:0.001");
        assert_eq!((fine.len(), fine[7], fine[1000]), (1001, 0.007, 1.0));
    }

    #[test]
    fn what_makes_no_list_is_refused() {
        let refused = |text: &str| List::parse(text, finite).expect_err(text);
        for (text, why) in [
            ("", "``: expected a finite number"),
            ("1,,2", "``: expected a finite number"),
            ("1,x", "`x`: expected a finite number"),
            ("0:10", "`0:10`: expected a number or a range FROM:TO:STEP, such as 0:100:5"),
            ("0:1:2:3", "`0:1:2:3`: expected a number or a range"),
            ("0:nan:1", "`0:nan:1`: expected a finite number"),
            ("1,0:10:0", "`0:10:0`: the step is 0; expected another"),
            ("0:10:-1", "`0:10:-1`: the step leads away from 10; expected a positive one"),
            ("10:0:1", "`10:0:1`: the step leads away from 0; expected a negative one"),
            ("0:1:1e-9", "`0:1:1e-9`: more than 1000000 values; expected a longer step"),
            ("-1e308:1e308:1", "more than 1000000 values"),
            ("1:600000:1,1:600000:1", "more than 1000000 values; expected fewer"),
        ] {
            assert!(refused(text).contains(why), "{text}: {}", refused(text));
        }
        assert_eq!(
            List::parse("1:0:-1", positive),
            Err("`1:0:-1`: expected a finite number greater than 0".to_owned())
        );
        assert!(List::parse("-1:1:1", positive).is_err());
    }

    #[test]
    fn lists_are_shown_as_they_are_written() {
        assert_eq!(List(vec![0.1, 7.0]).to_string(), "0.1,7");
    }
}
