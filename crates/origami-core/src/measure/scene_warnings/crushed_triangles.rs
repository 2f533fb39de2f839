//! Triangles that are lines where the sheet came to.

use glam::DVec3;

use crate::error::{Place, Warning, WarningCode};
use crate::ids::{TriangleId, VertexId};
use crate::model::Model;
use crate::solve::crushed_triangles;

/// A warning of triangles that are crushed to lines where the nodes are at `positions`, in radii
/// ([`crushed_triangles`] tells which).
#[must_use]
pub fn crushed(model: &Model, positions: &[DVec3]) -> Option<Warning> {
    let corners = |triangle: &TriangleId| {
        model.mesh.triangles[triangle.index()].map(|node| model.mesh.vertex_of_node[node.index()])
    };
    let triangles: Vec<[VertexId; 3]> = crushed_triangles(model, positions).iter().map(corners).collect();
    (!triangles.is_empty()).then(|| {
        let message = "crushed to a line: the creases around it cannot have their angles together, and forces have no rest \
                       where a triangle has no height; other angles, another percentage or stiffer faces (k_face) may keep \
                       it open";
        Warning::new(WarningCode::CrushedTriangle, Place::Triangles(triangles), message)
    })
}
