//! Many sheets of one pattern: other percentages, materials, starts.

use super::{Failed, Folded, Progress, Solver, State};
use crate::model::Model;
use crate::parallel;

/// One sheet of an ensemble.
#[derive(Clone, Debug)]
pub struct Instance<'m> {
    /// Its model; those of one ensemble come from one pattern, with materials of their own.
    pub model: &'m Model,
    /// Where it begins: at rest, perturbed or on the way.
    pub start: State,
    /// Percentage of the pattern's fold angles.
    pub percent: f64,
}

/// One instance a thread, as many at once as rayon's current pool has threads.
pub(super) fn over_threads<S: Solver + ?Sized>(
    solver: &S,
    instances: &[Instance<'_>],
    observe: &(dyn Fn(usize, Progress) + Sync),
) -> Vec<Result<Folded, Failed>> {
    let fold = |i: usize, instance: &Instance<'_>| {
        solver.fold(instance.model, &instance.start, instance.percent, &mut |progress| observe(i, progress))
    };
    parallel::map(instances, fold)
}
