//! Into how many tasks a pass is cut: some for each thread, as long as that is faster than one thread alone.
//!
//! Where other processes hold the cores, a thread that waits for the others loses time. Nothing but a clock tells, and as no
//! bit depends on the number of tasks, a clock may: a sheet begins on one thread, is soon tried on all, and the faster way
//! stays; now and then a few steps are taken the other way.

use std::time::{Duration, Instant};

/// A thread that is done takes tasks of another one. With one task each it falls asleep while the other works on, and is
/// slow to wake.
const TASKS_PER_THREAD: usize = 8;
/// Steps that do not count: memory is touched for the first time.
const WARM_UP: u32 = 3;
/// How long the first way is kept before the other is tried.
const FIRST: Duration = Duration::from_millis(10);
/// How long the faster way is kept before the other is tried again.
const STAY: Duration = Duration::from_millis(200);
/// The same where the other way was tried in vain again and again.
const LONGEST_STAY: Duration = Duration::from_secs(2);
/// And at least for as long as so many steps take: of very large sheets a single one is on trial.
const STAY_STEPS: u32 = 10;
/// How long the other way is tried: longer than the slices of time that processes get in turn.
const TRIAL: Duration = Duration::from_millis(20);
/// All threads must take less than this share of the time of one: beside a busy neighbour they may look a little faster for
/// the length of a trial. Idle cores make them much faster.
const WORTH: f64 = 0.85;

/// How the passes of one sheet are shared out.
#[derive(Clone, Debug)]
pub(super) struct Parallelism {
    threads: usize,
    alone: bool,
    /// Time for each step in the way before, while the other is on trial.
    trial: Option<f64>,
    began: Option<Instant>,
    steps: u32,
    warm_up: u32,
    /// How long it goes on in one way before the other is tried.
    stay: Duration,
}

impl Parallelism {
    pub(super) fn new(threads: usize) -> Self {
        Self { threads, alone: true, trial: None, began: None, steps: 0, warm_up: WARM_UP, stay: FIRST }
    }

    /// Always shared out among `threads` threads, whatever the clock says.
    #[cfg(test)]
    pub(super) fn steady(threads: usize) -> Self {
        Self { alone: false, stay: Duration::MAX, ..Self::new(threads) }
    }

    /// How many tasks to cut a pass into: 1 while one thread alone is faster.
    pub(super) fn tasks(&self) -> usize {
        if self.alone { 1 } else { TASKS_PER_THREAD * self.threads }
    }

    /// To be called before each step.
    pub(super) fn step(&mut self) {
        if self.threads == 1 {
            return;
        }
        if self.warm_up > 0 {
            self.warm_up -= 1;
            return;
        }
        self.step_at(Instant::now());
    }

    fn step_at(&mut self, now: Instant) {
        let began = *self.began.get_or_insert(now);
        let passed = now - began;
        if passed < if self.trial.is_some() { TRIAL } else { self.stay } {
            self.steps += 1;
            return;
        }
        let each = passed.as_secs_f64() / f64::from(self.steps);
        let longer = Duration::from_secs_f64(each * f64::from(STAY_STEPS));
        if let Some(before) = self.trial.take() {
            let (alone, together) = if self.alone { (each, before) } else { (before, each) };
            let alone_is_better = together >= WORTH * alone;
            // Tried in vain: it stays longer the next time.
            let twice = if alone_is_better == self.alone { Duration::ZERO } else { 2 * self.stay };
            self.stay = twice.clamp(STAY, LONGEST_STAY).max(longer);
            self.alone = alone_is_better;
        } else {
            self.trial = Some(each);
            self.alone = !self.alone;
        }
        (self.began, self.steps) = (Some(now), 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The share of time that three threads work together, where a step takes so many microseconds alone and together.
    fn share_together(alone: u64, together: u64) -> f64 {
        let (mut parallelism, mut now) = (Parallelism::new(3), Instant::now());
        let (mut in_all, mut when_together) = (0, 0);
        for _ in 0..10_000 {
            parallelism.step_at(now);
            let took = if parallelism.tasks() > 1 { together } else { alone };
            in_all += took;
            when_together += if parallelism.tasks() > 1 { took } else { 0 };
            now += Duration::from_micros(took);
        }
        when_together as f64 / in_all as f64
    }

    #[test]
    fn the_faster_way_is_taken_but_for_trials() {
        assert!((0.97..0.995).contains(&share_together(1000, 500)));
        assert!((0.005..0.03).contains(&share_together(1000, 1500)));
        assert!((0.02..0.1).contains(&share_together(100_000, 120_000)), "steps longer than a trial");
    }

    #[test]
    fn it_goes_back_where_the_other_cores_are_taken_and_free_again() {
        let (mut parallelism, mut now) = (Parallelism::new(2), Instant::now());
        for (together, alone) in [(500, false), (2000, true), (500, false)] {
            for _ in 0..6000 {
                parallelism.step_at(now);
                now += Duration::from_micros(if parallelism.tasks() > 1 { together } else { 1000 });
            }
            while parallelism.trial.is_some() {
                parallelism.step_at(now);
                now += Duration::from_micros(if parallelism.tasks() > 1 { together } else { 1000 });
            }
            assert_eq!(parallelism.tasks() == 1, alone, "{together} us together");
        }
    }

    #[test]
    fn one_thread_is_alone_without_a_clock() {
        let mut parallelism = Parallelism::new(1);
        parallelism.step();
        assert!(parallelism.began.is_none() && parallelism.tasks() == 1);
    }
}
