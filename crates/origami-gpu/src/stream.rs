//! Sheets that pass through an engine: who has ended makes room for the next, while the others go on.

use std::collections::VecDeque;
use std::ops::ControlFlow;

use origami_core::solve::{Failed, Folded, Instance, Progress};

use crate::engine::Engine;
use crate::error::GpuError;
use crate::layout::{Control, NONE};
use crate::leaving::Leaving;
use crate::mapped::Reading;
use crate::plan::batch;
use crate::run::{AHEAD, Beginning, Ending};

/// Steps between two times at which seats are taken. A sheet counts its steps from 0; what happens every so many steps then
/// happens at the same ones as where it is alone.
const REFILL: u64 = 100;

/// The sheets that are to pass through, each under a number of its own.
pub(crate) trait Sheets<'m> {
    /// The next; after `None` there may be others again once one has ended.
    fn next(&mut self) -> Option<(usize, Beginning<'m>)>;

    /// Where one stands. Who breaks one off breaks off all.
    fn look(&mut self, sheet: usize, control: &Control) -> ControlFlow<()>;

    /// Where one has ended. Where this breaks nothing more is done.
    fn end(&mut self, sheet: usize, ending: Ending) -> ControlFlow<()>;
}

/// Instances that are to be folded, who watches them, and who takes what each comes to: both are told their places.
pub(crate) struct Asked<'r, 'm> {
    pub(crate) instances: &'r [&'r Instance<'m>],
    pub(crate) observe: &'r mut dyn FnMut(usize, Progress) -> ControlFlow<()>,
    /// Where it breaks nothing more is done.
    pub(crate) take: &'r mut dyn FnMut(usize, Result<Folded, Failed>) -> ControlFlow<()>,
}

/// A sheet that has an instance of the engine's.
#[derive(Clone, Copy, Debug)]
struct Seat {
    sheet: usize,
    /// The stream's step at which it began.
    since: u64,
    /// And the one at which it reaches its limit.
    until: u64,
}

struct Stream<'e> {
    engine: &'e Engine,
    seats: Vec<Option<Seat>>,
    /// Steps that have been submitted.
    step: u64,
    /// Submissions that have not been looked at, with the steps at their ends.
    under_way: VecDeque<(u64, Reading<Control>)>,
    leaving: Option<(Vec<usize>, Leaving)>,
}

impl Engine {
    /// Runs sheets to their ends, as many at once as it has instances. Each comes to the bits that it comes to alone.
    ///
    /// # Errors
    /// What the device says; sheets that have not ended by then do not.
    pub(crate) fn stream(&self, sheets: &mut dyn Sheets<'_>) -> Result<(), GpuError> {
        let seats = vec![None; self.instances];
        let mut stream = Stream { engine: self, seats, step: 0, under_way: VecDeque::new(), leaving: None };
        loop {
            stream.take_seats(sheets)?;
            if stream.is_empty() {
                return Ok(());
            }
            let goes_on = stream.submit()?;
            // While the GPU has something to do.
            if stream.hand_over(sheets)?.is_break() {
                return Ok(());
            }
            if (!goes_on || stream.under_way.len() > AHEAD) && stream.look(sheets)?.is_break() {
                return stream.break_off(sheets);
            }
        }
    }
}

