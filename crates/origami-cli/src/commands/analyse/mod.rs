//! `origami analyse` and `origami design`: sheets as structures.

#[cfg(not(feature = "analysis"))]
mod absent;
#[cfg(feature = "analysis")]
mod buckling;
#[cfg(feature = "analysis")]
mod curve;
#[cfg(feature = "analysis")]
mod design;
#[cfg(feature = "analysis")]
mod equilibria;
#[cfg(feature = "analysis")]
mod modes;
#[cfg(feature = "analysis")]
mod path;
#[cfg(feature = "analysis")]
mod present;
#[cfg(feature = "analysis")]
mod report;
#[cfg(feature = "analysis")]
mod stiffness;
#[cfg(feature = "analysis")]
mod subject;

#[cfg(not(feature = "analysis"))]
pub(super) use absent::{design, run};
#[cfg(feature = "analysis")]
pub(super) use {design::run as design, present::run};
