//! Newton's method for a sheet on which a relaxation crawls.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DVec3;

use super::descent::Descent;
use super::pressed::Pressed;
use super::pressed_descent::{Came, Until, descend};
use crate::contact::Layers;
use crate::model::Model;
use crate::scene::{Needs, Scene, Targets};
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

/// The same under contact, from a state at which `layers` were measured. Nothing goes through anything on the way; `observe` is
/// shown the positions after each step.
pub(in crate::solve) fn approach_touching(
    (model, scene): (&Model, &Scene),
    (state, layers): (State, Layers),
    (tolerance, factorisations, evaluations): (f64, u32, u64),
    observe: &mut dyn FnMut(u64, &[DVec3]) -> ControlFlow<()>,
) -> Option<Approach> {
    let pressed = Arc::new(Pressed::new(layers, &state.positions));
    let scene = scene.clone().with_targets(Targets::at_rest());
    let until = Until { residual: 0.0, still: STILL * tolerance, factorisations, evaluations };
    let mut state = state;
    let mut watch = |evaluations, _| observe(evaluations, &pressed.positions());
    let came = descend((model, &scene), (&mut state, &pressed), &until, &mut watch)?;
    let Came { descent: Descent { factorisations, evaluations, .. }, cancelled, .. } = came;
    Some(Approach { state, cancelled, factorisations, evaluations })
}
