//! `--sequence` and `--contact`: the stages of an input, and the way through them.

use std::ops::ControlFlow;
use std::path::Path;

use origami::contact::Contact;
use origami::fold::{Document, Frame};
use origami::layers::FaceOrder;
use origami::model::Model;
use origami::scene::Scene;
use origami::sequence::{SEQUENCE, Sequence, Stage, TIMELINE};
use origami::solve::{
    Backwards, Failed, Folded, NotBackwards, PathFailed, Progress, Relax, SequenceFailed, State, Stop, Touching,
    fold_sequence,
};
use origami::{CreasePattern, Error};

use crate::args::SequenceSource;
use crate::report::{ContactFacts, MotionFacts};

/// A sequence and the frame that its numbers are of.
pub(super) struct Order {
    sequence: Sequence,
    frame: Frame,
    /// The file beside the input.
    beside: Option<String>,
}

/// Why a way ended early.
pub(super) struct Ended {
    /// The states before.
    pub(super) states: Vec<Folded>,
    /// The percentage that it was on its way to; NaN in a sequence.
    pub(super) percent: f64,
    /// Of a solver; else there is no way.
    pub(super) failed: Option<Box<Failed>>,
    /// All of it, for a person.
    pub(super) message: String,
}

impl From<PathFailed> for Ended {
    fn from(failed: PathFailed) -> Self {
        let message = failed.to_string();
        Self { states: failed.states, percent: failed.percent, failed: Some(Box::new(failed.failed)), message }
    }
}

impl From<SequenceFailed> for Ended {
    fn from(failed: SequenceFailed) -> Self {
        let message = failed.to_string();
        let states = failed.states.into_iter().map(|reached| reached.folded).collect();
        Self { states, percent: f64::NAN, failed: Some(Box::new(failed.failed)), message }
    }
}

impl From<NotBackwards> for Ended {
    fn from(why: NotBackwards) -> Self {
        let message = format!("--backwards: {why}");
        let failed = if let NotBackwards::Failed(failed) = why { Some(Box::new(failed)) } else { None };
        Self { states: Vec::new(), percent: 100.0, failed, message }
    }
}

impl Order {
    /// The sequence that is asked for, of a document whose pattern is in frame `index`.
    pub(super) fn read(
        source: &SequenceSource,
        document: &Document,
        (index, percent): (usize, f64),
    ) -> Result<Self, Error> {
        let frame = document.frame(index)?;
        let (sequence, beside) = match source {
            SequenceSource::Own => {
                let own = Sequence::in_frame(&frame)?;
                let own = own.map_or_else(|| Sequence::of_timeline(&frame, percent), |own| Ok(Some(own)))?;
                let none = || {
                    let expected = format!("`{SEQUENCE}` or `{TIMELINE}`");
                    Error::invalid("--sequence own", "the file has no sequence", expected)
                };
                (own.ok_or_else(none)?, None)
            }
            SequenceSource::Frames => (Sequence::of_frames(document, index)?, None),
            SequenceSource::File(path) => {
                let name = path.display().to_string();
                (beside(path).map_err(|error| in_file(error, &name))?.with_groups_of(&frame)?, Some(name))
            }
        };
        Ok(Self { sequence, frame, beside })
    }

    /// Its stages for a sheet.
    pub(super) fn stages(&self, pattern: &CreasePattern, model: &Model) -> Result<Vec<Stage>, Error> {
        let stages = self.sequence.stages(&self.frame, pattern, model);
        stages.map_err(|error| self.beside.iter().fold(error, |error, name| in_file(error, name)))
    }
}

fn beside(path: &Path) -> Result<Sequence, Error> {
    let bytes = std::fs::read(path).map_err(|source| Error::Io { path: path.display().to_string(), source })?;
    Sequence::from_slice(&bytes)
}

/// The error with the file that it is in.
fn in_file(error: Error, name: &str) -> Error {
    match error {
        Error::Invalid(invalid) => {
            Error::new(invalid.code, format!("{name}: {}", invalid.place), invalid.problem, invalid.expected)
        }
        other => other,
    }
}

/// The states of a way, and what is told of each.
#[derive(Default)]
pub(super) struct Gone {
    pub(super) states: Vec<Folded>,
    /// Of a sequence the step that each shows.
    pub(super) steps: Vec<String>,
    /// Under contact what that did.
    pub(super) touches: Vec<ContactFacts>,
    /// Which face lies on which in the last, where that is known and its positions do not tell it.
    pub(super) orders: Option<Vec<FaceOrder>>,
    /// Of a motion that was found backwards.
    pub(super) motion: Option<MotionFacts>,
}

/// Goes through `stages`, under contact or without.
pub(super) fn in_steps(
    model: &Model,
    solver: (&Relax, Option<Contact>),
    start: &State,
    (stages, frames): (&[Stage], u32),
    observe: &mut dyn FnMut(usize, Progress) -> ControlFlow<()>,
) -> Result<Gone, Ended> {
    let mut gone = Gone::default();
    for reached in fold_sequence(model, solver, start, (stages, frames), observe)? {
        let name = &stages[reached.stage].name;
        let part = (reached.share * f64::from(frames)).round();
        gone.steps.push(if frames > 1 { format!("{name}, {part}/{frames}") } else { name.clone() });
        let blocked = reached.folded.stop == Stop::Blocked;
        gone.touches.extend(reached.touch.map(|touch| ContactFacts::new(model, &touch, blocked, None)));
        gone.states.push(reached.folded);
    }
    Ok(gone)
}

/// Finds the motion to the flat-folded state from there.
pub(super) fn backwards(
    model: &Model,
    (relax, contact): (&Relax, Contact),
    stages: u32,
    observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Gone, Ended> {
    let motion = Backwards { relax: relax.clone(), contact }.fold(model, stages, observe)?;
    let facts = MotionFacts::from(&motion);
    Ok(Gone { states: motion.states, orders: Some(motion.stacking.faces), motion: Some(facts), ..Gone::default() })
}

/// Folds to each percentage in turn under contact, by what `solver` makes, which is told whether the sheet goes on, off every
/// symmetry.
pub(super) fn in_contact(
    model: &Model,
    solver: &dyn Fn(bool) -> Box<dyn Touching>,
    start: &State,
    percents: &[f64],
    observe: &mut dyn FnMut(usize, Progress) -> ControlFlow<()>,
) -> Result<Gone, Ended> {
    let (mut gone, mut from, mut goes_on) = (Gone::default(), 0.0, false);
    for (number, &percent) in percents.iter().enumerate() {
        let before = gone.states.last().map_or(start, |folded| &folded.state);
        let (solver, scene) = (solver(goes_on), Scene::percent(percent));
        let folded = solver.fold_touching(model, before, &scene, &mut |progress| observe(number, progress));
        let (folded, touch) = match folded {
            Ok(folded) => folded,
            Err(failed) => return Err(PathFailed { states: gone.states, percent, failed }.into()),
        };
        if before.targets != folded.state.targets {
            goes_on = true;
        }
        let (blocked, ended) = (folded.stop == Stop::Blocked, folded.stop == Stop::Cancelled);
        gone.touches.push(ContactFacts::new(model, &touch, blocked, Some([from, percent])));
        gone.states.push(folded);
        from = percent;
        if ended {
            break;
        }
    }
    Ok(gone)
}
