//! A pass shared out among threads. Where it is cut changes no bit: every element is computed by itself, and sums are
//! taken in blocks that are never cut.

use super::isa::{Compute, Isa, Pass};
use crate::parallel;

/// A pass over a list that may be cut in two.
pub(super) trait Cut<R: Compute>: Pass<R, Output: Send> + Send + Sized {
    /// It is cut at multiples of this. So many elements are whole chunks in every lane.
    const GRAIN: usize = 16;

    /// How many elements it goes over.
    fn elements(&self) -> usize;
    /// The first `at` elements, and the rest.
    fn cut(self, at: usize) -> (Self, Self);
    /// Of both parts.
    fn both(one: Self::Output, other: Self::Output) -> Self::Output;
}

/// Runs `pass` in as many parts of one size.
pub(super) fn run<R: Compute, P: Cut<R>>(isa: Isa, pass: P, parts: usize) -> P::Output {
    let grains = pass.elements() / P::GRAIN;
    if parts < 2 || grains < 2 {
        return R::run(isa, pass);
    }
    let first = parts / 2;
    let (one, other) = pass.cut((grains * first / parts).max(1) * P::GRAIN);
    let (one, other) = parallel::join(|| run(isa, one, first), || run(isa, other, parts - first));
    P::both(one, other)
}
