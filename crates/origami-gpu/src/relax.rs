//! Relaxation on a GPU: the core's attempts, each of which passes through the engine.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::ops::ControlFlow;

use origami_core::model::Model;
use origami_core::scene::{Held, Refusal, Scene};
use origami_core::solve::attempt::{Attempt, better, or_crushed, steps_of};
use origami_core::solve::{Failed, Folded, Instance, Progress, Relax, State, Stop};

use crate::engine::Engine;
use crate::error::GpuError;
use crate::layout::Control;
use crate::outcome::{backend, checked, folded, progress};
use crate::purpose::{Dispatch, Purpose};
use crate::run::{Beginning, Ending};
use crate::stream::{Asked, Sheets};
use crate::variant::Scheme;

/// What an engine for a relaxation has to do.
pub(crate) fn purpose<'m>(relax: &Relax, dispatch: Dispatch, mut models: impl Iterator<Item = &'m Model>) -> Purpose {
    Purpose { scheme: Scheme::Relax, safe: false, softens: models.any(|model| softens(relax, model)), dispatch }
}

/// Whether the sheet may be soft on its way: from rest, where nothing but its springs acts.
fn softens(relax: &Relax, model: &Model) -> bool {
    let from_rest = State::at_rest(model);
    relax.first_attempt((model, &Scene::default()), &from_rest, &from_rest.targets).softening.is_some()
}

/// Runs instances until each has made all its attempts.
pub(crate) fn run<'r>(relax: &'r Relax, engine: &Engine, asked: Asked<'r, '_>) {
    let waiting = (0..asked.instances.len()).map(|i| (i, None)).collect();
    let mut attempts = Attempts { relax, asked, waiting, running: BTreeMap::new(), best: BTreeMap::new() };
    if let Err(error) = engine.stream(&mut attempts) {
        attempts.gave_up(&error);
    }
}

/// Instances on their way through their attempts.
struct Attempts<'r, 'm> {
    relax: &'r Relax,
    asked: Asked<'r, 'm>,
    /// Those that are to begin, by their places; without an attempt their first.
    waiting: VecDeque<(usize, Option<Attempt>)>,
    /// Those that are on the GPU, with their targets.
    running: BTreeMap<usize, (Attempt, Vec<f64>)>,
    /// What came of the attempts before, of those that make another.
    best: BTreeMap<usize, Result<Folded, Failed>>,
}

impl<'m> Sheets<'m> for Attempts<'_, 'm> {
    fn next(&mut self) -> Option<(usize, Beginning<'m>)> {
        loop {
            let (i, attempt) = self.waiting.pop_front()?;
            let instance = self.asked.instances[i];
            match targets(instance) {
                Ok(targets) => {
                    let first =
                        || self.relax.first_attempt((instance.model, &instance.scene), &instance.start, &targets);
                    let attempt = attempt.unwrap_or_else(first);
                    let beginning = beginning(self.relax, instance, &targets, attempt);
                    self.running.insert(i, (attempt, targets));
                    return Some((i, beginning));
                }
                Err(refusal) => {
                    // Whoever wants no more is told nothing more.
                    let refused = Err(Failed::refused(refusal, &instance.start));
                    if (self.asked.take)(i, refused).is_break() {
                        self.waiting.clear();
                    }
                }
            }
        }
    }

    fn look(&mut self, i: usize, control: &Control) -> ControlFlow<()> {
        let before = self.best.get(&i).map_or(0, steps_of);
        let own = progress(control);
        (self.asked.observe)(i, Progress { step: before + own.step, ..own })
    }

    fn end(&mut self, i: usize, ending: Ending) -> ControlFlow<()> {
        let Some((attempt, targets)) = self.running.remove(&i) else { return ControlFlow::Continue(()) };
        let instance = self.asked.instances[i];
        let (model, scene, cancelled) = (instance.model, &instance.scene, ending.cancelled);
        let steps_asked = self.relax.steps.is_some();
        let came_to = folded(instance, Held::new(model, scene), targets, steps_asked, &ending, Scheme::Relax);
        let best = match self.best.remove(&i) {
            None => came_to,
            Some(kept) => {
                let broken_off = came_to.as_ref().is_ok_and(|other| other.stop == Stop::Cancelled);
                let best = better((model, scene), kept, came_to, attempt.number);
                if broken_off { best.map(|kept| Folded { stop: Stop::Cancelled, ..kept }) } else { best }
            }
        };
        if !cancelled && let Some(another) = self.relax.next_attempt((model, scene), &instance.start, attempt, &best) {
            self.best.insert(i, best);
            self.waiting.push_front((i, Some(another)));
            return ControlFlow::Continue(());
        }
        let crushed = self.relax.retries() && !cancelled;
        (self.asked.take)(i, if crushed { or_crushed((model, scene), best, attempt.number) } else { best })
    }
}

impl Attempts<'_, '_> {
    /// Every instance that has no result fails for the same reason, with the best state that is known of it.
    fn gave_up(mut self, error: &GpuError) {
        let unfinished: BTreeSet<usize> =
            self.running.keys().copied().chain(self.waiting.iter().map(|(i, _)| *i)).collect();
        for i in unfinished {
            let failed = match self.best.remove(&i) {
                Some(Ok(read)) => backend(error.clone(), &read.state, read.steps),
                _ => backend(error.clone(), &self.asked.instances[i].start, 0),
            };
            if (self.asked.take)(i, Err(failed)).is_break() {
                return;
            }
        }
    }
}

/// What is asked of the creases of an instance, where this can run it.
pub(crate) fn targets(instance: &Instance<'_>) -> Result<Vec<f64>, Refusal> {
    let targets = checked(instance)?;
    instance.scene.check_balance(instance.model)?;
    Ok(targets)
}

/// Where an attempt begins.
pub(crate) fn beginning<'m>(
    relax: &Relax,
    instance: &Instance<'m>,
    targets: &[f64],
    attempt: Attempt,
) -> Beginning<'m> {
    Beginning {
        model: instance.model,
        state: relax.of_attempt(attempt).beginning(instance.model, &instance.start, &instance.scene, targets),
        held: Held::new(instance.model, &instance.scene),
        loads: instance.scene.loads.clone(),
        targets: targets.to_vec(),
        ramp: attempt.ramp,
        softening: attempt.softening,
        limit: attempt.limit,
        tolerance: relax.tolerance,
        stops_when_settled: relax.steps.is_none(),
        time_step: 0.0,
        damping_sum: 0.0,
    }
}
