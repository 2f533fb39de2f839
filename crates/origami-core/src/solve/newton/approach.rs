//! Newton's method for a sheet on which a relaxation crawls.

use std::ops::ControlFlow;

use super::descent::Descent;
use crate::model::Model;
use crate::scene::{Needs, Scene};
use crate::solve::State;
use crate::twins::settle_decide::STILL;

/// What came of it.
pub(in crate::solve) struct Approach {
    pub(in crate::solve) state: State,
    /// Whether it was broken off by who watched it.
    pub(in crate::solve) cancelled: bool,
    pub(in crate::solve) factorisations: u32,
    pub(in crate::solve) evaluations: u64,
}

/// Downhill from `state` until a step is next to nothing for the tolerance, in radii, or so many factorisations or evaluations
/// have been made; `None` where a force of the scene's own has no energy or Hessian, or the factors do not fit into memory.
pub(in crate::solve) fn approach(
    (model, scene): (&Model, &Scene),
    state: &State,
    (tolerance, most_factorisations, most_evaluations): (f64, u32, u64),
    observe: &mut dyn FnMut(u64) -> ControlFlow<()>,
) -> Option<Approach> {
    scene.check_forces(model, &[Needs::Energy, Needs::Hessian], "newton", "`Relax` does without").ok()?;
    let mut descent = Descent::new(model, scene)?;
    descent.begin(most_evaluations);
    let (mut state, mut cancelled) = (state.clone(), false);
    descent.descend(&mut state, 0.0, most_factorisations, &mut |evaluations, moved| {
        cancelled = observe(evaluations).is_break();
        if cancelled || moved < STILL * tolerance { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let Descent { factorisations, evaluations, .. } = descent;
    Some(Approach { state, cancelled, factorisations, evaluations })
}
