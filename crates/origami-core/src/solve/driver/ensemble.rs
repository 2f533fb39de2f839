//! Many sheets of one pattern: other percentages, materials, starts.

use std::ops::ControlFlow;

use super::{Folded, Progress, Solver};
use crate::model::Model;
use crate::parallel;
use crate::scene::Scene;
use crate::solve::{Failed, State};

/// One sheet of an ensemble.
#[derive(Clone, Debug)]
pub struct Instance<'m> {
    /// Its model; those of one ensemble come from one pattern, with materials of their own.
    pub model: &'m Model,
    /// Where it begins: at rest, perturbed or on the way.
    pub start: State,
    /// What is asked of it and done to it.
    pub scene: Scene,
}

/// One instance a thread, as many at once as rayon's current pool has threads.
pub(super) fn over_threads<S: Solver + ?Sized>(
    solver: &S,
    instances: &[Instance<'_>],
    observe: &(dyn Fn(usize, Progress) -> ControlFlow<()> + Sync),
) -> Vec<Result<Folded, Failed>> {
    let fold = |i: usize, instance: &Instance<'_>| {
        solver.fold(instance.model, &instance.start, &instance.scene, &mut |progress| observe(i, progress))
    };
    parallel::map(instances, fold)
}
