//! What is known to go wrong in a scene, told beforehand; and a sheet that could not do what it was asked to.
//!
//! Nothing here changes what is computed.

mod frustration;
mod over_folding;
mod single_precision;
mod slivers;

pub use frustration::frustration;
pub use single_precision::single_precision;

use std::fmt::Write;

use crate::error::Warning;
use crate::ids::NodeId;
use crate::model::Model;

/// Places that one warning names.
const NAMED: usize = 3;

/// What is dangerous about folding `model` to `percents`, with any solver: creases asked for more than 180 degrees, and
/// slivers.
#[must_use]
pub fn dangers(model: &Model, percents: &[f64]) -> Vec<Warning> {
    over_folding::over_folding(model, percents).into_iter().chain(slivers::slivers(model)).collect()
}

/// Such as `creases 0-4, 4-7, 7-9 and 12 more`, with the numbers of the pattern's vertices.
fn places<const N: usize>(model: &Model, what: [&str; 2], all: &[[NodeId; N]]) -> String {
    let mut text = what[usize::from(all.len() != 1)].to_owned();
    for (i, nodes) in all.iter().take(NAMED).enumerate() {
        let vertices = nodes.map(|node| model.mesh.vertex_of_node[node.index()].index().to_string());
        // Writing to a string cannot fail.
        let _ = write!(text, "{}{}", if i == 0 { " " } else { ", " }, vertices.join("-"));
    }
    if all.len() > NAMED {
        let _ = write!(text, " and {} more", all.len() - NAMED);
    }
    text
}
