//! Into how many parts a pass is cut: one for each thread, as long as that is faster than one thread alone.
//!
//! Where other processes hold the cores, a thread that waits for the others loses time. Nothing but a clock tells, and as no
//! bit depends on the number of parts, a clock may: now and then a few steps are taken the other way, and the faster way
//! stays.

use std::time::{Duration, Instant};

const STAY: Duration = Duration::from_millis(200);
/// And at least for so many steps: of very large sheets a single one is on trial.
const STAY_STEPS: u32 = 10;
/// How long the other way is tried: some of the slices of time that processes get in turn.
const TRIAL: Duration = Duration::from_millis(20);

/// How the passes of one sheet are shared out.
#[derive(Clone, Debug)]
pub(super) struct Team {
    threads: usize,
    alone: bool,
    /// Time for each step in the way before, while the other is on trial.
    trial: Option<f64>,
    began: Option<Instant>,
    steps: u32,
    /// How long it goes on in one way before the other is tried.
    stay: Duration,
}

impl Team {
    pub(super) fn new(threads: usize) -> Self {
        Self { threads, alone: false, trial: None, began: None, steps: 0, stay: STAY }
    }

    /// Of so many threads, whatever the clock says.
    #[cfg(test)]
    pub(super) fn steady(threads: usize) -> Self {
        Self { stay: Duration::MAX, ..Self::new(threads) }
    }

    pub(super) fn parts(&self) -> usize {
        if self.alone { 1 } else { self.threads }
    }

    /// Before each step.
    pub(super) fn step(&mut self) {
        if self.threads > 1 {
            self.step_at(Instant::now());
        }
    }

    fn step_at(&mut self, now: Instant) {
        let began = *self.began.get_or_insert(now);
        let passed = now - began;
        let goes_on = match self.trial {
            Some(_) => passed < TRIAL,
            None => passed < self.stay || self.steps < STAY_STEPS,
        };
        if goes_on {
            self.steps += 1;
            return;
        }
        let each = passed.as_secs_f64() / f64::from(self.steps);
        match self.trial.take() {
            // Its way was no better: back to the one before.
            Some(before) if each >= before => self.alone = !self.alone,
            Some(_) => {}
            None => {
                self.trial = Some(each);
                self.alone = !self.alone;
            }
        }
        (self.began, self.steps) = (Some(now), 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The share of time that three threads work together, where a step takes so many microseconds alone and together.
    fn share_together(alone: u64, together: u64) -> f64 {
        let (mut team, mut now) = (Team::new(3), Instant::now());
        let (mut in_all, mut of_team) = (0, 0);
        for _ in 0..10_000 {
            team.step_at(now);
            let took = if team.parts() == 3 { together } else { alone };
            in_all += took;
            of_team += if team.parts() == 3 { took } else { 0 };
            now += Duration::from_micros(took);
        }
        of_team as f64 / in_all as f64
    }

    #[test]
    fn the_faster_way_is_taken_but_for_trials() {
        assert!((0.9..0.95).contains(&share_together(1000, 500)));
        assert!((0.05..0.15).contains(&share_together(1000, 1500)));
        assert!((0.05..0.15).contains(&share_together(100_000, 120_000)), "steps longer than a trial");
    }

    #[test]
    fn it_goes_back_where_the_other_cores_are_taken_and_free_again() {
        let (mut team, mut now) = (Team::new(2), Instant::now());
        for (together, parts) in [(500, 2), (2000, 1), (500, 2)] {
            for _ in 0..1000 {
                team.step_at(now);
                now += Duration::from_micros(if team.parts() == 2 { together } else { 1000 });
            }
            while team.trial.is_some() {
                team.step_at(now);
                now += Duration::from_micros(if team.parts() == 2 { together } else { 1000 });
            }
            assert_eq!(team.parts(), parts, "{together} us together");
        }
    }

    #[test]
    fn one_thread_is_alone_without_a_clock() {
        let mut team = Team::new(1);
        team.step();
        assert!(team.began.is_none() && team.parts() == 1);
    }
}
