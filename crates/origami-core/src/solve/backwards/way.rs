//! From an embedded state to both ends of a motion: the open sheet, and what is nearest to the flat one.

use std::f64::consts::PI;
use std::ops::ControlFlow;

use glam::DVec3;

use super::super::{ContactRelax, Folded, Progress, Relax, Solver, State, Stop};
use super::attempts::{ATTEMPTS, Attempt, Held, Run};
use super::{Backwards, Motion, NotBackwards};
use crate::contact::{Contact, Crossings};
use crate::layers::Stacking;
use crate::model::Model;
use crate::scene::{Scene, Targets};

/// A sheet is open if no crease is farther from its angle than this, in radians.
const OPENED: f64 = 1e-3;
/// A sheet is nearly flat if no crease is farther from it than this, in radians: two degrees.
pub(super) const NEARLY: f64 = 0.035;
/// From one state to the next on the way to flat the gap and the opening shrink to this share.
const SHRINK: f64 = 0.6;
/// Such states at most.
const MOST_HELD: usize = 8;
/// Places between two states that are tested.
const BETWEEN: u32 = 8;
/// The sheet is pressed flat with these contact gaps in turn, in shares of that by which it opens.
const PRESSED: [f64; 2] = [1.0, 0.3];
/// Gaps with which it is embedded again from there, in radii.
const THINNER: [f64; 2] = [3e-4, 1e-4];
/// Evaluations of a stage under contact at most.
const STAGE: u64 = 6000;

/// A motion as it is found, from the embedded state to both of its ends.
pub(super) struct Way {
    /// The states on the way to the open sheet, that one last.
    opened: Vec<Folded>,
    /// The states on the way to the flat sheet, the embedded one first.
    closing: Vec<Folded>,
    /// How many of these contact leads from one to the next.
    touching: usize,
    /// How far apart layers are wanted in the last of them, in radii.
    gap: f64,
    /// The farthest that a crease is from flat there, in radians.
    pub(super) off: f64,
}

impl Run<'_> {
    /// Opens the sheet under contact: the states on the way, the open one last.
    fn open(
        &mut self,
        held: &Held,
        stages: u32,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Vec<Folded>, NotBackwards> {
        let solver = self.in_contact(1.0);
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

    /// What goes on from a state under contact, with such a share of the gap.
    fn in_contact(&self, share: f64) -> ContactRelax {
        let Backwards { relax, contact } = self.backwards;
        let relax = Relax { perturbation: 0.0, max_steps: STAGE, ramp: None, steps: None, ..relax.clone() };
        ContactRelax { relax, contact: Contact { gap: share * contact.gap, ..*contact } }
    }

    /// The farthest that a crease is from flat, in radians.
    fn off(&self, state: &State) -> f64 {
        let angles = state.fold_angles.iter().zip(&self.exact.state.fold_angles);
        angles.map(|(own, flat)| (own - flat).abs()).fold(0.0, f64::max)
    }

    /// The way through an embedded state: to the open sheet, and as near to the flat one as can be.
    pub(super) fn way(
        &mut self,
        held: Held,
        stages: u32,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Way, NotBackwards> {
        let opened = self.open(&held, stages, observe)?;
        let mut way = Way {
            opened,
            gap: held.attempt.gap,
            off: self.off(&held.folded.state),
            touching: 1,
            closing: vec![held.folded],
        };
        self.by_order(&mut way, held.attempt, observe);
        if way.off > NEARLY {
            self.press(&mut way, observe);
        }
        Ok(way)
    }

    /// Adds states that come ever nearer to the flat one, held by their order, as long as nothing crosses.
    fn by_order(&mut self, way: &mut Way, mut attempt: Attempt, observe: &mut dyn FnMut(Progress) -> ControlFlow<()>) {
        for _ in 0..MOST_HELD {
            let Some(start) = way.closing.last().map(|folded| folded.state.clone()) else { break };
            attempt = Attempt { open: SHRINK * attempt.open, gap: SHRINK * attempt.gap, ..attempt };
            let Ok((folded, crossings)) = self.hold(&start, attempt, observe) else { break };
            if !crossings.is_empty() || !self.is_free(&start.positions, &folded.state.positions) {
                break;
            }
            (way.gap, way.off) = (attempt.gap, self.off(&folded.state));
            way.closing.push(folded);
        }
    }

    /// Presses the embedded state flat under contact, in place of what its order holds, where that ends nearer to the flat one.
    fn press(&mut self, way: &mut Way, observe: &mut dyn FnMut(Progress) -> ControlFlow<()>) {
        let mut pressed: Vec<Folded> = way.closing.first().cloned().into_iter().collect();
        for share in PRESSED {
            let Some(from) = pressed.last() else { break };
            let solver = self.in_contact(share);
            let Ok(mut folded) = solver.fold(self.model, &from.state, &Scene::percent(100.0), observe) else { break };
            self.evaluations += folded.steps;
            // It is a place on the way, however the press ended: the end is the exact flat state.
            folded.stop = Stop::StepsDone;
            let off = self.off(&folded.state);
            pressed.push(folded);
            if off < way.off {
                (way.gap, way.off, way.touching) = (solver.contact.gap, off, pressed.len());
                way.closing.clone_from(&pressed);
            }
        }
    }

    /// Embeds the sheet again, thinner, from where it was pressed, and goes through that where it ends nearer to the flat state.
    pub(super) fn thinner(
        &mut self,
        mut way: Way,
        stages: u32,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Way {
        let beside = self.force.beside.clone();
        for gap in THINNER {
            let Some(start) = way.closing.last().filter(|_| way.off > NEARLY).map(|folded| folded.state.clone()) else {
                break;
            };
            let open = (SHRINK * 100.0 * way.off / PI).min(ATTEMPTS[0].open);
            let attempt = Attempt { open, gap, margin: 3.0 * gap, ..ATTEMPTS[0] };
            let Ok((folded, crossings)) = self.hold(&start, attempt, observe) else { continue };
            if crossings.is_empty() {
                let other = self.way(Held { folded, attempt }, stages, observe);
                way = other.ok().filter(|other| other.off < way.off).unwrap_or(way);
            }
        }
        self.force.beside = beside;
        way
    }

    /// Whether nothing crosses in line between two states, as far as it is tested.
    fn is_free(&self, from: &[DVec3], to: &[DVec3]) -> bool {
        (1..=BETWEEN).all(|place| {
            let share = f64::from(place) / f64::from(BETWEEN + 1);
            let positions: Vec<DVec3> = from.iter().zip(to).map(|(from, to)| from.lerp(*to, share)).collect();
            Crossings::of(&self.model.mesh, &positions).is_empty()
        })
    }
}

impl Way {
    /// All states in the order in which they are folded.
    pub(super) fn into_motion(self, model: &Model, exact: Folded, stacking: Stacking, evaluations: u64) -> Motion {
        // The open sheet has been reached but for the tolerance of the solver.
        let rest = Folded {
            state: State::at_rest(model),
            targets: Targets::percent(0.0),
            steps: 0,
            residual: 0.0,
            distance: 0.0,
            ..exact.clone()
        };
        let mut states = vec![rest];
        states.extend(self.opened.into_iter().rev().skip(1));
        let touching = states.len() + self.touching;
        states.extend(self.closing);
        states.push(exact);
        Motion { states, touching, stacking, gap: self.gap, off: self.off, evaluations }
    }
}
