//! The reference: Newton's method on the exact energy, to a residual at which nothing is left to converge.

pub(super) mod approach;
mod contact;
mod descent;
mod factor;
mod matrix;
mod pressed;
mod rigid;

pub use contact::ContactNewton;
pub use descent::Stability;
#[cfg(feature = "analysis")]
pub(crate) use factor::Factor;

use std::ops::ControlFlow;

use descent::{Descent, End};
use glam::DVec3;

use super::perturb::perturb;
use super::{Diverged, Failed, Folded, Progress, Relax, Session, Solver, State, Stop, unwatched};
use crate::ids::NodeId;
use crate::model::{Inventory, Model};
use crate::scene::{Held, Needs, Reaction, Scene, Targets};

/// Largest share of the way that one increment may be, and the least.
const LONGEST_INCREMENT: f64 = 0.25;
const SHORTEST_INCREMENT: f64 = 1e-3;
/// Residual at which an increment is done, and factorisations after which it was too long.
const LOOSE: f64 = 1e-6;
const PATIENCE: u32 = 40;
/// An increment done with fewer factorisations is followed by a longer one.
const EASY: u32 = 10;
/// How many saddles are left, one after the other.
const ESCAPES: u32 = 8;

/// Newton's method with exact Hessians and sparse factorisations: equilibria to a residual of 1e-10, against which the
/// errors of the other solvers are measured.
///
/// The Hessian is shifted where it is not positive definite, so that every step leads down; a saddle is left along its
/// lowest mode. Memory and time grow faster than the sheet. By default it begins where [`Relax`] ends, and so finds the
/// equilibrium on the branch that a ramp leads to.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct Newton {
    /// Largest force on a node at which it stops, in the model's unit of force; where stiffnesses are so large that
    /// rounding leaves more, that. Default 1e-10.
    pub residual: f64,
    /// What goes ahead to the neighbourhood of the equilibrium. `None`: nothing, the target angles rise in increments,
    /// and each is solved for. Default: [`Relax`] with its defaults.
    pub relax: Option<Relax>,
    /// Without `relax`, how many increments the way to the target angles is first divided into; each is halved where it
    /// turns out too long, and the next is longer where it was easy. Default 10.
    pub increments: u32,
    /// Without `relax`, how far each node is moved at the start, as [`Relax::perturbation`]. Default 1e-2.
    pub perturbation: f64,
    /// Factorisations after which it gives up. Default 2000.
    pub max_factorisations: u32,
    /// Force evaluations after which it gives up, those of `relax` included; a step that has begun is ended. Default: no
    /// limit but that of `relax` for its own.
    pub max_steps: u64,
}

impl Default for Newton {
    fn default() -> Self {
        Self {
            residual: 1e-10,
            relax: Some(Relax::default()),
            increments: 10,
            perturbation: Relax::default().perturbation,
            max_factorisations: 2000,
            max_steps: u64::MAX,
        }
    }
}

/// A state that Newton's method arrived at, and how.
#[derive(Clone, Debug)]
pub struct Equilibrium {
    /// The state.
    pub state: State,
    /// Whether the residual is as small as asked for.
    pub converged: bool,
    /// Largest force on a node, in the model's unit of force.
    pub residual: f64,
    /// How far a node would move in one more step, in radii of the sheet; infinite where it has not converged.
    pub distance: f64,
    /// Factorisations, those that did not help included.
    pub factorisations: u32,
    /// Force evaluations.
    pub evaluations: u64,
    /// Saddles that were left.
    pub escapes: u32,
    /// Which directions cost energy; `None` where a factorisation failed.
    pub stability: Option<Stability>,
    /// What the supports do to the held nodes, in the order of the nodes.
    pub reactions: Vec<Reaction>,
    /// Whether it was broken off by who watched it.
    cancelled: bool,
}

impl Newton {
    /// The equilibrium at the target angles of `start`, downhill from there.
    ///
    /// # Errors
    /// [`Failed::Diverged`] where `start` is not finite; [`Failed::Backend`] where the factors do not fit into memory.
    pub fn refine(&self, model: &Model, start: &State) -> Result<Equilibrium, Failed> {
        self.refine_in(model, start, &Scene::default())
    }

