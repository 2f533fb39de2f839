//! Warnings about a scene: before it is folded, of what is known to go wrong, and afterwards of a sheet that could not do
//! what it was asked to. They change nothing that is computed.

mod over_folding;
mod single_precision;
mod slivers;
mod strained_at_rest;

pub use single_precision::single_precision;
pub use strained_at_rest::strained_at_rest;

use crate::error::Warning;
use crate::model::Model;

/// Warnings about folding `model` to each of `percents` with any solver: of creases asked for more than 180 degrees
/// ([`WarningCode::OverFolding`]) and of triangles that are nearly lines ([`WarningCode::Slivers`]).
///
/// [`WarningCode::OverFolding`]: crate::error::WarningCode::OverFolding
/// [`WarningCode::Slivers`]: crate::error::WarningCode::Slivers
#[must_use]
pub fn scene_warnings(model: &Model, percents: &[f64]) -> Vec<Warning> {
    over_folding::over_folding(model, percents).into_iter().chain(slivers::slivers(model)).collect()
}
