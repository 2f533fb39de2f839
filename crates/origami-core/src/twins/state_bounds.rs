//! What makes no sense any more: a sheet of radius 1 whose nodes are far away, or move far in one step.

use glam::DVec3;

/// Positions beyond this many radii make no sense: a sheet of radius 1 cannot reach a tenth of it.
pub const FARTHEST: f64 = 100.0;
/// Nor do moves of more than this many radii in one step.
pub const LONGEST_MOVE: f64 = 1.0;

/// Whether one node is where it can be, and came there in a step that it can take. NaN is out of bounds.
#[must_use]
pub fn in_bounds(position: DVec3, moved: DVec3) -> bool {
    within(position, moved, FARTHEST, LONGEST_MOVE)
}

/// Whether a node is within `farthest` of the centre and moved by no more than `longest`.
pub(super) fn within(position: DVec3, moved: DVec3, farthest: f64, longest: f64) -> bool {
    position.length_squared() <= farthest * farthest && moved.length_squared() <= longest * longest
}
