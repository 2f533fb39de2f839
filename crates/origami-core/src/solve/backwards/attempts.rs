//! The layers of a flat-folded sheet moved apart in one way after the other, until it opens from there.

use std::ops::ControlFlow;

use glam::DVec3;

use super::super::{ContactRelax, Failed, Folded, Progress, Relax, Solver, State, Stop};
use super::order_force::OrderForce;
use super::relations::{Beside, Flat, distinct};
use super::{Backwards, Motion, NotBackwards};
use crate::contact::Crossings;
use crate::ids::TriangleId;
use crate::layers::Stacking;
use crate::model::Model;
use crate::scene::{Scene, Targets};

/// What is tried in turn, until nothing crosses and the sheet opens: thin layers first, whose folds are shifted into each other
/// from the start; then thick ones that find their way by opening the creases farther, each from the state before it.
pub(super) const ATTEMPTS: [Attempt; 10] = [
    Attempt { open: 5.0, gap: 3e-4, margin: 3e-3, beyond: 1.2e-3, shifted: true },
    Attempt { open: 5.0, gap: 1e-3, margin: 3e-3, beyond: 1.2e-3, shifted: true },
    Attempt { open: 5.0, gap: 3e-3, margin: 1e-2, beyond: 4e-3, shifted: true },
    Attempt { open: 5.0, gap: 1e-2, margin: 1e-2, beyond: 4e-3, shifted: true },
    Attempt { open: 5.0, gap: 1e-2, margin: 2e-3, beyond: 1e-2, shifted: false },
    Attempt { open: 5.0, gap: 3e-3, margin: 2e-3, beyond: 1e-2, shifted: false },
    Attempt { open: 10.0, gap: 1e-2, margin: 2e-3, beyond: 1e-2, shifted: false },
    Attempt { open: 10.0, gap: 3e-3, margin: 2e-3, beyond: 1e-2, shifted: false },
    Attempt { open: 20.0, gap: 1e-2, margin: 2e-3, beyond: 1e-2, shifted: false },
    Attempt { open: 20.0, gap: 3e-3, margin: 2e-3, beyond: 1e-2, shifted: false },
];
/// Times that what crosses beside each other is parted in one attempt.
const ROUNDS: usize = 4;
/// Evaluations of a round.
const ROUND: u64 = 1500;
/// From one state to the next on the way to flat the gap and the opening shrink to this share.
const SHRINK: f64 = 0.6;
/// Such states at most.
const MOST_HELD: usize = 8;
/// Places between two states that are tested.
const BETWEEN: u32 = 8;
/// A sheet is open if no crease is farther from its angle than this, in radians.
const OPENED: f64 = 1e-3;
/// Evaluations of a stage under contact at most.
const STAGE: u64 = 6000;

/// How layers are moved apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Attempt {
    /// How far creases stay open, in percent.
    open: f64,
    /// Between layers, in radii.
    gap: f64,
    /// Between what lies beside each other, in radii.
    margin: f64,
    /// How far beyond its end a thing still counts where no paper folds around that, in radii.
    beyond: f64,
    /// Whether what lies in a fold is kept from its crease, and folds back to back from each other.
    shifted: bool,
}

/// A state that the order of its layers holds.
pub(super) struct Held {
    folded: Folded,
    attempt: Attempt,
}

/// One search for a motion.
pub(super) struct Run<'a> {
    backwards: &'a Backwards,
    model: &'a Model,
    exact: Folded,
    flat: Flat<'a>,
    /// What keeps folds from each other from the start.
    shifts: Vec<Beside>,
    force: OrderForce,
    /// Where the last attempt ended.
    reached: State,
    evaluations: u64,
}

impl<'a> Run<'a> {
    pub(super) fn new(backwards: &'a Backwards, model: &'a Model, exact: Folded, stacking: &Stacking) -> Self {
        let flat = Flat::new(&model.mesh, &exact.state.positions, stacking);
        let relations = flat.relations(stacking);
        let mut shifts = flat.nested(&relations);
        shifts.extend(flat.back_to_back());
        let force = OrderForce { relations, beside: Vec::new(), gap: 0.0, margin: 0.0, beyond: 0.0 };
        let reached = exact.state.clone();
        Self { backwards, model, exact, flat, shifts: distinct(shifts), force, reached, evaluations: 0 }
    }

