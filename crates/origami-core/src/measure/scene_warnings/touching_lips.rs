//! Sides of cuts that contact does not keep apart.

use crate::contact;
use crate::error::{Place, Warning, WarningCode};
use crate::model::Model;

/// Of a sheet that is folded under contact: lips of cuts that touch in the flat sheet, and so may go through each other
/// ([`WarningCode::TouchingLips`]).
#[must_use]
pub fn touching_lips(model: &Model) -> Option<Warning> {
    let (count, nodes) = contact::touching_lips(&model.mesh, &model.rest);
    let vertices = nodes.iter().map(|node| model.mesh.vertex_of_node[node.index()]).collect();
    let message = format!(
        "paper touches other paper there in the flat sheet, as the lips of a cut do: {count} pairs of a vertex and a triangle or \
         of two edges are not kept from going through each other; expected cuts with a width"
    );
    (count > 0).then(|| Warning::new(WarningCode::TouchingLips, Place::Vertices(vertices), message))
}
