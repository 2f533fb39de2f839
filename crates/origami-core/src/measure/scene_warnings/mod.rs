//! Warnings about a scene: before it is folded, of what is known to go wrong, and afterwards of a sheet that could not do
//! what it was asked to. They change nothing that is computed.

mod crushed_triangles;
mod off_target;
mod over_folding;
mod single_precision;
mod slivers;
mod squeezed_triangles;
mod strained_at_rest;
mod touching_lips;

pub use crushed_triangles::crushed;
pub use single_precision::single_precision;
pub use squeezed_triangles::squeezed;
pub use strained_at_rest::strained_at_rest;
pub use touching_lips::touching_lips;

use crate::error::Warning;
use crate::model::Model;
use crate::pattern::CreasePattern;
use crate::solve::Folded;

/// Warnings about folding `model` to each of `percents` with any solver: of creases asked for more than 180 degrees
/// ([`WarningCode::OverFolding`]) and of triangles that are nearly lines ([`WarningCode::Slivers`]).
///
/// [`WarningCode::OverFolding`]: crate::error::WarningCode::OverFolding
/// [`WarningCode::Slivers`]: crate::error::WarningCode::Slivers
#[must_use]
pub fn scene_warnings(model: &Model, percents: &[f64]) -> Vec<Warning> {
    over_folding::over_folding(model, percents).into_iter().chain(slivers::slivers(model)).collect()
}

/// Warnings about the state that a solver came to: a sheet strained at rest ([`strained_at_rest`]), creases that are far from
/// their angles though nothing is strained, or very far from them short of 100 % ([`WarningCode::CreaseOffTarget`]) or end
/// inside a face ([`WarningCode::OpenCrease`]), triangles that were crushed to lines ([`WarningCode::CrushedTriangle`]) and
/// those that are kept from it ([`WarningCode::SqueezedTriangle`]).
///
/// [`WarningCode::CreaseOffTarget`]: crate::error::WarningCode::CreaseOffTarget
/// [`WarningCode::OpenCrease`]: crate::error::WarningCode::OpenCrease
/// [`WarningCode::CrushedTriangle`]: crate::error::WarningCode::CrushedTriangle
/// [`WarningCode::SqueezedTriangle`]: crate::error::WarningCode::SqueezedTriangle
#[must_use]
pub fn folded_warnings(pattern: &CreasePattern, model: &Model, folded: &Folded) -> Vec<Warning> {
    let mut warnings: Vec<Warning> = crushed(model, &folded.state.positions).into_iter().collect();
    warnings.extend(squeezed(model, &folded.state.positions));
    warnings.extend(strained_at_rest(model, folded));
    warnings.extend(off_target::off_target(pattern, model, folded));
    warnings
}
