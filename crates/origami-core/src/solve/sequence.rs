//! A folding sequence, stage after stage.

use std::borrow::Borrow;
use std::ops::ControlFlow;

use super::relax::ramp_between;
use super::{ContactRelax, Failed, Folded, Progress, Relax, Solver, State, Stop, Touch, Touching};
use crate::contact::Contact;
use crate::ids::CreaseId;
use crate::model::Model;
use crate::scene::{Scene, Targets};
use crate::sequence::{Stage, Stiffness};

/// A state of a sequence.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Reached {
    /// The number of its stage, from 0.
    pub stage: usize,
    /// How far that stage has come, above 0 to 1.
    pub share: f64,
    /// The state.
    pub folded: Folded,
    /// How stiff creases were for it.
    pub stiffness: Stiffness,
    /// What contact did on the last piece of the way there; `None` without contact.
    pub touch: Option<Touch>,
}

/// One stage of a sequence did not hold.
#[derive(Clone, Debug, thiserror::Error)]
#[error("in step `{name}`: {failed}")]
pub struct SequenceFailed {
    /// The states before it, all of which held.
    pub states: Vec<Reached>,
    /// The name of the stage.
    pub name: String,
    /// What happened, with the last good state.
    #[source]
    pub failed: Failed,
}

/// Goes through `stages` from `start`, each to the angles that it asks for, as `relax` says, under contact or without. The result has the states at the
/// end of `frames` even parts of each stage, at least the one at its end. `observe` is told the number of the stage and how
/// far its solver has come; where it breaks, the sequence ends with the state at hand.
///
/// A stage whose targets do not rise evenly is folded in straight pieces, and each of them settles, so that what is shown is
/// an equilibrium; one that does not settle ends as soon as its targets have arrived, and says [`Stop::StepsDone`].
/// [`Relax::ramp`] is of a whole stage.
///
/// # Errors
/// [`SequenceFailed`] from the first stage that does not hold, with the states before it.
pub fn fold_sequence(
    model: &Model,
    (relax, contact): (&Relax, Option<Contact>),
    start: &State,
    (stages, frames): (&[Stage], u32),
    observe: &mut dyn FnMut(usize, Progress) -> ControlFlow<()>,
) -> Result<Vec<Reached>, SequenceFailed> {
    let mut run = Steps::new(model, relax, start);
    run.contact = contact;
    for (number, stage) in stages.iter().enumerate() {
        if let Err(failed) = run.fold(stage, (number, frames), &mut |progress| observe(number, progress)) {
            return Err(SequenceFailed { states: run.states, name: stage.name.clone(), failed });
        }
        if run.cancelled() {
            break;
        }
    }
    Ok(run.states)
}

/// A sequence on its way: the state after the stages so far, of a model that is borrowed or shared.
#[derive(Clone, Debug)]
pub struct Steps<M> {
    model: M,
    relax: Relax,
    contact: Option<Contact>,
    state: State,
    stiffness: Stiffness,
    states: Vec<Reached>,
}

impl<M: Borrow<Model>> Steps<M> {
    /// Nothing folded yet.
    #[must_use]
    pub fn new(model: M, relax: &Relax, start: &State) -> Self {
        let stiffness = Stiffness::of(model.borrow());
        Self { model, relax: relax.clone(), contact: None, state: start.clone(), stiffness, states: Vec::new() }
    }

    /// The same under contact: the sheet cannot go through itself.
    #[must_use]
    pub fn with_contact(self, contact: Contact) -> Self {
        Self { contact: Some(contact), ..self }
    }

    /// The states so far.
    #[must_use]
    pub fn states(&self) -> &[Reached] {
        &self.states
    }

    /// Whether who watches broke it off.
    fn cancelled(&self) -> bool {
        self.states.last().is_some_and(|reached| reached.folded.stop == Stop::Cancelled)
    }

    /// One stage more: its number, and in how many parts it is shown.
    ///
    /// # Errors
    /// As the solver.
    pub fn fold(
        &mut self,
        stage: &Stage,
        (number, frames): (usize, u32),
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(), Failed> {
        stage.begin(&mut self.stiffness, &mut self.state.targets, &self.state.fold_angles);
        let own = self.stiffness.model(self.model.borrow());
        let before = self.state.targets.clone();
        let mut from = 0.0;
        for share in stage.shares(frames) {
            let targets = stage.targets(&before, share);
            let (folded, touch) = self.piece(own.as_ref(), (stage, share - from), targets, observe)?;
            from = share;
            let cancelled = folded.stop == Stop::Cancelled;
            self.state = folded.state.clone();
            let part = share * f64::from(frames.max(1));
            if cancelled || (part - part.round()).abs() < 1e-6 {
                self.states.push(Reached { stage: number, share, folded, stiffness: self.stiffness.clone(), touch });
            }
            if cancelled {
                break;
            }
        }
        Ok(())
    }

    /// A straight piece of a stage, of so great a `share` of it.
    fn piece(
        &mut self,
        own: Option<&Model>,
        (stage, share): (&Stage, f64),
        targets: Vec<f64>,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Option<Touch>), Failed> {
        let model = own.unwrap_or_else(|| self.model.borrow());
        let mut relax = self.relax.clone();
        if relax.ramp.is_some() || stage.duration != 1.0 {
            let by_itself = || f64::from(ramp_between(model, self.state.targets.iter().copied(), &targets));
            let ramp = relax.ramp.map_or_else(by_itself, |ramp| f64::from(ramp) * share);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturating")]
            let ramp = (ramp * stage.duration).round() as u32;
            relax.ramp = Some(ramp);
        }
        let moves = targets != self.state.targets;
        let mut arrived = false;
        let scene = Scene::new(Targets::angles(targets));
        let mut watch = |progress: Progress| {
            observe(progress)?;
            arrived = !stage.settle && progress.ramp >= 1.0;
            if arrived { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let (mut folded, touch) = match self.contact {
            None => (relax.fold(model, &self.state, &scene, &mut watch)?, None),
            Some(contact) => {
                let solver = ContactRelax { relax, contact };
                let (folded, touch) = solver.fold_touching(model, &self.state, &scene, &mut watch)?;
                (folded, Some(touch))
            }
        };
        if arrived && folded.stop == Stop::Cancelled {
            folded.stop = Stop::StepsDone;
        }
        // A free crease is asked for nothing.
        let free = (0..model.creases.len()).filter(|crease| self.stiffness.is_free(CreaseId::new(*crease)));
        free.for_each(|crease| folded.state.targets[crease] = folded.state.fold_angles[crease]);
        if moves {
            // The sheet is off every symmetry from its first move on.
            self.relax.perturbation = 0.0;
        }
        Ok((folded, touch))
    }
}
