//! A relaxation from its first attempt to the state that it hands back.

use std::ops::ControlFlow;

use super::super::attempt::{Attempt, better, or_crushed, steps_of};
#[cfg(feature = "newton")]
use super::super::newton::approach::{Approach, approach};
use super::super::saddle::leave;
use super::super::state::lost_creases;
use super::super::stepper::Limit;
use super::super::{Failed, Folded, Progress, State, Stop};
use super::{Relax, default_ramp};
use crate::kernel::Compute;
use crate::model::Model;
use crate::scene::Scene;

/// Ramps for which an attempt goes on at the final targets with a crease lost: those that come back do so within 1.1.
const LOST_RAMPS: u64 = 2;
/// Ramps for which an attempt goes on at the final targets with a triangle crushed: one may open again.
const CRUSHED_RAMPS: u64 = 10;
/// Sheets of more nodes are not handed over: their factors would take gigabytes.
const LARGEST: usize = 20_000;
/// Factorisations after which Newton's method gives a sheet back to FIRE.
#[cfg(feature = "newton")]
const FACTORISATIONS: u32 = 60;

/// One fold.
pub(super) struct Run<'a> {
    pub(super) relax: &'a Relax,
    pub(super) model: &'a Model,
    pub(super) start: &'a State,
    pub(super) scene: &'a Scene,
}

