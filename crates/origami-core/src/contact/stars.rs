//! What lies around each node: the edges that end there, and the triangles between them.

use glam::DVec3;

use super::barrier::EASED;
use crate::ids::NodeId;
use crate::mesh::Mesh;

/// Edges of a star. Where more edges end, the others are not in it.
pub(super) const ARMS: usize = 8;

/// Some of the edges and triangles at a node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Star {
    /// The other ends of the edges; after them the node itself.
    pub(super) ends: [NodeId; ARMS],
    /// By edge: the product of two of these is the inverse of what [`super::barrier::mollifier`] wants of both. 0 after them.
    pub(super) eased: [f64; ARMS],
    /// By triangle: the two edges between which it lies, as bits; 0 after them.
    pub(super) triangles: [u8; ARMS],
}

impl Star {
    /// Those of all nodes of a sheet with its nodes at `rest`.
    pub(super) fn all(mesh: &Mesh, rest: &[DVec3]) -> Vec<Self> {
        (0..mesh.node_count()).map(|node| Self::of(NodeId::new(node), mesh, rest)).collect()
    }

    fn of(node: NodeId, mesh: &Mesh, rest: &[DVec3]) -> Self {
        let mut star = Self { ends: [node; ARMS], eased: [0.0; ARMS], triangles: [0; ARMS] };
        let around = mesh.triangles_of_node.row(node.index()).iter().map(|t| mesh.triangles[t.index()]);
        let mut edges = 0;
        for corner in around.clone().flatten().filter(|corner| *corner != node) {
            if edges < ARMS && star.arm(corner).is_none() {
                star.ends[edges] = corner;
                let square = (rest[corner.index()] - rest[node.index()]).length_squared();
                star.eased[edges] = 1.0 / (EASED.sqrt() * square);
                edges += 1;
            }
        }
        let mut triangles = 0;
        for corners in around {
            let arms =
                corners.map(|corner| if corner == node { Some(0) } else { star.arm(corner).map(|arm| 1 << arm) });
            if let ([Some(a), Some(b), Some(c)], true) = (arms, triangles < ARMS) {
                star.triangles[triangles] = a | b | c;
                triangles += 1;
            }
        }
        star
    }

    /// Which of the edges ends at another node.
    pub(super) fn arm(&self, end: NodeId) -> Option<usize> {
        // After the edges it has its own node.
        self.ends.iter().position(|own| *own == end)
    }

    /// Which of the triangles has both of these corners beside its own.
    pub(super) fn triangle(&self, corners: [NodeId; 2]) -> Option<usize> {
        let [Some(one), Some(other)] = corners.map(|corner| self.arm(corner)) else { return None };
        self.triangles.iter().position(|arms| *arms == 1 << one | 1 << other)
    }
}