impl Stream<'_> {
    fn is_empty(&self) -> bool {
        self.under_way.is_empty() && self.leaving.is_none() && self.taken() == 0
    }

    /// Instances up to the last that is taken.
    fn taken(&self) -> usize {
        self.seats.iter().rposition(Option::is_some).map_or(0, |last| last + 1)
    }

    /// The next step at which a sheet is at its limit; `None` where all are.
    fn until(&self) -> Option<u64> {
        self.seats.iter().flatten().map(|seat| seat.until).filter(|until| *until > self.step).min()
    }

    /// Lets sheets begin where there is room. Where time steps are renewed, which happens to all but those at their first
    /// step, they begin together.
    fn take_seats(&mut self, sheets: &mut dyn Sheets<'_>) -> Result<(), GpuError> {
        if self.is_empty() {
            self.step = 0;
        } else if !self.step.is_multiple_of(REFILL) || self.engine.renews_time_step() || self.until().is_none() {
            return Ok(());
        }
        // Neighbours are written together.
        let (mut first, mut beginnings) = (0, Vec::new());
        for i in 0..self.seats.len() {
            if self.seats[i].is_some() {
                self.engine.load(first, &std::mem::take(&mut beginnings))?;
                continue;
            }
            let Some((sheet, beginning)) = sheets.next() else { break };
            if beginnings.is_empty() {
                first = i;
            }
            // Steps are counted in 32 bits.
            let limit = beginning.limit.min(u64::from(u32::MAX));
            let until = self.step + self.engine.whole_dispatches(limit);
            self.seats[i] = Some(Seat { sheet, since: self.step, until });
            beginnings.push(beginning);
        }
        self.engine.load(first, &beginnings)
    }

    /// Takes all sheets a batch farther, or as far as the next limit; whether one of them goes on.
    fn submit(&mut self) -> Result<bool, GpuError> {
        let Some(until) = self.until() else {
            // Who was to take no step at all is not looked at.
            if self.under_way.is_empty() && self.leaving.is_none() {
                self.leave(|_| Some(None), false, false)?;
            }
            return Ok(false);
        };
        let taken = self.taken();
        let batch = batch(self.engine.variant.nodes * taken);
        let next = ((self.step / batch + 1) * batch).min(until);
        self.under_way.push_back((next, self.engine.submit(taken, self.step, next)?));
        self.step = next;
        // Who is at its limit stands still while others go on.
        if self.until().is_some() {
            let at_limit = |i: &usize| self.seats[*i].is_some_and(|seat| seat.until == next);
            let at_limit = (0..taken).filter(at_limit);
            self.engine.gpu.scoped(|| at_limit.for_each(|i| self.engine.stand_still(i)))?;
        }
        Ok(true)
    }

    /// Looks at where the sheets stood at the end of the oldest submission.
    fn look(&mut self, sheets: &mut dyn Sheets<'_>) -> Result<ControlFlow<()>, GpuError> {
        let Some((at, reading)) = self.under_way.pop_front() else { return Ok(ControlFlow::Continue(())) };
        let controls = reading.wait(&self.engine.gpu)?;
        let mut goes_on = ControlFlow::Continue(());
        for (seat, control) in self.seats.iter().zip(&controls) {
            let Some(seat) = seat.filter(|seat| seat.since < at) else { continue };
            if sheets.look(seat.sheet, control).is_break() {
                goes_on = ControlFlow::Break(());
            }
            self.engine.check_steps(std::slice::from_ref(control), at - seat.since)?;
        }
        if goes_on.is_continue() {
            let seats = self.seats.clone();
            let ended = |i: usize| {
                let (seat, control) = (seats[i]?, controls.get(i)?);
                let ended = control.stop != 0 || control.bad_node != NONE || at >= seat.until;
                // At its limit it stands still for the host's word, which is no part of how it ended.
                (ended && seat.since < at).then(|| (at >= seat.until).then_some(*control))
            };
            let diverged = controls.iter().any(|control| control.bad_node != NONE);
            self.leave(ended, false, diverged)?;
        }
        Ok(goes_on)
    }

    /// Lets sheets go, from the instances for which `who` says so, with the control block where it is known. `diverged`:
    /// whether one of them may have.
    fn leave(
        &mut self,
        who: impl Fn(usize) -> Option<Option<Control>>,
        cancelled: bool,
        diverged: bool,
    ) -> Result<(), GpuError> {
        let seats = self.seats.iter_mut().enumerate().filter(|(i, seat)| seat.is_some() && who(*i).is_some());
        let (sheets, leaving): (Vec<_>, Vec<_>) =
            seats.filter_map(|(i, seat)| Some((seat.take()?.sheet, (i, who(i).flatten())))).unzip();
        if !sheets.is_empty() {
            self.leaving = Some((sheets, Leaving::new(self.engine, &leaving, cancelled, diverged)?));
        }
        Ok(())
    }

    fn hand_over(&mut self, sheets: &mut dyn Sheets<'_>) -> Result<ControlFlow<()>, GpuError> {
        let Some((numbers, leaving)) = self.leaving.take() else { return Ok(ControlFlow::Continue(())) };
        let endings = leaving.wait(self.engine)?;
        Ok(numbers.into_iter().zip(endings).try_for_each(|(sheet, ending)| sheets.end(sheet, ending)))
    }

    /// Ends all sheets where they are; those that have not begun, where they would.
    fn break_off(mut self, sheets: &mut dyn Sheets<'_>) -> Result<(), GpuError> {
        for (_, reading) in std::mem::take(&mut self.under_way) {
            reading.wait(&self.engine.gpu)?;
        }
        self.leave(|_| Some(None), true, true)?;
        if self.hand_over(sheets)?.is_break() {
            return Ok(());
        }
        while let Some((sheet, ending)) = sheets.next().map(|(sheet, beginning)| (sheet, Ending::not_begun(&beginning)))
        {
            if sheets.end(sheet, ending).is_break() {
                break;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use origami_core::generate::BirdBase;
    use origami_core::scene::Scene;
    use origami_core::solve::{Integrator, Stop, TimeStep, time_step, unwatched};
    use origami_core::{Dynamics, Material, Model, Relax, Solver, State, twins};

    use super::*;
    use crate::ensemble::in_runs;
    use crate::method::Method;
    use crate::plan::CHECK_INTERVAL;
    use crate::testing::gpu;
    use crate::{AdapterChoice, Dispatch, Gpu, GpuMethod};

    #[test]
    fn whoever_begins_later_begins_as_at_the_first_step() {
        let often = [CHECK_INTERVAL, twins::fire_update::RENEWAL, batch(0), batch(1 << 30)];
        assert!(often.iter().all(|steps| REFILL.is_multiple_of(*steps)), "{often:?}");
    }

    /// One soft, one stiff: a time step that holds for the first is too long for the other.
    fn birds() -> Vec<Model> {
        let materials = [20.0, 2000.0].map(|ea| Material { ea, ..Material::default() });
        Model::of_each(&BirdBase::default().pattern().expect("a pattern"), &materials).expect("models")
    }

    fn instances(models: &[Model], stiff: bool) -> Vec<Instance<'_>> {
        let percents = [100.0, 0.0, 90.0, 5.0, 40.0, 97.5, 20.0, 60.0];
        let instance = |(i, percent): (usize, f64)| {
            let model = &models[usize::from(stiff && i % 3 == 2)];
            Instance { model, start: State::perturbed(model, 1e-2, i as u64), scene: Scene::percent(percent) }
        };
        percents.into_iter().enumerate().map(instance).collect()
    }

    /// What came, in words, in the order in which it came; and how many had not been looked at by then.
    fn streamed<S: GpuMethod>(
        gpu: &Gpu,
        method: &S,
        dispatch: Dispatch,
        instances: &[Instance<'_>],
        at_once: usize,
    ) -> Vec<(usize, String, usize)> {
        let purpose = method.method().purpose(dispatch, instances.iter().map(|i| i.model));
        let looked_at = Mutex::new(vec![false; instances.len()]);
        let came = Mutex::new(Vec::new());
        let observe = |i: usize, _| {
            looked_at.lock().expect("no panic")[i] = true;
            ControlFlow::Continue(())
        };
        let take = |i: usize, result| {
            let waiting = looked_at.lock().expect("no panic").iter().filter(|looked_at| !**looked_at).count();
            came.lock().expect("no panic").push((i, format!("{result:?}"), waiting));
            ControlFlow::Continue(())
        };
        assert!(in_runs(gpu, method.method(), purpose, (instances, &observe, &take), |_| at_once).is_continue());
        came.into_inner().expect("no panic")
    }

    /// However many go at once, each comes to what it comes to alone, to the last bit of all that is told of it.
    fn as_alone<S: GpuMethod + Clone>(gpu: &Gpu, method: &S, instances: &[Instance<'_>]) -> Vec<String> {
        let mut told = Vec::new();
        for dispatch in Dispatch::WAYS {
            let solver = gpu.with(method.clone()).dispatch(*dispatch);
            let fold = |i: &Instance<'_>| format!("{:?}", solver.fold(i.model, &i.start, &i.scene, &mut unwatched));
            let alone: Vec<String> = instances.iter().map(fold).collect();
            for at_once in [3, instances.len()] {
                let mut came = streamed(gpu, method, *dispatch, instances, at_once);
                assert_eq!(came.len(), instances.len(), "each comes once");
                let early = came.iter().any(|(.., waiting)| *waiting > 0);
                assert_eq!(
                    early,
                    at_once < instances.len(),
                    "some come while others have not begun: {at_once} at once"
                );
                came.sort_by_key(|(i, ..)| *i);
                for ((_, came, _), alone) in came.iter().zip(&alone) {
                    assert_eq!(came, alone, "{dispatch}, {at_once} at once");
                }
            }
            told = alone;
        }
        told
    }

    #[test]
    fn relaxations_that_settle_at_different_times_end_as_they_do_alone() {
        let Some(gpu) = gpu() else { return };
        let models = birds();
        let of = |told: &[String], stop: Stop| told.iter().filter(|told| told.contains(&format!("{stop:?}"))).count();
        let told = as_alone(&gpu, &Relax { max_steps: 570, ..Relax::default() }, &instances(&models, true));
        assert!(of(&told, Stop::Converged) > 1 && of(&told, Stop::StepLimit) > 1, "some come to their limit");
        let told = as_alone(&gpu, &Relax { steps: Some(130), ..Relax::default() }, &instances(&models, false));
        assert_eq!(of(&told, Stop::StepsDone), told.len());
    }

    #[test]
    fn sheets_that_are_to_take_no_step_come_too() {
        let Some(gpu) = gpu() else { return };
        let (models, still) = (birds(), Relax { steps: Some(0), ..Relax::default() });
        let instances = instances(&models, false);
        let came = streamed(&gpu, &still, Dispatch::Passes, &instances, 3);
        let alone = still.fold(&models[0], &instances[0].start, &instances[0].scene, &mut unwatched).expect("it holds");
        assert_eq!(came.len(), instances.len());
        assert!(came.iter().all(|(_, told, _)| told.contains("StepsDone") && told.contains("steps: 0")));
        assert_eq!((alone.steps, alone.stop), (0, Stop::StepsDone), "as on the processor");
    }

    #[test]
    fn motions_end_as_they_do_alone_whether_they_hold_or_not() {
        let Some(gpu) = gpu() else { return };
        let models = birds();
        let fixed = TimeStep::Fixed(time_step::paper(&models[0]));
        let told = as_alone(
            &gpu,
            &Dynamics { time_step: fixed, steps: Some(250), ..Dynamics::default() },
            &instances(&models, true),
        );
        let diverged = told.iter().filter(|told| told.contains("Diverged")).count();
        assert!(diverged > 0 && diverged < told.len(), "{diverged} diverge");
        let verlet =
            Dynamics { integrator: Integrator::Verlet, tolerance: 1e-2, max_steps: 900, ..Dynamics::default() };
        as_alone(&gpu, &verlet, &instances(&models, false));
        let safe = Dynamics { time_step: TimeStep::Safe, steps: Some(110), ..Dynamics::default() };
        let told = as_alone(&gpu, &safe, &instances(&models, true));
        assert!(told.iter().all(|told| told.starts_with("Ok")), "a safe step holds");
    }

    #[test]
    fn a_lost_device_leaves_what_has_come_and_fails_the_rest() {
        let Some(gpu) = gpu() else { return };
        // One of its own: it is going to be lost.
        let gpu = Gpu::open(&AdapterChoice::Named(gpu.adapter().to_string())).expect("opened before");
        let models = birds();
        let (instances, method) = (instances(&models, false), Relax::default());
        let purpose = Method::Relax(&method).purpose(Dispatch::Passes, models.iter());
        let came = Mutex::new(Vec::new());
        let take = |i: usize, result: Result<Folded, Failed>| {
            came.lock().expect("no panic").push((i, result.is_ok()));
            gpu.device().destroy();
            ControlFlow::Continue(())
        };
        let observe = |_, _| ControlFlow::Continue(());
        assert!(in_runs(&gpu, Method::Relax(&method), purpose, (&instances, &observe, &take), |_| 3).is_continue());
        let mut came = came.into_inner().expect("no panic");
        assert!(came[0].1 && !came[instances.len() - 1].1, "{came:?}");
        came.sort_unstable();
        assert_eq!(came.iter().map(|(i, _)| *i).collect::<Vec<_>>(), (0..instances.len()).collect::<Vec<_>>());
    }

    #[test]
    fn whoever_breaks_it_off_gets_all_as_they_are_and_whoever_takes_no_more_gets_none() {
        let Some(gpu) = gpu() else { return };
        let models = birds();
        let (instances, method) = (instances(&models, false), Relax { steps: Some(5000), ..Relax::default() });
        let purpose = Method::Relax(&method).purpose(Dispatch::Passes, models.iter());
        let taken = Mutex::new(Vec::new());
        let run = |until: usize, take: &(dyn Fn(usize, Result<Folded, Failed>) -> ControlFlow<()> + Sync)| {
            let looks = Mutex::new(0);
            let observe = |_, progress: Progress| {
                assert!(progress.step < 2000, "it did not run on");
                *looks.lock().expect("no panic") += 1;
                if *looks.lock().expect("no panic") == until {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            };
            in_runs(&gpu, Method::Relax(&method), purpose, (&instances, &observe, take), |_| 3)
        };
        let ended = run(7, &|i, result| {
            taken.lock().expect("no panic").push((i, result.expect("it holds")));
            ControlFlow::Continue(())
        });
        assert!(ended.is_continue());
        let mut all = std::mem::take(&mut *taken.lock().expect("no panic"));
        all.sort_by_key(|(i, _)| *i);
        assert_eq!(all.iter().map(|(i, _)| *i).collect::<Vec<_>>(), (0..instances.len()).collect::<Vec<_>>());
        assert!(all.iter().all(|(_, folded)| folded.stop == Stop::Cancelled));
        let steps: Vec<u64> = all.iter().map(|(_, folded)| folded.steps).collect();
        assert!(
            steps[..3].iter().all(|steps| *steps >= 300) && steps[3..].iter().all(|steps| *steps == 0),
            "{steps:?}"
        );

        let ended = run(7, &|i, _| {
            taken.lock().expect("no panic").push((i, all[0].1.clone()));
            ControlFlow::Break(())
        });
        assert!(ended.is_break());
        assert_eq!(taken.lock().expect("no panic").len(), 1);
    }
}
