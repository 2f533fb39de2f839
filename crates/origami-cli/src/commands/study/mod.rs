//! `origami study`: how far the solvers can be trusted.

#[cfg(not(feature = "study"))]
mod absent;
#[cfg(feature = "study")]
pub(super) mod folder;
#[cfg(feature = "study")]
mod patterns;
#[cfg(feature = "study")]
mod present;

#[cfg(not(feature = "study"))]
pub(super) use absent::run;
#[cfg(feature = "study")]
pub(super) use present::run;
