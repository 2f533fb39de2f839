//! Lists that elements look up by index, without a branch at each: a processor that has to look at bounds between loads
//! spends more on that than on forces.

use super::blocks::{CREASES, FORCES, NODES};
use super::real::Real;

/// What belongs to a node of a block: there is room for as many as the index can name.
#[inline(always)]
pub(super) fn node<T: Copy>(list: &[T; NODES], i: u8) -> T {
    list[usize::from(i)]
}

/// The moment of a crease of a block. Beyond the end the list begins anew, so that there is nothing to check.
#[inline(always)]
pub(super) fn moment<T: Copy>(list: &[T; CREASES], i: u16) -> T {
    debug_assert!(usize::from(i) < CREASES, "{i} of {CREASES}");
    list[usize::from(i) % CREASES]
}

/// Four of them. Their places are taken out of one word: of four that it reads, the compiler makes a vector, out of which it
/// then has to take each.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) fn four_moments<T: Copy>(list: &[T; CREASES], at: &[u16; 4]) -> [T; 4] {
    let word: u64 = bytemuck::cast(*at);
    let own = |bits: u32| list[(word >> bits) as usize % CREASES];
    [own(0), own(16), own(32), own(48)]
}

/// The force at one place of a block's, given by where its first number lies.
#[inline(always)]
pub(super) fn force<R: Real>(list: &[R::Quad; FORCES], i: u16) -> R::Quad {
    let numbers: &[R] = bytemuck::cast_slice(list);
    let i = usize::from(i) & (4 * FORCES - 4);
    R::quad([numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3]])
}