    /// The same under the supports, loads and forces of `scene`, whatever its targets are.
    ///
    /// # Errors
    /// As [`Newton::refine`], and [`Failed::Refused`] where the scene does not fit.
    pub fn refine_in(&self, model: &Model, start: &State, scene: &Scene) -> Result<Equilibrium, Failed> {
        let scene = scene.clone().with_targets(Targets::at_rest());
        let mut start = start.clone();
        scene.place_supports(&mut start.positions);
        let mut descent = descent_in(model, &start, &scene)?;
        descent.begin(self.max_steps);
        Ok(self.settle(&mut descent, start, &mut |_, _| ControlFlow::Continue(())))
    }

    /// The equilibrium in `scene`, reached from `start` in increments, whatever `relax` says.
    ///
    /// # Errors
    /// [`Failed::Diverged`] where `start` is not finite; [`Failed::Backend`] where the factors do not fit into memory.
    pub fn climb(&self, model: &Model, start: &State, scene: &Scene) -> Result<Equilibrium, Failed> {
        let mut descent = descent_in(model, start, scene)?;
        descent.begin(self.max_steps);
        let targets = scene.targets.of(model).map_err(|refusal| Failed::refused(refusal, start))?;
        Ok(self.rise(&mut descent, model, start, targets, &mut unwatched))
    }

    /// Which directions cost energy at `state`; `None` where the factors do not fit into memory or one of them failed.
    /// At an equilibrium it tells a minimum from a saddle; the larger the forces are, the more counts as neutral.
    #[must_use]
    pub fn stability(model: &Model, state: &State) -> Option<Stability> {
        let mut descent = Descent::new(model, &Scene::default())?;
        let now = descent.measure(&mut state.clone());
        descent.stability(state, &now)
    }

    fn settle(
        &self,
        descent: &mut Descent<'_>,
        mut state: State,
        observe: &mut dyn FnMut(u64, f64) -> ControlFlow<()>,
    ) -> Equilibrium {
        let limit = self.max_factorisations;
        let mut escapes = 0;
        let (end, measured, stability) = loop {
            let (end, measured) = descent.descend(&mut state, self.residual, limit, observe);
            let stability = descent.stability(&state, &measured);
            let saddle = stability.is_some_and(|stability| stability.negative > 0);
            if end != End::Settled || !saddle || escapes >= ESCAPES || !descent.escape(&mut state, limit) {
                break (end, measured, stability);
            }
            escapes += 1;
        };
        state.velocities.fill(DVec3::ZERO);
        Equilibrium {
            cancelled: end == End::Cancelled,
            reactions: descent.reactions(&state),
            distance: if end == End::Settled { descent.distance(&state, &measured) } else { f64::INFINITY },
            converged: end == End::Settled,
            residual: measured.residual,
            factorisations: descent.factorisations,
            evaluations: descent.evaluations,
            escapes,
            stability,
            state,
        }
    }

