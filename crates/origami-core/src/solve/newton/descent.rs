//! Downhill by Newton's method: where the Hessian is not positive definite it is shifted until it is, so that every step
//! leads down, on frustrated patterns too.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DVec3;

use super::factor::Factor;
use super::matrix::Matrix;
use super::pressed::Pressed;
use super::rigid::Rigid;
use crate::forces::Forces;
use crate::model::Model;
use crate::scene::{Reaction, Scene};
use crate::solve::State;
use crate::solve::largest::largest;
use crate::solve::saddle::{TRIALS, irregular, lowest_along};

/// Shifts are shares of each node's row sum. The first one ...
const FIRST: f64 = 1e-6;
/// ... the least, far above what rounding makes of a rigid motion's eigenvalue 0 ...
const LEAST: f64 = 1e-13;
/// ... and one so large that a step is hardly more than rounding.
const LARGEST: f64 = 1e8;
/// A step that hardly helped is followed by a shift so many times larger,
const RAISE: f64 = 8.0;
/// and one that did what it promised by one so many times smaller,
const LOWER: f64 = 0.1;
/// unless the forces fell to this share anyway: a shift that does not hurt keeps directions that cost nothing at rest.
const FAST: f64 = 0.1;
/// No node moves farther in one step, in radii, ...
const LONGEST_MOVE: f64 = 0.2;
/// ... and no crease turns farther, in radians: it might turn to another branch.
const LONGEST_TURN: f64 = 0.7;
/// The share of the promised decrease that is enough.
const ENOUGH: f64 = 0.1;
/// The share of it with which the promise counts as kept.
const KEPT: f64 = 0.75;
/// How often a step that does not lead down is halved before the shift is raised.
const HALVINGS: u32 = 3;
/// Differences below this share of the energy drown in rounding, and are taken from forces times moves.
const DROWNED: f64 = 1e-8;
/// Rounding of a force, as a share of the row sum: below it a residual need not fall any more.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// What counts as an eigenvalue of 0, as a share of the row sums, where forces vanish.
const NEUTRAL: f64 = 1e-11;
/// Under forces a rotation has one of about their share of the row sums: so many times that counts as 0 too.
const TURNED: f64 = 10.0;
/// Rounds of inverse iteration towards the lowest mode.
const ROUNDS: u32 = 30;

/// Forces and energy of a state.
#[derive(Clone, Debug)]
pub(super) struct Measured {
    forces: Vec<DVec3>,
    energy: f64,
    pub(super) residual: f64,
}

/// How a descent ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// The forces are as small as asked for, or as rounding allows.
    Settled,
    /// So many factorisations or evaluations have been made.
    Limit,
    /// Nothing leads down any more.
    Stuck,
    /// Who watched it broke it off.
    Cancelled,
}

/// How many directions cost no energy at a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stability {
    /// Independent directions in which the energy falls: 0 at a minimum.
    pub negative: usize,
    /// Directions in which it does not change: 6 rigid motions for each part that nothing holds, and mechanisms.
    pub neutral: usize,
}

/// All that Newton's method keeps for a model.
pub(super) struct Descent<'m> {
    model: &'m Model,
    /// What acts besides the springs; its targets count for nothing.
    pub(super) scene: Scene,
    matrix: Matrix<'m>,
    factor: Factor,
    rigid: Rigid,
    forces: Forces<'m>,
    column: Vec<f64>,
    step: Vec<DVec3>,
    shift: f64,
    /// What keeps layers apart; it is one of the scene's forces too.
    pressed: Option<Arc<Pressed>>,
    pub(super) factorisations: u32,
    pub(super) evaluations: u64,
    /// Evaluations that are allowed.
    most: u64,
}

impl<'m> Descent<'m> {
    /// `None` where the factors do not fit into memory.
    pub(super) fn new(model: &'m Model, scene: &Scene) -> Option<Self> {
        Self::made((model, scene), None, Rigid::new(model, scene))
    }

    /// The same of a sheet whose layers press on each other. Where other layers begin to, it is to be made anew.
    pub(super) fn under_contact(model: &'m Model, scene: &Scene, pressed: Arc<Pressed>) -> Option<Self> {
        // A turn of the whole sheet costs contact nothing.
        let rigid = Rigid::new(model, scene);
        let mut scene = scene.clone();
        scene.forces.push(pressed.clone());
        Self::made((model, &scene), Some(pressed), rigid)
    }

