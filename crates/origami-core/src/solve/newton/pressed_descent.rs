//! Downhill under contact, where other layers begin to press on the way.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::descent::{Descent, End, Measured};
use super::pressed::Pressed;
use crate::model::Model;
use crate::scene::Scene;
use crate::solve::State;

/// The residual from which on the exact Hessian is taken: farther away what curves downwards is left out.
const NEAR: f64 = 1e-3;

/// Until when it goes down.
pub(super) struct Until {
    /// The largest force on a node, in the model's unit of force.
    pub(super) residual: f64,
    /// A step of the exact Hessian that moves no node farther, in radii, is the last one.
    pub(super) still: f64,
    pub(super) factorisations: u32,
    pub(super) evaluations: u64,
}

/// Where it came to.
pub(super) struct Came<'m> {
    pub(super) descent: Descent<'m>,
    pub(super) end: End,
    pub(super) measured: Measured,
    /// Whether it was broken off by who watched it.
    pub(super) cancelled: bool,
}

/// Downhill from `state`, at which the layers of `pressed` were measured. `observe` is told evaluations, and how far each step
/// went. `None` where the factors do not fit into memory.
pub(super) fn descend<'m>(
    (model, scene): (&'m Model, &Scene),
    (state, pressed): (&mut State, &Arc<Pressed>),
    until: &Until,
    observe: &mut dyn FnMut(u64, f64) -> ControlFlow<()>,
) -> Option<Came<'m>> {
    let mut projected = true;
    let (mut factorisations, mut evaluations) = (0, 0);
    loop {
        pressed.grow(&state.positions, projected);
        let mut descent = Descent::under_contact(model, scene, pressed.clone())?;
        descent.begin(until.evaluations);
        (descent.factorisations, descent.evaluations) = (factorisations, evaluations);
        let goal = if projected { NEAR.max(until.residual) } else { until.residual };
        let (mut cancelled, mut still) = (false, false);
        let mut watch = |evaluations, moved| {
            cancelled = observe(evaluations, moved).is_break();
            still = !projected && moved < until.still;
            if cancelled || still || pressed.outgrown() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let (end, measured) = descent.descend(state, goal, until.factorisations, &mut watch);
        (factorisations, evaluations) = (descent.factorisations, descent.evaluations);
        match end {
            // Other layers press.
            End::Cancelled if !(cancelled || still) => {}
            End::Settled | End::Stuck if projected => projected = false,
            _ => return Some(Came { descent, end, measured, cancelled }),
        }
    }
}
