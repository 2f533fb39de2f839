//! Which states are good to go back to where the sheet diverges.

use glam::DVec3;

use super::state_bounds::within;

/// Steps between two copies of the state.
pub const COPY_EVERY: u64 = 100;
/// A state is good to go back to while its nodes lie within this many radii.
pub const GOOD_POSITION: f64 = 5.0;
/// And while none of them moves by more than this many radii in one step.
pub const GOOD_MOVE: f64 = 0.1;

/// Whether a node lets a state be one to go back to.
#[must_use]
pub fn is_good(position: DVec3, moved: DVec3) -> bool {
    within(position, moved, GOOD_POSITION, GOOD_MOVE)
}
