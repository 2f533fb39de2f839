//! Many sheets of one pattern: other percentages, materials, starts.

use std::ops::ControlFlow;
use std::sync::OnceLock;

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

/// One instance a thread, as many at once as rayon's current pool has threads, begun in their order.
pub(super) fn over_threads<S: Solver + ?Sized>(
    solver: &S,
    instances: &[Instance<'_>],
    observe: &(dyn Fn(usize, Progress) -> ControlFlow<()> + Sync),
    take: &(dyn Fn(usize, Result<Folded, Failed>) -> ControlFlow<()> + Sync),
) {
    parallel::in_turn(instances, |i, instance| {
        let watch = &mut |progress| observe(i, progress);
        take(i, solver.fold(instance.model, &instance.start, &instance.scene, watch))
    });
}

/// Of results as they come a list in the order of their instances.
pub(super) fn collected<S: Solver + ?Sized>(
    solver: &S,
    instances: &[Instance<'_>],
    observe: &(dyn Fn(usize, Progress) -> ControlFlow<()> + Sync),
) -> Vec<Result<Folded, Failed>> {
    let results: Vec<OnceLock<Result<Folded, Failed>>> = instances.iter().map(|_| OnceLock::new()).collect();
    solver.fold_each(instances, observe, &|i, result| {
        let _ = results[i].set(result);
        ControlFlow::Continue(())
    });
    results.into_iter().filter_map(OnceLock::into_inner).collect()
}
