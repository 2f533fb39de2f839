//! Lists that elements look up by index, without a branch at each: a processor that has to look at bounds between loads
//! spends more on that than on forces.

/// Fills `list` up to a power of two.
pub(super) fn fill<T: Copy + Default>(list: &mut Vec<T>) {
    list.resize(list.len().next_power_of_two(), T::default());
}

/// The item at `i` of a list that was filled up. Beyond its end the list begins anew, so that there is nothing to check.
#[inline(always)]
pub(super) fn item<T: Copy>(list: &[T], i: u32) -> T {
    debug_assert!(list.len().is_power_of_two() && (i as usize) < list.len(), "{i} of {}", list.len());
    list[i as usize & (list.len() - 1)]
}
