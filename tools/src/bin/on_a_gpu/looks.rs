//! The time of a step, taken between looks at a run under way: it holds neither pipelines nor what is read in the end.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use origami::solve::Progress;

/// Steps before the first look that counts: creases that jump from flat turn so fast at first that angles cost more, and a
/// processor has yet to find its speed.
const WARM_UP: u64 = 200;

/// Looks at a run until it has lasted long enough.
pub(crate) struct Looks {
    first: Option<(u64, Instant)>,
    last: Option<(u64, Instant)>,
    counted: u32,
    lasting: Duration,
    deadline: Instant,
}

impl Looks {
    /// Looks for `lasting` after the first steps, or until `deadline`.
    pub(crate) fn new(lasting: Duration, deadline: Instant) -> Self {
        Self { first: None, last: None, counted: 0, lasting, deadline }
    }

    /// Breaks the run off once it has lasted long enough. Submissions of a GPU are still under way then, so that it has had
    /// something to do at every look.
    pub(crate) fn look(&mut self, progress: Progress) -> ControlFlow<()> {
        self.look_at(progress.step, Instant::now())
    }

    fn look_at(&mut self, step: u64, now: Instant) -> ControlFlow<()> {
        if now >= self.deadline {
            return ControlFlow::Break(());
        }
        // An ensemble tells of one step once for each sheet.
        if step < WARM_UP || self.last.is_some_and(|(last, _)| step <= last) {
            return ControlFlow::Continue(());
        }
        let (_, began) = *self.first.get_or_insert((step, now));
        self.last = Some((step, now));
        self.counted += 1;
        if self.counted >= 2 && now.duration_since(began) >= self.lasting {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// Seconds of one step; `None` where the time was over before there were two looks.
    pub(crate) fn seconds_a_step(&self) -> Option<f64> {
        let ((first, began), (last, ended)) = (self.first?, self.last?);
        (last > first).then(|| ended.duration_since(began).as_secs_f64() / (last - first) as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_steps_and_repeated_looks_do_not_count() {
        let began = Instant::now();
        let at = |milliseconds| began + Duration::from_millis(milliseconds);
        let mut looks = Looks::new(Duration::from_millis(50), at(10_000));
        // Slow at first, then a millisecond a step.
        for (step, time) in [(100, 900), (200, 1000), (200, 1001), (220, 1020), (240, 1040)] {
            assert!(looks.look_at(step, at(time)).is_continue(), "{step}");
        }
        assert!(looks.look_at(260, at(1060)).is_break(), "long enough");
        let each = looks.seconds_a_step().expect("three looks");
        assert!((each - 1e-3).abs() < 1e-9, "{each}");
    }

    #[test]
    fn the_deadline_ends_it_and_one_look_tells_nothing() {
        let began = Instant::now();
        let mut looks = Looks::new(Duration::from_secs(1), began + Duration::from_secs(2));
        assert!(looks.look_at(300, began).is_continue());
        assert!(looks.look_at(400, began + Duration::from_secs(3)).is_break());
        assert_eq!(looks.seconds_a_step(), None);
    }
}