    /// A state near the flat one in which nothing crosses.
    pub(super) fn embed(
        &mut self,
        attempt: Attempt,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Held, NotBackwards> {
        if attempt.shifted {
            self.force.beside.clone_from(&self.shifts);
            self.reached.clone_from(&self.exact.state);
        } else if self.force.beside.starts_with(&self.shifts) && !self.shifts.is_empty() {
            self.force.beside.clear();
            self.reached.clone_from(&self.exact.state);
        }
        let start = self.reached.clone();
        let (folded, crossings) = self.hold(&start, attempt, observe)?;
        self.reached.clone_from(&folded.state);
        if crossings.is_empty() { Ok(Held { folded, attempt }) } else { Err(NotBackwards::Embedded { crossings }) }
    }

    /// Relaxes from a state under the force that keeps the order, again and again while triangles cross that only touched.
    fn hold(
        &mut self,
        start: &State,
        attempt: Attempt,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Crossings), Failed> {
        let Attempt { open, gap, margin, beyond, .. } = attempt;
        (self.force.gap, self.force.margin, self.force.beyond) = (gap, margin, beyond);
        let relax = Relax {
            tolerance: 2e-5 * open,
            perturbation: 0.0,
            saddle_search: 0.0,
            retry: false,
            softening: None,
            hand_over: None,
            max_steps: ROUND,
            ramp: None,
            steps: None,
            ..self.backwards.relax.clone()
        };
        let (mut from, mut round) = (start.clone(), 1);
        loop {
            let scene = Scene::percent(100.0 - open).with_force(self.force.clone());
            let mut folded = relax.fold(self.model, &from, &scene, observe)?;
            self.evaluations += folded.steps;
            folded.stop = Stop::StepsDone;
            let crossings = Crossings::of(&self.model.mesh, &folded.state.positions);
            if crossings.is_empty() || round == ROUNDS || !self.part(&crossings) {
                return Ok((folded, crossings));
            }
            (from, round) = (folded.state, round + 1);
        }
    }

    /// Parts triangles that cross and have no order, since in the flat state they lie beside each other; false where there are none.
    fn part(&mut self, crossings: &Crossings) -> bool {
        let mesh = &self.model.mesh;
        let pairs = crossings.all.iter().flat_map(|crossing| {
            let own = mesh.sides[crossing.side.index()].triangles.into_iter().flatten();
            own.map(move |t| [t, crossing.triangle])
        });
        let beside: Vec<[TriangleId; 2]> = pairs.filter(|[t, u]| !self.flat.is_ordered(*t, *u)).collect();
        let before = self.force.beside.len();
        let added = beside.iter().flat_map(|[t, u]| self.flat.apart(*t, *u));
        self.force.beside = distinct(self.force.beside.iter().copied().chain(added).collect());
        self.force.beside.len() > before || !beside.is_empty()
    }

    /// Opens the sheet under contact: the states on the way, the open one last.
    pub(super) fn open(
        &mut self,
        held: &Held,
        stages: u32,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Vec<Folded>, NotBackwards> {
        let relax =
            Relax { perturbation: 0.0, max_steps: STAGE, ramp: None, steps: None, ..self.backwards.relax.clone() };
        let solver = ContactRelax { relax, contact: self.backwards.contact };
        let stages = stages.max(1);
        let mut states: Vec<Folded> = Vec::new();
        for stage in (0..stages).rev() {
            let percent = (100.0 - held.attempt.open) * f64::from(stage) / f64::from(stages);
            let from = states.last().map_or(&held.folded.state, |folded| &folded.state);
            let mut folded = solver.fold(self.model, from, &Scene::percent(percent), observe)?;
            self.evaluations += folded.steps;
            if stage > 0 {
                folded.stop = Stop::StepsDone;
            }
            states.push(folded);
        }
        let open = states.last().map_or(&self.exact.state, |folded| &folded.state);
        let off = open.fold_angles.iter().fold(0.0_f64, |off, angle| off.max(angle.abs()));
        if off < OPENED { Ok(states) } else { Err(NotBackwards::Closed { off }) }
    }

    /// The states that come ever nearer to the flat one, as long as nothing crosses.
    fn close(
        &mut self,
        held: Held,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Vec<Held>, NotBackwards> {
        let mut states = vec![held];
        for _ in 0..MOST_HELD {
            let Some(Held { folded, attempt }) = states.last() else { break };
            let attempt = Attempt { open: SHRINK * attempt.open, gap: SHRINK * attempt.gap, ..*attempt };
            let start = folded.state.clone();
            let (folded, crossings) = self.hold(&start, attempt, observe)?;
            if !crossings.is_empty() || !self.is_free(&start.positions, &folded.state.positions) {
                break;
            }
            states.push(Held { folded, attempt });
        }
        Ok(states)
    }

    /// Whether nothing crosses in line between two states, as far as it is tested.
    fn is_free(&self, from: &[DVec3], to: &[DVec3]) -> bool {
        (1..=BETWEEN).all(|place| {
            let share = f64::from(place) / f64::from(BETWEEN + 1);
            let positions: Vec<DVec3> = from.iter().zip(to).map(|(from, to)| from.lerp(*to, share)).collect();
            Crossings::of(&self.model.mesh, &positions).is_empty()
        })
    }

    /// All states in the order in which they are folded.
    pub(super) fn into_motion(
        mut self,
        held: Held,
        opened: Vec<Folded>,
        stacking: Stacking,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Motion, NotBackwards> {
        let closing = self.close(held, observe)?;
        let Some((last, gap)) = closing.last().map(|held| (&held.folded.state, held.attempt.gap)) else {
            return Err(NotBackwards::Closed { off: f64::NAN });
        };
        let angles = last.fold_angles.iter().zip(&self.exact.state.fold_angles);
        let off = angles.map(|(own, flat)| (own - flat).abs()).fold(0.0, f64::max);
        // The open sheet has been reached but for the tolerance of the solver.
        let rest = Folded {
            state: State::at_rest(self.model),
            targets: Targets::percent(0.0),
            steps: 0,
            residual: 0.0,
            distance: 0.0,
            ..self.exact.clone()
        };
        let mut states = vec![rest];
        states.extend(opened.into_iter().rev().skip(1));
        let touching = states.len() + 1;
        states.extend(closing.into_iter().map(|held| held.folded));
        states.push(self.exact);
        Ok(Motion { states, touching, stacking, gap, off, evaluations: self.evaluations })
    }
}
