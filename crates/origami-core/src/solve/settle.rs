//! When to stop: watches a state over windows of evaluations at constant targets (the rule is
//! [`crate::twins::settle_decide`]).

use glam::DVec3;

use super::row_sums::soft_sums;
use crate::model::Model;
use crate::twins::settle_decide::{Window, Windows, distance};

/// Moves of so many radii, where forces would take no node farther, are rounding: positions near 1 are 2e-16 apart. What
/// little the forces change along them tells nothing: of a line that is not strained at all they are all that there is.
const ROUNDING: f64 = 1e-13;

/// Where the nodes were when the present window began, and what pulled them.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Settling {
    tolerance: f64,
    /// By node: the inverse of the row sum of its creases and corner angles.
    softness: Vec<f64>,
    windows: Windows,
    before: Vec<[DVec3; 2]>,
    /// The last estimate; none where nothing tells.
    distance: Option<f64>,
}

impl Settling {
    /// Stops within `tolerance` radii of the equilibrium.
    pub(super) fn new(model: &Model, tolerance: f64) -> Self {
        Self::with_stiffness(&soft_sums(model), tolerance)
    }

    fn with_stiffness(stiffness: &[f64], tolerance: f64) -> Self {
        let softness = stiffness.iter().map(|k| 1.0 / k).collect();
        Self {
            tolerance,
            softness,
            windows: Windows::default(),
            before: Vec::with_capacity(stiffness.len()),
            distance: None,
        }
    }

    /// Whether a window ends with the next evaluation.
    pub(super) fn window_ends(&self) -> bool {
        self.windows.window_ends()
    }

    /// Takes note of one evaluation; true when the state has settled. `nodes` are positions and forces, looked at where a
    /// window ends.
    pub(super) fn observe(&mut self, nodes: impl Iterator<Item = [DVec3; 2]>) -> bool {
        let mut share = None;
        if self.windows.window_ends() {
            if self.before.is_empty() {
                self.before.extend(nodes);
            } else {
                let window = self.next_window(nodes);
                if self.windows.sound {
                    let distance = distance(window, self.tolerance);
                    self.distance = Some(distance).filter(|distance| distance.is_finite());
                    share = Some(distance / self.tolerance);
                }
            }
        }
        self.windows.settle_decide(1, share)
    }

    /// Something has changed that the sheet has yet to follow.
    pub(super) fn disturb(&mut self) {
        self.windows.disturb();
        self.distance = None;
    }

    /// The estimate at the end of the last window, in radii; infinite before.
    pub(super) fn distance(&self) -> f64 {
        self.distance.unwrap_or(f64::INFINITY)
    }

    /// Whether it is of so many nodes.
    pub(super) fn fits(&self, nodes: usize) -> bool {
        self.softness.len() == nodes && (self.before.is_empty() || self.before.len() == nodes)
    }

    /// Whether the last windows had all settled.
    pub(super) fn has_settled(&self) -> bool {
        self.windows.has_settled()
    }

    /// What a window came to; the next one begins at `nodes`.
    fn next_window(&mut self, nodes: impl Iterator<Item = [DVec3; 2]>) -> Window {
        let (mut largest, mut window) = (0.0_f64, Window::default());
        for (([p, f], before), softness) in nodes.zip(&mut self.before).zip(&self.softness) {
            let [p0, f0] = std::mem::replace(before, [p, f]);
            let moved = p - p0;
            largest = largest.max(moved.length_squared());
            window.least = window.least.max(f.length() * softness);
            window.ahead += f.dot(moved);
            window.change += (f - f0).dot(moved);
        }
        let largest = largest.sqrt();
        let rounding = largest < ROUNDING && window.least < ROUNDING;
        Window { largest: if rounding { 0.0 } else { largest }, ..window }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One evaluation of a sheet of one node.
    fn observe(settling: &mut Settling, position: DVec3, force: DVec3) -> bool {
        settling.observe(std::iter::once([position, force]))
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
    fn noise_that_forces_do_not_follow_is_rest() {
        let mut settling = Settling::with_stiffness(&[20.0], 1e-4);
        let noise = |i: i32| f64::from(i * 7 % 5) * 1e-16;
        let settled = (0..1000).position(|i| {
            let force = DVec3::new(1e-16, noise(3 * i) * 1e-16, 0.0);
            observe(&mut settling, DVec3::new(1.0 + noise(i), noise(i + 1), 0.0), force)
        });
        assert_eq!(settled, Some(160));
    }

    #[test]
    fn a_loaded_node_that_cannot_move_has_not_settled() {
        let mut settling = Settling::with_stiffness(&[20.0], 1e-4);
        assert!((0..1000).all(|_| !observe(&mut settling, DVec3::ONE, DVec3::X)));
        assert_eq!(settling.distance(), 1.0 / 20.0);
    }

    #[test]
    fn a_slide_that_is_pushed_back_settles_anew_within_the_tolerance() {
        for share in [0.5, 0.1, 0.01] {
            let tolerance = 1e-4;
            let mut settling = Settling::with_stiffness(&[7.0], tolerance);
            let mut x = 1.0;
            for push in 0..3 {
                x += 0.3;
                settling.disturb();
                assert_eq!(settling.distance(), f64::INFINITY, "nothing is known of it yet");
                let took = (0..100_000).find(|_| {
                    x *= 1.0 - share;
                    observe(&mut settling, DVec3::new(x, 0.0, 0.0), DVec3::new(-7.0 * x, 0.0, 0.0))
                });
                assert!(took.is_some() && x < tolerance, "{share}, push {push}: stopped at {x}");
            }
        }
    }
}
