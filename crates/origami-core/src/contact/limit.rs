//! How far the nodes of a pair may move: planes in place of continuous collision detection (after the planar bounds of Divide
//! and Truncate, 2026).
//!
//! Between the nearest points a and b of two convex things lies a slab that is free of both. It is divided between them by a
//! plane, as they would use it, and no node goes beyond its side. Half-spaces are convex: a move of which every node makes any
//! share up to its own stays within them, and the whole straight way is free. No time of impact is sought.

use glam::DVec3;

use super::pairs::{Near, Pair};
use crate::ids::NodeId;

/// The share of a gap that one move may use up.
pub const USABLE: f64 = 0.5;
/// A pair is looked at before a move if its gap, but for what is never used up of it, is below so many times what both of its
/// things may move: what is not looked at uses up no more than a move may.
pub const WITHIN: f64 = 1.0 / USABLE;
/// The share of a pair's width that is never used up: without it gaps would shrink to nothing by halves.
pub(super) const FLOOR: f64 = 1e-3;

/// How far off the two nearest points may be by rounding, in radii. A normal is off by that over their distance, and so what lies
/// as far from them as a radius seems to have more or less room than it has.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// By node the share of its move that it may make; only ever made less.
pub(super) struct Shares<'a>(pub(super) &'a mut [f64]);

/// Shortens the moves of one pair, measured at `positions`.
pub(super) fn limit_pair(pair: &Pair, near: &Near, (positions, moves): (&[DVec3], &[DVec3]), shares: Shares<'_>) {
    let usable = USABLE * (near.gap - FLOOR * pair.width).max(0.0);
    let (first, second) = pair.nodes.split_at(pair.split);
    let tilt = ROUNDING / (near.gap + pair.closed).max(f64::MIN_POSITIVE);
    let one = Side::new(first, &near.weights[..pair.split], 1.0, (near.normal, tilt), (positions, moves));
    let other = Side::new(second, &near.weights[pair.split..], -1.0, (-near.normal, tilt), (positions, moves));
    let all = one.approach + other.approach;
    if all <= 0.0 {
        return;
    }
    let Shares(shares) = shares;
    one.limit(usable * one.approach / all, (positions, moves), shares);
    other.limit(usable * other.approach / all, (positions, moves), shares);
}

/// One of the two things, seen along the normal that points away from the other.
struct Side<'a> {
    nodes: &'a [NodeId],
    normal: DVec3,
    /// How far the normal may be off, in radians.
    tilt: f64,
    /// Its point that is nearest to the other.
    point: DVec3,
    /// How far it would come beyond that point.
    approach: f64,
}

impl<'a> Side<'a> {
    fn new(
        nodes: &'a [NodeId],
        weights: &[f64],
        sign: f64,
        (normal, tilt): (DVec3, f64),
        (positions, moves): (&[DVec3], &[DVec3]),
    ) -> Self {
        let point = nodes.iter().zip(weights).map(|(n, w)| positions[n.index()] * (sign * w)).sum();
        let mut side = Self { nodes, normal, tilt, point, approach: 0.0 };
        for node in nodes {
            let approach = -moves[node.index()].dot(normal) - side.room(positions[node.index()]);
            side.approach = side.approach.max(approach);
        }
        side
    }

    /// How far a node is at least behind the nearest point; below 0 by rounding alone. Without what that may come to, pairs
    /// that are pressed for long would come nearer by it each time.
    fn room(&self, position: DVec3) -> f64 {
        let from = position - self.point;
        from.dot(self.normal) - self.tilt * from.length()
    }

    /// Lets no node come more than `usable` beyond the nearest point. One that is there already by rounding stays.
    fn limit(&self, usable: f64, (positions, moves): (&[DVec3], &[DVec3]), shares: &mut [f64]) {
        for node in self.nodes.iter().map(|n| n.index()) {
            let advance = -moves[node].dot(self.normal);
            let room = self.room(positions[node]) + usable;
            if advance > room && advance > 0.0 {
                shares[node] = shares[node].min((room / advance).max(0.0));
            }
        }
    }
}
