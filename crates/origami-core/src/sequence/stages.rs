//! What a sequence asks of a sheet: stages, one after the other, in each of which some creases move.

use super::Sequence;
use super::read::{Ease, Mode, Step, To};
use super::select::{self, At, Sheet};
use crate::error::Error;
use crate::fold::Frame;
use crate::ids::{CreaseId, EdgeId};
use crate::model::Model;
use crate::pattern::CreasePattern;

/// A held crease is so many times as stiff as it is by itself.
const HELD: f64 = 10.0;
/// Straight pieces that an eased way is made of.
const PIECES: u32 = 8;

/// The steps that run at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// The names of its steps, joined by commas; `step 3` where the first has none.
    pub name: String,
    /// The number of its first step, from 0.
    pub first_step: usize,
    /// How long it takes, as a multiple of the solver's own ramp.
    pub duration: f64,
    /// Whether the sheet comes to rest at its end.
    pub settle: bool,
    moves: Vec<Move>,
}

/// What one crease does in a stage.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Move {
    edge: EdgeId,
    crease: CreaseId,
    goal: Goal,
    span: [f64; 2],
    ease: Ease,
    /// The step that asks for it.
    step: usize,
}

/// Where a crease goes.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Goal {
    /// To an angle, in radians.
    Angle(f64),
    Free,
    Hold,
}

/// How stiff creases are at present, as multiples of what they are by themselves; by crease.
#[derive(Clone, Debug, PartialEq)]
pub struct Stiffness(Vec<f64>);

impl Stiffness {
    /// All creases as they are.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        Self(vec![1.0; model.creases.len()])
    }

    /// Whether a crease is free.
    #[must_use]
    pub fn is_free(&self, crease: CreaseId) -> bool {
        self.0[crease.index()] == 0.0
    }

    /// The model with its creases so stiff; `None` where that is the model itself.
    #[must_use]
    pub fn model(&self, model: &Model) -> Option<Model> {
        if self.0.iter().all(|factor| *factor == 1.0) {
            return None;
        }
        let mut own = model.clone();
        own.creases.iter_mut().zip(&self.0).for_each(|(crease, factor)| crease.stiffness *= factor);
        Some(own)
    }
}

impl Sequence {
    /// What this asks of a sheet, whose `pattern` was made from `frame`.
    ///
    /// # Errors
    /// [`Error::Invalid`] that names the step and the crease: an edge that is not there or has no spring to be driven, a
    /// selection of nothing, a crease that two steps ask for at one time.
    pub fn stages(&self, frame: &Frame, pattern: &CreasePattern, model: &Model) -> Result<Vec<Stage>, Error> {
        let sheet = Sheet { pattern, frame, model };
        let mut stages: Vec<Stage> = Vec::new();
        for (index, step) in self.steps.iter().enumerate() {
            let at = At { index, step };
            let moves = moves(self, at, sheet)?;
            match stages.last_mut().filter(|_| step.beside()) {
                Some(stage) => stage.take_beside(at, moves)?,
                None => {
                    let name = if step.name.is_empty() { format!("step {}", index + 1) } else { step.name.clone() };
                    let Step { duration, settle, .. } = *step;
                    stages.push(Stage { name, first_step: index, duration, settle, moves });
                }
            }
        }
        Ok(stages)
    }
}

/// What the creases of a step do.
fn moves(sequence: &Sequence, at: At<'_>, sheet: Sheet<'_>) -> Result<Vec<Move>, Error> {
    let At { index, step } = at;
    let mut moves = Vec::new();
    for edge in select::edges(sequence, at, sheet)? {
        let Some(crease) = sheet.model.crease_of(edge) else {
            // What has no spring is free already.
            if step.mode == Mode::Free {
                continue;
            }
            let problem = format!("edge {} has no crease spring", edge.0);
            return Err(at.wrong(problem, "a mountain, a valley or a flat crease"));
        };
        let full = sheet.model.creases[crease.index()].full_target;
        let goal = match (step.mode, &step.to) {
            (Mode::Free, _) => Goal::Free,
            (Mode::Hold, _) | (Mode::Drive, None) => Goal::Hold,
            (Mode::Drive, Some(To::Degrees(degrees))) => Goal::Angle(degrees.to_radians()),
            (Mode::Drive, Some(To::Pattern)) => Goal::Angle(full),
            (Mode::Drive, Some(To::Percent(percent))) => Goal::Angle(full * percent / 100.0),
            (Mode::Drive, Some(To::Each(degrees))) => match degrees.get(edge.index()).copied().flatten() {
                Some(degrees) => Goal::Angle(degrees.to_radians()),
                None => continue,
            },
        };
        moves.push(Move { edge, crease, goal, span: [step.start, step.end], ease: step.ease, step: index });
    }
    Ok(moves)
}

