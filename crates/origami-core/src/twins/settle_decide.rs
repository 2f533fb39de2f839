//! When to stop: an estimate of the distance from the equilibrium, since forces predict it badly.

/// Successive windows that must all look settled: with 3 in place of 5, 14 of 665 claims were wrong in place
/// of 8, for 3 % fewer evaluations.
pub const WINDOWS: u32 = 5;
/// Each must estimate less than this share of the tolerance.
pub const SHARE: f64 = 0.3;
/// One that estimates less than this share counts as two.
pub const SMALL_SHARE: f64 = 0.03;
/// Evaluations before which no state is said to have settled: slow motion does not show in the first short windows.
pub const LEAST: u64 = 160;
/// Evaluations in the shortest window.
pub const SHORTEST: u64 = 20;
/// The share of all evaluations in a longer one.
pub const SHARE_OF_PAST: f64 = 0.05;
/// A move by less than this share of the tolerance that the forces do not feel is rest.
pub const STILL: f64 = 1e-3;

/// What a window came to, over all nodes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Window {
    /// The largest move of a node, in radii.
    pub largest: f64,
    /// The farthest that the force on a node would take it against its creases and corner angles alone, in radii.
    pub least: f64,
    /// The forces at its end times the moves.
    pub ahead: f64,
    /// The change of the forces times the moves.
    pub change: f64,
}

/// The estimated distance from the equilibrium at the end of a window, in radii; infinite where nothing tells.
///
/// Were the energy a parabola along the window's move `dx`, its minimum would lie `|F.dx| / |dx.dF|` moves further on, with
/// F the force at the end and dF its change: the larger of the two distances is the estimate. It is no less than
/// [`Window::least`]: what hardly moves because beams are very stiff, or the step is very short, has not settled.
#[must_use]
pub fn distance(Window { largest, least, ahead, change }: Window, tolerance: f64) -> f64 {
    if largest == 0.0 {
        return least;
    }
    if change == 0.0 {
        // No change of force along a move: nothing tells how far the minimum is.
        return if largest < STILL * tolerance { largest.max(least) } else { f64::INFINITY };
    }
    largest.max(largest * (ahead / change).abs()).max(least)
}

/// Counts evaluations and settled windows at constant targets.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Windows {
    /// Evaluations so far.
    pub evaluations: u64,
    /// The evaluation at which the present window ends.
    pub end: u64,
    /// Settled windows one after the other, up to the last one.
    pub settled: u32,
    /// Evaluations before the last disturbance.
    pub disturbed_at: u64,
    /// Whether the present window began after the last disturbance.
    pub sound: bool,
}

impl Windows {
    /// Whether a window ends with the next evaluation.
    #[must_use]
    pub fn window_ends(&self) -> bool {
        self.evaluations == self.end
    }

    /// Takes note of `interval` evaluations, and of the distance as a share of the tolerance where a window ended that was
    /// `sound`. True when the state has settled.
    pub fn settle_decide(&mut self, interval: u64, share: Option<f64>) -> bool {
        if self.window_ends() {
            self.settled = match share {
                Some(share) if share < SMALL_SHARE => self.settled + 2,
                Some(share) if share < SHARE => self.settled + 1,
                Some(_) => 0,
                None => self.settled,
            };
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of a step count")]
            let window = (SHARE_OF_PAST * (self.evaluations - self.disturbed_at) as f64) as u64;
            self.end += SHORTEST.max(window).next_multiple_of(interval);
            self.sound = true;
        }
        self.evaluations += interval;
        self.has_settled()
    }

    /// Whether the last windows had all settled.
    #[must_use]
    pub fn has_settled(&self) -> bool {
        self.settled >= WINDOWS && self.evaluations > LEAST
    }

    /// Something has changed that the sheet has yet to follow: what it looked like before counts no more. The windows go on
    /// as they are, and become short again.
    pub fn disturb(&mut self) {
        (self.settled, self.sound, self.disturbed_at) = (0, false, self.evaluations);
        self.end = self.end.min((self.evaluations + SHORTEST).next_multiple_of(SHORTEST));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_by_hand() {
        let window = |largest, least, ahead, change| distance(Window { largest, least, ahead, change }, 1e-4);
        assert_eq!(window(2e-3, 1e-3, 0.0, 1.0), 2e-3);
        assert_eq!(window(2e-3, 5e-3, 0.0, 1.0), 5e-3);
        assert_eq!(window(2e-3, 1e-3, 6.0, -1.0), 12e-3, "six moves further on");
        assert_eq!(window(0.0, 4e-3, 0.0, 0.0), 4e-3);
        assert_eq!(window(2e-3, 4e-3, 1.0, 0.0), f64::INFINITY);
        assert_eq!(window(2e-8, 1e-9, 1.0, 0.0), 2e-8, "rest that forces do not feel");
    }

    #[test]
    fn a_disturbance_takes_back_what_was_settled_and_shortens_the_windows() {
        let mut windows = Windows::default();
        let mut settled_at = 0;
        let share = |windows: &Windows| (windows.window_ends() && windows.sound).then_some(0.01);
        for i in 0..10_000 {
            let share = share(&windows);
            if windows.settle_decide(1, share) && settled_at == 0 {
                settled_at = i;
            }
        }
        assert_eq!(settled_at, LEAST);
        windows.disturb();
        let began = windows.evaluations;
        assert!(windows.end - began <= 2 * SHORTEST, "not 5 % of 10 000");
        let mut evaluations = 0;
        while !windows.settle_decide(1, share(&windows)) {
            evaluations += 1;
        }
        assert!((3 * SHORTEST..=5 * SHORTEST).contains(&evaluations), "three windows that count twice: {evaluations}");
    }
}