impl Run<'_> {
    /// Found anew for each attempt: of a large sheet they need much memory.
    fn targets(&self) -> Result<Vec<f64>, Failed> {
        self.scene.targets.of(self.model).map_err(|refusal| Failed::refused(refusal, self.start))
    }

    /// After how many ramps Newton's method takes over, if it does.
    fn hands_over(&self) -> Option<u32> {
        let may = cfg!(feature = "newton") && self.relax.steps.is_none() && self.model.node_count() <= LARGEST;
        self.relax.hand_over.filter(|_| may)
    }

    /// Settles, and leaves the saddles that it settles on.
    pub(super) fn to_a_minimum<R: Compute>(
        &self,
        threads: usize,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        let Self { relax, model, scene, .. } = *self;
        let folded = self.attempts::<R>(threads, observe)?;
        let share = if relax.steps.is_some() { 0.0 } else { relax.saddle_search };
        let again = &mut |off: &State, limit, so_far| {
            let mut observe = |progress: Progress| observe(Progress { step: so_far + progress.step, ..progress });
            let attempt = Attempt { number: 1, ramp: 0, limit, perturbed: false, softening: None };
            Run { start: off, ..*self }.attempt::<R>(attempt, threads, &mut observe)
        };
        Ok(leave((model, scene), folded, (share, relax.max_steps), again))
    }

    fn attempts<R: Compute>(
        &self,
        threads: usize,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        let Self { relax, model, start, scene } = *self;
        let mut attempt = relax.first_attempt((model, scene), start, &self.targets()?);
        let mut kept = self.attempt::<R>(attempt, threads, observe);
        while let Some(next) = relax.next_attempt((model, scene), start, attempt, &kept) {
            attempt = next;
            let so_far = steps_of(&kept);
            let mut observe = |progress: Progress| observe(Progress { step: so_far + progress.step, ..progress });
            let other = self.attempt::<R>(attempt, threads, &mut observe);
            let cancelled = other.as_ref().is_ok_and(|other| other.stop == Stop::Cancelled);
            kept = better((model, scene), kept, other, attempt.number);
            if cancelled {
                return kept.map(|kept| Folded { stop: Stop::Cancelled, ..kept });
            }
        }
        match kept {
            Ok(kept) if kept.stop == Stop::StepLimit && relax.retries() => {
                Ok(self.settle::<R>(kept, relax.max_steps, threads, observe))
            }
            kept if relax.retries() => or_crushed((model, scene), kept, attempt.number),
            kept => kept,
        }
    }

    /// Goes on with a state at hand until it has settled, up to `limit` evaluations in all: by Newton's method first, if it is
    /// handed over to, and always by FIRE, which has the last word.
    fn settle<R: Compute>(
        &self,
        kept: Folded,
        limit: u64,
        threads: usize,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Folded {
        let Self { relax, model, scene, .. } = *self;
        if kept.steps >= limit {
            return kept;
        }
        let kept = self.hand_over(kept, limit, observe);
        let left = limit.saturating_sub(kept.steps);
        if left == 0 || kept.stop == Stop::Cancelled {
            return kept;
        }
        let (state, steps) = (&kept.state, kept.steps);
        let way = (scene, state.targets.clone(), 0, None);
        let mut stepper = relax.stepper::<R>((model, state), state.positions.clone(), way, threads);
        let crushed = Some(CRUSHED_RAMPS * u64::from(default_ramp(model)));
        let mut observe = |progress: Progress| observe(Progress { step: steps + progress.step, ..progress });
        let limit = Limit { steps: left, all: false, crushed, lost: None, crawls: None };
        // A state at hand is finite: that it diverges from there does not take it away.
        let Ok(stop) = stepper.run((model, state), limit, &mut observe) else { return kept };
        let settled = stepper.into_folded(model, scene, scene.targets.clone(), stop);
        let Folded { attempts, factorisations, .. } = kept;
        Folded { steps: steps + settled.steps, attempts, factorisations, ..settled }
    }

    /// Newton's method from a state on which FIRE crawls: downhill, towards rest.
    #[cfg(feature = "newton")]
    fn hand_over(&self, kept: Folded, limit: u64, observe: &mut dyn FnMut(Progress) -> ControlFlow<()>) -> Folded {
        let Self { relax, model, scene, .. } = *self;
        let Folded { steps, distance, stop, .. } = kept;
        let mut watch = |step| observe(Progress { step: steps + step, ramp: 1.0, distance });
        let limits = (relax.tolerance, FACTORISATIONS, limit.saturating_sub(steps));
        let approached = self.hands_over().and_then(|_| approach((model, scene), &kept.state, limits, &mut watch));
        match approached {
            None => kept,
            Some(Approach { state, cancelled, factorisations, evaluations }) => Folded {
                state,
                steps: steps + evaluations,
                factorisations: kept.factorisations + factorisations,
                stop: if cancelled { Stop::Cancelled } else { stop },
                ..kept
            },
        }
    }

    /// Without Newton's method FIRE goes on.
    #[cfg(not(feature = "newton"))]
    #[expect(clippy::unused_self, reason = "it is that of a build with the feature")]
    fn hand_over(&self, kept: Folded, _: u64, _: &mut dyn FnMut(Progress) -> ControlFlow<()>) -> Folded {
        kept
    }

    fn attempt<R: Compute>(
        &self,
        attempt: Attempt,
        threads: usize,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        let Self { relax, model, start, scene } = *self;
        let targets = self.targets()?;
        let positions = relax.of_attempt(attempt).first_positions(model, start, scene, &targets);
        let mut stepper =
            relax.stepper::<R>((model, start), positions, (scene, targets, attempt.ramp, attempt.softening), threads);
        let ramps = |count: u64| count * u64::from(default_ramp(model));
        let crushed = relax.steps.is_none().then(|| ramps(CRUSHED_RAMPS));
        let lost = relax.retries().then(|| ramps(LOST_RAMPS));
        let crawls = self.hands_over().map(|count| ramps(u64::from(count)));
        let limit = Limit { steps: attempt.limit, all: relax.steps.is_some(), crushed, lost, crawls };
        let stop = stepper.run((model, start), limit, observe)?;
        let gave_up = stop == Stop::StepLimit && stepper.steps < attempt.limit;
        let is_lost = || lost.is_some() && lost_creases(&stepper.state.fold_angles, stepper.ramp.asked()) > 0;
        let crawls = gave_up && !is_lost();
        let folded = stepper.into_folded(model, scene, scene.targets.clone(), stop);
        Ok(if crawls { self.settle::<R>(folded, attempt.limit, threads, observe) } else { folded })
    }
}
