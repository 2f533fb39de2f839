//! Maekawa's rule: at a vertex that folds flat, mountains and valleys differ by two. The cross-section of the folded paper
//! turns by half a turn at each crease, and by one turn in all.

/// How many are mountains and how many valleys.
pub(super) fn counts(valleys: impl IntoIterator<Item = bool>) -> [usize; 2] {
    valleys.into_iter().fold([0, 0], |[m, v], valley| if valley { [m, v + 1] } else { [m + 1, v] })
}

/// Whether the two differ by `by`.
pub(super) fn differ_by([mountains, valleys]: [usize; 2], by: usize) -> bool {
    mountains.abs_diff(valleys) == by
}
