//! The longest time step that holds, and its renewal as the sheet changes.

/// How much of the longest step that surely holds is taken.
pub const SAFE_SHARE: f64 = 0.9;
/// How far the swiftest node may get in one step, in radii: what moves farther has left the shape for which the step was
/// found, which very stiff creases do at a jump.
pub const SAFE_MOVE: f64 = 0.1;
/// How much longer a renewed step may be than the one before: heights shrink again, within fewer steps than a renewal.
/// `origami study stability` found narrow pleats to fail at 1.12.
pub const SAFE_GROWTH: f64 = 1.025;
/// Steps between two renewals. At 20 a jump of creases 10 000 times stiffer than by default leaves the step behind
/// (`origami study stability`).
pub const RENEWAL: u64 = 10;

/// [`SAFE_SHARE`] of the longest step for which `K dt^2 + 2 D dt < 4`, with K the largest row sum of the stiffness and
/// `damping` the 2 D of `solve::time_step::damping_sum`.
#[must_use]
pub fn longest(stiffness: f64, damping: f64) -> f64 {
    // (-D + sqrt(D^2 + 4 K)) / K without the difference of nearly equal numbers.
    SAFE_SHARE * 4.0 / (damping + (damping * damping + 4.0 * stiffness).sqrt())
}

/// The step that follows `previous`, of which there is none at first, where [`longest`] says `safe` and the swiftest node
/// has the speed `swiftest`.
#[must_use]
pub fn safe_time_step(safe: f64, swiftest: f64, previous: Option<f64>) -> f64 {
    let slow_enough = if safe * swiftest > SAFE_MOVE { SAFE_MOVE / swiftest } else { safe };
    previous.map_or(slow_enough, |previous| slow_enough.min(SAFE_GROWTH * previous))
}
