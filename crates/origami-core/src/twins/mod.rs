//! Decisions that the processor and the shaders take alike: pure functions, each with the name of its shader in
//! `shaders/src`, and the constants that both read.
//!
//! The solvers call these functions, and the GPU's tests compare the shaders with them. They are tuning, not interface:
//! they change from one version to the next.

pub mod checkpoint;
pub mod fire_update;
pub mod safe_time_step;
pub mod settle_decide;
pub mod state_bounds;