    fn made((model, scene): (&'m Model, &Scene), pressed: Option<Arc<Pressed>>, rigid: Rigid) -> Option<Self> {
        let matrix = Matrix::new(model, scene);
        let factor = Factor::new(matrix.structure())?;
        Some(Self {
            model,
            factor,
            rigid,
            pressed,
            forces: Forces::in_scene(model, scene),
            scene: scene.clone(),
            column: vec![0.0; matrix.size()],
            step: vec![DVec3::ZERO; model.node_count()],
            matrix,
            shift: FIRST,
            factorisations: 0,
            evaluations: 0,
            most: u64::MAX,
        })
    }

    /// Forgets all but the order of elimination: the same input gives the same bits, whatever came before. `most`
    /// evaluations are allowed from now on.
    pub(super) fn begin(&mut self, most: u64) {
        self.forces = Forces::in_scene(self.model, &self.scene);
        (self.shift, self.factorisations, self.evaluations, self.most) = (FIRST, 0, 0, most);
    }

    /// Whether `limit` factorisations, or as many evaluations as are allowed, have been made.
    pub(super) fn is_spent(&self, limit: u32) -> bool {
        self.factorisations >= limit || self.evaluations >= self.most
    }

    /// Forgets the shift.
    pub(super) fn forget(&mut self) {
        self.shift = FIRST;
    }

    /// What the supports do to the held nodes at `state`.
    pub(super) fn reactions(&mut self, state: &State) -> Vec<Reaction> {
        if self.forces.held().is_empty() {
            return Vec::new();
        }
        self.forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles.clone());
        self.forces.reactions().to_vec()
    }

