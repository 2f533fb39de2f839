//! Mean, root mean square and maximum of a list of numbers.

/// Mean, root mean square and maximum of absolute values; all 0 for an empty list.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Summary {
    /// Mean of the absolute values.
    pub mean: f64,
    /// Root of the mean square.
    pub rms: f64,
    /// Largest absolute value.
    pub max: f64,
}

impl Summary {
    /// The summary of the absolute values of `values`.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Self {
        let (mut count, mut sum, mut squares, mut max) = (0_u64, 0.0, 0.0, 0.0_f64);
        for value in values {
            count += 1;
            sum += value.abs();
            squares += value * value;
            max = max.max(value.abs());
        }
        if count == 0 {
            return Self::default();
        }
        Self { mean: sum / count as f64, rms: (squares / count as f64).sqrt(), max }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_three_and_of_none() {
        let summary = Summary::of([3.0, -4.0, 0.0]);
        assert_eq!((summary.mean, summary.max), (7.0 / 3.0, 4.0));
        assert!((summary.rms - (25.0_f64 / 3.0).sqrt()).abs() < 1e-15);
        assert_eq!(Summary::of([]), Summary::default());
    }
}
