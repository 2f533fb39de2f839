//! The solvers on a GPU against those on the processor, through the public interface.
#![cfg(feature = "gpu")]

#[path = "../common/mod.rs"]
mod common;
mod ensembles;
mod equilibria;
mod runs;
mod sheets;
mod trajectories;
