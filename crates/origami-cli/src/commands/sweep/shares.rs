//! How far many sheets have come, told by many threads at once.

use std::ops::Range;
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};

/// Parts that the way of one sheet is divided into.
const PARTS: f64 = 1000.0;

/// The share of its way that each sheet has covered.
pub(super) struct Shares {
    first: usize,
    of: Vec<AtomicU32>,
    sum: AtomicU64,
}

impl Shares {
    /// For the sheets of these places.
    pub(super) fn new(places: Range<usize>) -> Self {
        Self { first: places.start, of: places.map(|_| AtomicU32::new(0)).collect(), sum: AtomicU64::new(0) }
    }

    /// Sheet `index` has come to `share`, 0 to 1, and does not go back; tells the sum of all.
    pub(super) fn advance(&self, index: usize, share: f64) -> f64 {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of 1000, saturating")]
        let now = (share * PARTS) as u32;
        let of = index.checked_sub(self.first).and_then(|i| self.of.get(i));
        let before = of.map_or(now, |of| of.fetch_max(now, Ordering::Relaxed));
        let more = u64::from(now.saturating_sub(before));
        (self.sum.fetch_add(more, Ordering::Relaxed) + more) as f64 / PARTS
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_sheet_goes_back_and_all_are_summed() {
        let shares = Shares::new(5..8);
        assert_eq!(shares.advance(5, 0.5), 0.5);
        assert_eq!(shares.advance(7, 1.0), 1.5);
        // A second attempt begins again.
        assert_eq!(shares.advance(7, 0.1), 1.5);
        assert_eq!(shares.advance(5, 1.0), 2.0);
        assert_eq!(shares.advance(8, 1.0), 2.0, "there is no such sheet");
    }
}
