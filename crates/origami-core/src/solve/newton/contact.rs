//! Newton's method for a sheet whose layers press on each other.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DVec3;

use super::descent::{Descent, End};
use super::pressed::Pressed;
use super::{Equilibrium, Newton, OutOfMemory};
use crate::contact::Layers;
use crate::model::{Inventory, Model};
use crate::scene::{Scene, Targets};
use crate::solve::contact_begin::{check_contact, first_layers};
use crate::solve::contact_end::touched;
use crate::solve::{ContactRelax, Failed, Folded, Progress, Solver, State, Stop, Touch, Touching};

/// The residual from which on the exact Hessian is taken: farther away what curves downwards is left out.
const NEAR: f64 = 1e-3;

/// [`ContactRelax`], and from where it ends Newton's method with the exact Hessian of springs and contact, to a residual at which
/// nothing is left to converge.
///
/// Steps are shortened as those of the relaxation are, all nodes alike, so that nothing goes through anything. A sheet that
/// is blocked stays so: what is found is the equilibrium in which it is stuck.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct ContactNewton {
    /// What goes ahead, and how paper keeps away from paper.
    pub relax: ContactRelax,
    /// As [`Newton::residual`]. Default 1e-10.
    pub residual: f64,
    /// Factorisations after which it gives up. Default 2000.
    pub max_factorisations: u32,
}

impl Default for ContactNewton {
    fn default() -> Self {
        let Newton { residual, max_factorisations, .. } = Newton::default();
        Self { relax: ContactRelax::default(), residual, max_factorisations }
    }
}

impl Solver for ContactNewton {
    fn fold(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        self.fold_touching(model, start, scene, observe).map(|(folded, _)| folded)
    }

    fn inventory(&self, model: &Model) -> Inventory {
        self.relax.inventory(model)
    }
}

/// A sheet that the relaxation does not bring to rest is not gone on with.
impl Touching for ContactNewton {
    fn fold_touching(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Touch), Failed> {
        let (near, touch) = self.relax.fold_touching(model, start, scene, observe)?;
        if !matches!(near.stop, Stop::Converged | Stop::Blocked) {
            return Ok((near, touch));
        }
        let mut watch =
            |evaluations, distance| observe(Progress { step: near.steps + evaluations, ramp: 1.0, distance });
        let (reached, touch) = self.settle((model, scene), &near.state, touch, &mut watch)?;
        let stop = match (reached.cancelled, reached.converged) {
            (true, _) => Stop::Cancelled,
            (false, false) if near.stop == Stop::Converged => Stop::StepLimit,
            _ => near.stop,
        };
        let folded = Folded {
            state: reached.state,
            stop,
            steps: near.steps + reached.evaluations,
            time_step: 1.0,
            residual: reached.residual,
            distance: reached.distance,
            factorisations: reached.factorisations,
            reactions: reached.reactions,
            ..near
        };
        Ok((folded, touch))
    }
}

impl ContactNewton {
    /// The equilibrium at the target angles of `start`, downhill from there, under the supports and loads of `scene`.
    ///
    /// # Errors
    /// [`Failed::Refused`] where the sheet begins crossed or closed, or the scene has forces of its own; [`Failed::Backend`] where
    /// the factors do not fit into memory.
    pub fn refine(&self, model: &Model, start: &State, scene: &Scene) -> Result<(Equilibrium, Touch), Failed> {
        self.settle((model, scene), start, Touch::default(), &mut |_, _| ControlFlow::Continue(()))
    }

    fn settle(
        &self,
        (model, scene): (&Model, &Scene),
        start: &State,
        touch: Touch,
        observe: &mut dyn FnMut(u64, f64) -> ControlFlow<()>,
    ) -> Result<(Equilibrium, Touch), Failed> {
        let refused = |refusal| Failed::refused(refusal, start);
        check_contact(self.relax.contact, self.relax.relax.precision, scene).map_err(refused)?;
        let layers: Layers = first_layers(model, &start.positions, self.relax.contact, false).map_err(refused)?;
        let pressed = Arc::new(Pressed::new(layers, &start.positions));
        let scene = scene.clone().with_targets(Targets::at_rest());
        let (mut state, mut projected) = (start.clone(), true);
        let (mut factorisations, mut evaluations, mut cancelled) = (0, 0, false);
        loop {
            pressed.grow(&state.positions, projected);
            let mut descent =
                Descent::under_contact(model, &scene, pressed.clone()).ok_or_else(|| Failed::Backend {
                    source: Arc::new(OutOfMemory { rows: 3 * model.node_count() }),
                    last_read: Box::new(start.clone()),
                    last_read_step: 0,
                })?;
            (descent.factorisations, descent.evaluations) = (factorisations, evaluations);
            let goal = if projected { NEAR.max(self.residual) } else { self.residual };
            let mut watch = |evaluations, moved| {
                cancelled |= observe(evaluations, moved).is_break();
                if cancelled || pressed.outgrown() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            let (end, measured) = descent.descend(&mut state, goal, self.max_factorisations, &mut watch);
            (factorisations, evaluations) = (descent.factorisations, descent.evaluations);
            match end {
                // Other layers press.
                End::Cancelled if !cancelled => {}
                End::Settled | End::Stuck if projected => projected = false,
                _ => {
                    state.velocities.fill(DVec3::ZERO);
                    let converged = end == End::Settled;
                    let stability = descent.stability(&state, &measured);
                    let equilibrium = Equilibrium {
                        cancelled,
                        reactions: descent.reactions(&state),
                        distance: if converged { descent.distance(&state, &measured) } else { f64::INFINITY },
                        converged,
                        residual: measured.residual,
                        factorisations: descent.factorisations,
                        evaluations: descent.evaluations,
                        escapes: 0,
                        stability,
                        state: state.clone(),
                    };
                    let touch = pressed.look(&state.positions, |layers| touched(model, layers, &state, touch));
                    return Ok((equilibrium, touch));
                }
            }
        }
    }
}
