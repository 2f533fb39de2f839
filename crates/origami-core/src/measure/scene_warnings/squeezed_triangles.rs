//! Triangles that their areas keep from collapse.

use glam::DVec3;

use crate::error::{Place, Warning, WarningCode};
use crate::forces::areas::resisting;
use crate::ids::{TriangleId, VertexId};
use crate::model::Model;

/// A warning of triangles that have lost four fifths of their areas where the nodes are at `positions`, in radii, and resist
/// ([`resisting`] tells which): the equilibrium is not that of the paper's springs.
#[must_use]
pub fn squeezed(model: &Model, positions: &[DVec3]) -> Option<Warning> {
    let corners =
        |triangle: TriangleId| model.mesh.triangles[triangle.index()].map(|n| model.mesh.vertex_of_node[n.index()]);
    let triangles: Vec<[VertexId; 3]> = resisting(model, positions).map(corners).collect();
    (!triangles.is_empty()).then(|| {
        let message = "less than a fifth of its area is left, and a spring that the paper does not have (collapse) keeps it from \
                       becoming a line: the creases around it cannot have their angles together";
        Warning::new(WarningCode::SqueezedTriangle, Place::Triangles(triangles), message)
    })
}
