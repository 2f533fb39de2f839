//! A pass cut into tasks for several threads. Where it is cut changes no bit: every element is computed by itself, and sums
//! are taken in blocks that are never cut.

use super::isa::{Compute, Isa, Pass};
use crate::parallel;

/// A pass over a list that may be cut in two.
pub(super) trait Cut<R: Compute>: Pass<R, Output: Send> + Send + Sized {
    /// A pass is cut at multiples of this, which are whole chunks in every lane.
    const GRAIN: usize = 16;

    /// How many elements the pass goes over.
    fn elements(&self) -> usize;
    /// The first `at` elements, and the rest.
    fn cut(self, at: usize) -> (Self, Self);
    /// Joins the results of both parts.
    fn both(one: Self::Output, other: Self::Output) -> Self::Output;
}

/// Runs `pass` as `tasks` tasks of about one size.
pub(super) fn run<R: Compute, P: Cut<R>>(isa: Isa, pass: P, tasks: usize) -> P::Output {
    let grains = pass.elements() / P::GRAIN;
    if tasks < 2 || grains < 2 {
        return R::run(isa, pass);
    }
    let first = tasks / 2;
    let (one, other) = pass.cut((grains * first / tasks).max(1) * P::GRAIN);
    let (one, other) = parallel::join(|| run(isa, one, first), || run(isa, other, tasks - first));
    P::both(one, other)
}