impl Stage {
    /// One more step at the same time.
    fn take_beside(&mut self, at: At<'_>, moves: Vec<Move>) -> Result<(), Error> {
        for own in &moves {
            let overlaps = |other: &&Move| {
                other.crease == own.crease && own.span[0] < other.span[1] && other.span[0] < own.span[1]
            };
            if let Some(other) = self.moves.iter().find(overlaps) {
                let problem = format!("edge {} is asked for by step {} at the same time", own.edge.0, other.step + 1);
                return Err(at.wrong(problem, "steps one after the other, or shares that do not overlap"));
            }
        }
        if !at.step.name.is_empty() {
            self.name = format!("{}, {}", self.name, at.step.name);
        }
        self.duration = self.duration.max(at.step.duration);
        self.settle &= at.step.settle;
        self.moves.extend(moves);
        Ok(())
    }

    /// Where its way is broken into straight pieces: ascending shares of the stage above 0, the last is 1. Shares of
    /// `frames` even parts are among them, at which the sheet is to be shown.
    #[must_use]
    pub fn shares(&self, frames: u32) -> Vec<f64> {
        let frames = frames.max(1);
        let mut shares: Vec<f64> = (1..=frames).map(|i| f64::from(i) / f64::from(frames)).collect();
        for Move { span: [start, end], ease, goal, .. } in &self.moves {
            let pieces = if *ease == Ease::Smooth && matches!(goal, Goal::Angle(_)) { PIECES } else { 1 };
            shares.extend((0..=pieces).map(|i| start + (end - start) * f64::from(i) / f64::from(pieces)));
        }
        shares.retain(|share| *share > 0.0 && *share <= 1.0);
        shares.sort_unstable_by(f64::total_cmp);
        // Thirds of tenths are not thirtieths to the last bit.
        shares.dedup_by(|later, earlier| *later - *earlier < 1e-9);
        shares
    }

    /// Begins the stage: creases lose their springs, are held or are driven again. `targets` and `angles` are by crease, in
    /// radians, as they are asked for and as they are; those of held creases, and of creases that were free, begin where the
    /// sheet is.
    ///
    /// # Panics
    /// If there are fewer of either than creases.
    pub fn begin(&self, stiffness: &mut Stiffness, targets: &mut [f64], angles: &[f64]) {
        for Move { crease, goal, .. } in &self.moves {
            let crease = crease.index();
            let (factor, reached) = match goal {
                Goal::Angle(_) => (1.0, stiffness.0[crease] == 0.0),
                Goal::Free => (0.0, false),
                Goal::Hold => (HELD, true),
            };
            stiffness.0[crease] = factor;
            if reached {
                targets[crease] = angles[crease];
            }
        }
    }

    /// The targets at a share of the stage, which began with `before`; by crease, in radians.
    ///
    /// # Panics
    /// If there are fewer of these than creases.
    #[must_use]
    pub fn targets(&self, before: &[f64], share: f64) -> Vec<f64> {
        let mut targets = before.to_vec();
        let mut moves: Vec<&Move> = self.moves.iter().collect();
        // A crease that moves twice goes on from where its first way ends.
        moves.sort_by(|a, b| a.span[0].total_cmp(&b.span[0]));
        for Move { crease, goal, span: [start, end], ease, .. } in moves {
            let Goal::Angle(angle) = goal else { continue };
            let s = ((share - start) / (end - start)).clamp(0.0, 1.0);
            let way = match ease {
                Ease::Linear => s,
                Ease::Smooth => s * s * (3.0 - 2.0 * s),
            };
            let target = &mut targets[crease.index()];
            // The end is the angle itself, without rounding.
            *target = if way >= 1.0 { *angle } else { *target + (angle - *target) * way };
        }
        targets
    }

    /// The edges of the pattern that it asks for, in order.
    #[must_use]
    pub fn edges(&self) -> Vec<EdgeId> {
        let mut edges: Vec<EdgeId> = self.moves.iter().map(|own| own.edge).collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }
}