    pub(super) fn measure(&mut self, state: &mut State) -> Measured {
        self.evaluations += 1;
        let forces = self.forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles).to_vec();
        let residual = if forces.iter().all(|f| f.is_finite()) { largest(&forces) } else { f64::INFINITY };
        Measured { energy: state.energy_in(self.model, &self.scene).total(), residual, forces }
    }

    /// Goes down from `state` until no force exceeds `goal`, with at most `limit` factorisations in all. `observe` is told
    /// how far each step went.
    pub(super) fn descend(
        &mut self,
        state: &mut State,
        goal: f64,
        limit: u32,
        observe: &mut dyn FnMut(u64, f64) -> ControlFlow<()>,
    ) -> (End, Measured) {
        let mut now = self.measure(state);
        let mut before = f64::INFINITY;
        loop {
            self.matrix.assemble(state);
            let rounded = now.residual <= ROUNDING * self.matrix.largest_weight();
            if now.residual <= goal || rounded && now.residual > 0.5 * before {
                return (End::Settled, now);
            }
            before = now.residual;
            loop {
                if self.is_spent(limit) {
                    return (End::Limit, now);
                }
                if self.shift > LARGEST || !now.residual.is_finite() {
                    return (End::Stuck, now);
                }
                if self.solve_for(state, &now.forces)
                    && let Some(next) = self.try_step(state, &now)
                {
                    now = next;
                    if observe(self.evaluations, longest(&self.step)).is_break() {
                        return (End::Cancelled, now);
                    }
                    break;
                }
                if rounded {
                    return (End::Settled, now);
                }
                self.shift *= RAISE;
            }
        }
    }

    /// The farthest that a node would move in a Newton step from `state`: how far the equilibrium is. Infinite where there
    /// is no step that leads down.
    pub(super) fn distance(&mut self, state: &State, now: &Measured) -> f64 {
        if self.matrix.size() == 0 {
            return 0.0;
        }
        self.matrix.assemble(state);
        if self.solve_for(state, &now.forces) { longest(&self.step) } else { f64::INFINITY }
    }

    /// Solves for the step from `state`; whether the shifted Hessian is positive definite, so that the step leads down.
    fn solve_for(&mut self, state: &State, forces: &[DVec3]) -> bool {
        if self.factorise(self.shift) != Some(0) {
            return false;
        }
        self.solve(state, forces);
        self.step.iter().all(|s| s.is_finite())
    }

    fn factorise(&mut self, shift: f64) -> Option<usize> {
        self.factorisations += 1;
        self.factor.factorise(self.matrix.shifted(shift))
    }

    fn solve(&mut self, state: &State, right: &[DVec3]) {
        self.matrix.gather(right, &mut self.column);
        self.factor.solve(&mut self.column);
        self.matrix.scatter(&self.column, &mut self.step);
        self.rigid.remove(&state.positions, self.matrix.row_sums(), &mut self.step);
    }

    /// Moves `state` by the step or a part of it, if one leads down far enough, and adapts the shift.
    fn try_step(&mut self, state: &mut State, now: &Measured) -> Option<Measured> {
        let slope: f64 = now.forces.iter().zip(&self.step).map(|(f, s)| f.dot(*s)).sum();
        // Of the Hessian itself: the step solves (H + shift W) step = forces.
        let curvature = slope - self.shift * self.matrix.weighted_square(&self.step);
        let mut share = (LONGEST_MOVE / longest(&self.step)).min(1.0);
        if let Some(pressed) = &self.pressed {
            share = share.min(pressed.share(&state.positions, &self.step));
        }
        for halvings in 0..=HALVINGS {
            let promised = share * slope - 0.5 * share * share * curvature;
            let mut trial = state.clone();
            for (p, step) in trial.positions.iter_mut().zip(&self.step) {
                *p += *step * share;
            }
            let then = self.measure(&mut trial);
            let decrease = if promised.abs() > DROWNED * now.energy {
                now.energy - then.energy
            } else {
                let both = now.forces.iter().zip(&then.forces).zip(&self.step);
                0.5 * share * both.map(|((f, g), s)| (*f + *g).dot(*s)).sum::<f64>()
            };
            let turns = trial.fold_angles.iter().zip(&state.fold_angles).map(|(a, b)| (a - b).abs());
            let sane = then.residual.is_finite() && turns.fold(0.0, f64::max) <= LONGEST_TURN;
            if sane && decrease > ENOUGH * promised {
                if halvings > 0 {
                    self.shift *= RAISE;
                } else if decrease > KEPT * promised && then.residual > FAST * now.residual {
                    self.shift = (self.shift * LOWER).max(LEAST);
                }
                self.step.iter_mut().for_each(|s| *s *= share);
                *state = trial;
                return Some(then);
            }
            share *= 0.5;
        }
        None
    }

    /// Which directions cost energy at `state`.
    pub(super) fn stability(&mut self, state: &State, now: &Measured) -> Option<Stability> {
        if self.matrix.size() == 0 {
            return Some(Stability { negative: 0, neutral: 0 });
        }
        self.matrix.assemble(state);
        let threshold = self.threshold(now);
        let negative = self.factorise(threshold)?;
        let below = self.factorise(-threshold)?;
        Some(Stability { negative, neutral: below.saturating_sub(negative) })
    }

    fn threshold(&self, now: &Measured) -> f64 {
        NEUTRAL.max(TURNED * now.residual / self.matrix.least_weight())
    }

    /// Leaves a saddle along its lowest mode, to the side and as far as the energy falls most; false where it does not.
    pub(super) fn escape(&mut self, state: &mut State, limit: u32) -> bool {
        let now = self.measure(state);
        self.matrix.assemble(state);
        let mut shift = self.threshold(&now);
        while self.factorise(shift) != Some(0) {
            shift *= RAISE;
            if shift > LARGEST || self.is_spent(limit) {
                return false;
            }
        }
        let mut mode: Vec<DVec3> = (0..self.model.node_count()).map(|i| irregular(i as f64)).collect();
        for _ in 0..ROUNDS {
            let right = self.matrix.weigh(&mode);
            self.solve(state, &right);
            let length = longest(&self.step);
            if !(length.is_finite() && length > 0.0) {
                return false;
            }
            mode.iter_mut().zip(&self.step).for_each(|(m, s)| *m = *s / length);
        }
        self.evaluations += TRIALS;
        let Some(trial) = lowest_along(self.model, &self.scene, state, &mode) else { return false };
        *state = trial;
        self.shift = shift;
        true
    }
}

fn longest(moves: &[DVec3]) -> f64 {
    moves.iter().map(|m| m.length()).fold(0.0, f64::max)
}
