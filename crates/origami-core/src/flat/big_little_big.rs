//! The big-little-big rule: the creases on both sides of a sector that is smaller than its neighbours have different letters,
//! or one of the larger sectors would have to go through the other.
//!
//! The same of several equal sectors in a row between larger ones: of the creases on their sides, mountains and valleys are
//! as many where the sectors are odd in number, and differ by one where they are even (T. C. Hull, Counting mountain-valley
//! assignments for flat folds, Ars Combinatoria 67, 2003, theorem 4).

use super::ANGLE_TOLERANCE;
use super::maekawa::{counts, differ_by};

/// Equal sectors in a row, smaller than the two around them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Run {
    /// The first of them.
    pub(super) first: usize,
    /// How many there are; one more crease bounds them.
    pub(super) sectors: usize,
}

impl Run {
    /// The creases on its sides; crease i lies before sector i.
    pub(super) fn creases(self, around: usize) -> impl Iterator<Item = usize> {
        (0..=self.sectors).map(move |i| (self.first + i) % around)
    }

    /// Whether creases with so many mountains and valleys can bound it.
    pub(super) fn allows(self, mountains_and_valleys: [usize; 2]) -> bool {
        differ_by(mountains_and_valleys, usize::from(self.sectors.is_multiple_of(2)))
    }
}

/// All such runs around a vertex. None where all sectors are equal.
pub(super) fn runs(sectors: &[f64]) -> Vec<Run> {
    let count = sectors.len();
    let equal = |i: usize| (sectors[(i + 1) % count] - sectors[i % count]).abs() < ANGLE_TOLERANCE;
    // Begun where one run ends, so that none is cut in two.
    let Some(start) = (0..count).find(|i| !equal(*i)) else { return Vec::new() };
    let (mut found, mut at) = (Vec::new(), start + 1);
    while at <= start + count {
        let mut end = at;
        while end < start + count && equal(end) {
            end += 1;
        }
        let smaller = |other: usize| sectors[other % count] - sectors[at % count] > ANGLE_TOLERANCE;
        let sectors_in_it = end + 1 - at;
        if smaller(at + count - 1) && smaller(end + 1) && sectors_in_it + 1 < count {
            found.push(Run { first: at % count, sectors: sectors_in_it });
        }
        at = end + 1;
    }
    found
}

/// Runs whose creases have letters that the rule forbids, with their mountains and valleys.
pub(super) fn broken<'a>(sectors: &[f64], valleys: &'a [bool]) -> impl Iterator<Item = (Run, [usize; 2])> + use<'a> {
    let with_counts = |run: Run| (run, counts(run.creases(valleys.len()).map(|crease| valleys[crease])));
    runs(sectors).into_iter().map(with_counts).filter(|(run, letters)| !run.allows(*letters))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(degrees: &[f64]) -> Vec<(usize, usize)> {
        let sectors: Vec<f64> = degrees.iter().map(|d| d.to_radians()).collect();
        let mut found: Vec<_> = runs(&sectors).into_iter().map(|run| (run.first, run.sectors)).collect();
        found.sort_unstable();
        found
    }

    #[test]
    fn runs_are_found_around_the_corner_too() {
        assert_eq!(found(&[60.0, 80.0, 120.0, 100.0]), [(0, 1)]);
        assert_eq!(found(&[90.0; 4]), [], "all are equal");
        assert_eq!(found(&[40.0, 40.0, 100.0, 80.0, 40.0, 60.0]), [(0, 2), (4, 1)]);
        assert_eq!(found(&[40.0, 100.0, 60.0, 80.0, 40.0, 40.0]), [(2, 1), (4, 3)]);
        assert_eq!(found(&[60.0, 120.0, 60.0, 120.0]), [(0, 1), (2, 1)]);
        assert_eq!(found(&[60.0, 60.0, 60.0, 180.0]), [], "three sectors beside one: bounded by it twice");
    }
}
