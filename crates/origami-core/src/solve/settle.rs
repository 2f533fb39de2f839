//! When to stop: an estimate of the distance from the equilibrium, since forces predict it badly.

use glam::DVec3;

use super::row_sums::soft_sums;
use crate::model::Model;

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

/// Watches a state over windows of evaluations at constant targets.
///
/// `s` is the largest move of a node in a window. Were the energy a parabola along the window's move `dx`, its minimum
/// would lie `|F.dx| / |dx.dF|` moves further on, with F the force at the end and dF its change: the larger of the two
/// distances is the estimate. It is no less than the way that the force on a node would take it against its creases and
/// corner angles alone: what hardly moves because beams are very stiff, or the step is very short, has not settled.
#[derive(Debug)]
pub(super) struct Settling {
    tolerance: f64,
    softness: Vec<f64>,
    evaluations: u64,
    window_ends: u64,
    settled_windows: u32,
    positions: Vec<DVec3>,
    forces: Vec<DVec3>,
    distance: f64,
}

impl Settling {
    /// Stops within `tolerance` radii of the equilibrium.
    pub(super) fn new(model: &Model, tolerance: f64) -> Self {
        Self::with_stiffness(&soft_sums(model), tolerance)
    }

    fn with_stiffness(stiffness: &[f64], tolerance: f64) -> Self {
        Self {
            tolerance,
            softness: stiffness.iter().map(|k| 1.0 / k).collect(),
            evaluations: 0,
            window_ends: 0,
            settled_windows: 0,
            positions: Vec::new(),
            forces: Vec::new(),
            distance: f64::INFINITY,
        }
    }

    /// Whether a window ends with the next evaluation.
    pub(super) fn looks(&self) -> bool {
        self.evaluations == self.window_ends
    }

    /// Takes note of one evaluation; true when the state has settled. Where a window ends, `read` writes positions and
    /// forces by node.
    pub(super) fn observe(&mut self, read: impl FnOnce(&mut Vec<DVec3>, &mut Vec<DVec3>)) -> bool {
        if self.looks() {
            let (mut positions, mut forces) = (Vec::new(), Vec::new());
            read(&mut positions, &mut forces);
            if self.evaluations > 0 {
                self.distance = self.estimate(&positions, &forces);
                self.settled_windows = match self.distance / self.tolerance {
                    share if share < SMALL_SHARE => self.settled_windows + 2,
                    share if share < SHARE => self.settled_windows + 1,
                    _ => 0,
                };
            }
            (self.positions, self.forces) = (positions, forces);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of a step count")]
            let share = (SHARE_OF_PAST * self.evaluations as f64) as u64;
            self.window_ends += SHORTEST.max(share);
        }
        self.evaluations += 1;
        self.settled_windows >= WINDOWS && self.evaluations > LEAST
    }

    /// The estimate at the end of the last window, in radii; infinite before.
    pub(super) fn distance(&self) -> f64 {
        self.distance
    }

    fn estimate(&self, positions: &[DVec3], forces: &[DVec3]) -> f64 {
        let (mut largest, mut least, mut ahead, mut change) = (0.0_f64, 0.0_f64, 0.0, 0.0);
        let before = self.positions.iter().zip(&self.forces);
        for (((p, f), (p0, f0)), softness) in positions.iter().zip(forces).zip(before).zip(&self.softness) {
            let moved = *p - *p0;
            largest = largest.max(moved.length_squared());
            least = least.max(f.length() * softness);
            ahead += f.dot(moved);
            change += (*f - *f0).dot(moved);
        }
        let largest = largest.sqrt();
        if largest == 0.0 {
            return least;
        }
        // No change of force along a move: nothing tells how far the minimum is.
        let further = if change == 0.0 { f64::INFINITY } else { largest * (ahead / change).abs() };
        largest.max(further).max(least)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One evaluation of a sheet of one node.
    fn observe(settling: &mut Settling, position: DVec3, force: DVec3) -> bool {
        settling.observe(|positions, forces| {
            positions.push(position);
            forces.push(force);
        })
    }

    /// A point that slides down a parabola, a fixed share of its distance at each evaluation.
    fn slide(share: f64, tolerance: f64) -> (u64, f64, f64) {
        let mut settling = Settling::with_stiffness(&[7.0], tolerance);
        let mut x = 1.0;
        for evaluation in 0..1_000_000 {
            let (p, f) = (DVec3::new(x, 0.0, 0.0), DVec3::new(-7.0 * x, 0.0, 0.0));
            if observe(&mut settling, p, f) {
                return (evaluation, x, settling.distance());
            }
            x *= 1.0 - share;
        }
        panic!("did not settle");
    }

    #[test]
    fn slow_and_fast_slides_end_within_the_tolerance() {
        for share in [0.5, 0.1, 0.01, 0.001, 1e-4] {
            for tolerance in [1e-2, 1e-4, 1e-8] {
                let (_, distance, estimate) = slide(share, tolerance);
                assert!(distance < tolerance, "{share}: stopped at {distance}");
                assert!(estimate <= 0.3 * tolerance);
            }
        }
        assert!(slide(1e-4, 1e-8).0 > slide(1e-2, 1e-8).0, "a slow slide takes longer");
    }

    #[test]
    fn a_point_that_goes_on_moving_never_settles() {
        let mut settling = Settling::with_stiffness(&[20.0], 1e-4);
        let settled = (0..10_000).any(|i| {
            let x = f64::from(i) * 1e-5;
            observe(&mut settling, DVec3::new(x, 0.0, 0.0), DVec3::X)
        });
        assert!(!settled);
        assert_eq!(settling.distance(), f64::INFINITY);
    }

    #[test]
    fn rest_settles_after_the_least_number_of_evaluations() {
        let mut settling = Settling::with_stiffness(&[20.0], 1e-4);
        let at = (0..1000).position(|_| observe(&mut settling, DVec3::ONE, DVec3::ZERO));
        assert_eq!(at, Some(160));
    }

    #[test]
    fn a_loaded_node_that_cannot_move_has_not_settled() {
        let mut settling = Settling::with_stiffness(&[20.0], 1e-4);
        assert!((0..1000).all(|_| !observe(&mut settling, DVec3::ONE, DVec3::X)));
        assert_eq!(settling.distance(), 1.0 / 20.0);
    }
}
