//! Which faces press on which.

use glam::DVec3;

use super::layers::Layers;
use crate::ids::{FaceId, NodeId};
use crate::mesh::Mesh;

/// Two faces that press on each other.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Pressing {
    /// The faces, the lower first. Where an edge or a corner presses that several faces share, each has its part.
    pub faces: [FaceId; 2],
    /// How hard, in the model's unit of force: the sizes of all that they push, added up.
    pub force: f64,
    /// Their least gap, in radii.
    pub gap: f64,
}

/// The faces that press at the positions that the layers were last measured at, the hardest first.
pub(crate) fn pressing(mesh: &Mesh, layers: &Layers, positions: &[DVec3]) -> Vec<Pressing> {
    let mut all: Vec<Pressing> = Vec::new();
    for (pair, near, force) in layers.presses(positions) {
        let (first, second) = pair.nodes.split_at(pair.split);
        let (first, second) = (faces(mesh, first), faces(mesh, second));
        let parts = first.iter().flat_map(|a| second.iter().map(move |b| [*a.min(b), *a.max(b)]));
        let parts: Vec<[FaceId; 2]> = parts.filter(|[a, b]| a != b).collect();
        let force = force / parts.len().max(1) as f64;
        all.extend(parts.into_iter().map(|faces| Pressing { faces, force, gap: near.gap }));
    }
    all.sort_by_key(|pressing| pressing.faces);
    let together = |own: &mut Pressing, kept: &mut Pressing| {
        let same = own.faces == kept.faces;
        if same {
            (kept.force, kept.gap) = (kept.force + own.force, kept.gap.min(own.gap));
        }
        same
    };
    all.dedup_by(together);
    all.sort_by(|a, b| b.force.total_cmp(&a.force).then(a.faces.cmp(&b.faces)));
    all
}

/// The faces that have all of these nodes, each once.
fn faces(mesh: &Mesh, nodes: &[NodeId]) -> Vec<FaceId> {
    let has = |triangle: usize| nodes.iter().all(|node| mesh.triangles[triangle].contains(node));
    let around = mesh.triangles_of_node.row(nodes[0].index()).iter().map(|t| t.index());
    let mut faces: Vec<FaceId> = around.filter(|t| has(*t)).map(|t| mesh.face_of_triangle[t]).collect();
    faces.sort_unstable();
    faces.dedup();
    faces
}