    fn rise(
        &self,
        descent: &mut Descent<'_>,
        model: &Model,
        start: &State,
        targets: Vec<f64>,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Equilibrium {
        let mut state = start.clone();
        if self.perturbation > 0.0 && targets != start.targets {
            perturb(model, &Held::new(model, &descent.scene), &mut state.positions, self.perturbation, 0);
        }
        descent.scene.place_supports(&mut state.positions);
        let (mut share, mut increment) = (0.0, 1.0 / f64::from(self.increments.max(1)));
        while share < 1.0 && !descent.is_spent(self.max_factorisations) {
            let next = if share + increment > 1.0 - 1e-9 { 1.0 } else { share + increment };
            let mut trial = state.clone();
            for ((target, from), to) in trial.targets.iter_mut().zip(&start.targets).zip(&targets) {
                *target = from + next * (to - from);
            }
            let before = descent.factorisations;
            let limit = self.max_factorisations.min(before.saturating_add(PATIENCE));
            let (end, _) = descent.descend(&mut trial, LOOSE, limit, &mut |step, distance| {
                observe(Progress { step, ramp: next, distance })
            });
            if end == End::Cancelled {
                state = trial;
                break;
            }
            if end == End::Settled || increment <= SHORTEST_INCREMENT {
                (state, share) = (trial, next);
                if descent.factorisations - before < EASY {
                    increment = (1.5 * increment).min(LONGEST_INCREMENT);
                }
            } else {
                increment *= 0.5;
                descent.forget();
            }
        }
        state.targets = targets;
        self.settle(descent, state, &mut |step, distance| observe(Progress { step, ramp: 1.0, distance }))
    }

    fn solve(
        &self,
        descent: &mut Descent<'_>,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        let targets = scene.targets.of(model).map_err(|refusal| Failed::refused(refusal, start))?;
        descent.begin(self.max_steps);
        let (reached, steps, attempts, left, before) = match &self.relax {
            Some(relax) => {
                let relax = Relax { max_steps: relax.max_steps.min(self.max_steps), ..relax.clone() };
                let near = relax.fold(model, start, scene, observe)?;
                if near.stop == Stop::Cancelled {
                    return Ok(near);
                }
                let steps = near.steps;
                if steps >= self.max_steps {
                    return Ok(Folded { stop: Stop::StepLimit, time_step: 1.0, ..near });
                }
                descent.begin(self.max_steps - steps);
                let mut observe = |step, distance| observe(Progress { step: steps + step, ramp: 1.0, distance });
                let reached = self.settle(descent, near.state, &mut observe);
                (reached, steps, near.attempts, near.saddles, near.factorisations)
            }
            None => (self.rise(descent, model, start, targets, observe), 0, 1, 0, 0),
        };
        let stop = match reached.converged {
            true => Stop::Converged,
            false if reached.cancelled => Stop::Cancelled,
            false => Stop::StepLimit,
        };
        Ok(Folded {
            state: reached.state,
            targets: scene.targets.clone(),
            stop,
            steps: steps + reached.evaluations,
            time_step: 1.0,
            residual: reached.residual,
            distance: reached.distance,
            attempts,
            saddles: left + reached.escapes,
            factorisations: before + reached.factorisations,
            reactions: reached.reactions,
        })
    }
}

impl Solver for Newton {
    fn fold(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        self.solve(&mut descent_in(model, start, scene)?, model, start, scene, observe)
    }

    fn session<'a>(&'a self, model: &'a Model) -> Box<dyn Session + 'a> {
        Box::new(Kept { newton: self, model, descent: None })
    }

    fn inventory(&self, model: &Model) -> Inventory {
        let mut inventory = model.inventory.clone();
        inventory.without("damping", "Newton's method seeks the equilibrium, which does not depend on it");
        inventory
    }
}

/// The order of elimination is found once.
struct Kept<'a> {
    newton: &'a Newton,
    model: &'a Model,
    descent: Option<Descent<'a>>,
}

impl Session for Kept<'_> {
    fn fold(
        &mut self,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        let kept = self.descent.take().filter(|kept| kept.scene.acts_as(scene));
        let made = kept.map_or_else(|| descent_in(self.model, start, scene), Ok)?;
        self.newton.solve(self.descent.insert(made), self.model, start, scene, observe)
    }
}

/// The factors of the Hessian do not fit into memory.
#[derive(Clone, Copy, Debug, thiserror::Error)]
#[error("the factors of a Hessian of {rows} rows do not fit into memory; --solver relax needs none")]
pub struct OutOfMemory {
    /// Three for each node that moves.
    pub rows: usize,
}

fn descent_in<'m>(model: &'m Model, start: &State, scene: &Scene) -> Result<Descent<'m>, Failed> {
    let needs = [Needs::Energy, Needs::Hessian];
    let checked = scene.check(model).and_then(|()| scene.check_balance(model));
    let checked =
        checked.and_then(|()| scene.check_forces(model, &needs, "newton", "`Relax` and `Dynamics` do without"));
    checked.map_err(|refusal| Failed::refused(refusal, start))?;
    if let Some(node) = start.positions.iter().position(|p| !p.is_finite()) {
        let place = (NodeId::new(node), start.positions[node], DVec3::ZERO);
        return Err(Diverged::new(model, place, 0, Box::new(State::at_rest(model)), 0).into());
    }
    Descent::new(model, scene).ok_or_else(|| Failed::Backend {
        source: std::sync::Arc::new(OutOfMemory { rows: 3 * model.node_count() }),
        last_read: Box::new(start.clone()),
        last_read_step: 0,
    })
}
