//! What is known to go wrong in a scene, told beforehand; and a sheet that could not do what it was asked to.
//!
//! Nothing here changes what is computed.

mod frustration;
mod over_folding;
mod single_precision;
mod slivers;

pub use frustration::frustration;
pub use single_precision::single_precision;

use crate::error::Warning;
use crate::model::Model;

/// What is dangerous about folding `model` to `percents`, with any solver: creases asked for more than 180 degrees, and
/// slivers.
#[must_use]
pub fn dangers(model: &Model, percents: &[f64]) -> Vec<Warning> {
    over_folding::over_folding(model, percents).into_iter().chain(slivers::slivers(model)).collect()
}
