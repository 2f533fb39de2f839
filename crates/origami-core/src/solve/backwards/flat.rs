//! The mesh of a sheet in its exact flat-folded state.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DVec2, DVec3};

use crate::ids::{NodeId, TriangleId};
use crate::layers::Stacking;
use crate::mesh::Mesh;

/// The ends of a side, the smaller first.
pub(super) type Edge = [NodeId; 2];

/// The mesh of a sheet in its exact flat-folded state.
pub(super) struct Flat<'a> {
    mesh: &'a Mesh,
    at: Vec<DVec2>,
    ordered: BTreeSet<[TriangleId; 2]>,
    pub(super) triangles_of: BTreeMap<Edge, Vec<TriangleId>>,
    pub(super) sides_of: BTreeMap<NodeId, BTreeSet<Edge>>,
}

impl<'a> Flat<'a> {
    pub(super) fn new(mesh: &'a Mesh, positions: &[DVec3], stacking: &Stacking) -> Self {
        let (mut triangles_of, mut sides_of) = (BTreeMap::new(), BTreeMap::new());
        for (t, corners) in mesh.triangles.iter().enumerate() {
            for side in sides(*corners) {
                triangles_of.entry(side).or_insert_with(Vec::new).push(TriangleId::new(t));
                for node in side {
                    sides_of.entry(node).or_insert_with(BTreeSet::new).insert(side);
                }
            }
        }
        let ordered = stacking.triangles.iter().map(|[low, high]| [*low.min(high), *low.max(high)]).collect();
        Self { mesh, at: positions.iter().map(|p| p.truncate()).collect(), ordered, triangles_of, sides_of }
    }

    pub(super) fn corners(&self, triangle: TriangleId) -> [NodeId; 3] {
        self.mesh.triangles[triangle.index()]
    }

    pub(super) fn at(&self, node: NodeId) -> DVec2 {
        self.at[node.index()]
    }

    /// Whether two triangles lie on each other, and so have an order.
    pub(super) fn is_ordered(&self, one: TriangleId, other: TriangleId) -> bool {
        self.ordered.contains(&[one.min(other), one.max(other)])
    }
}

pub(super) fn ordered([a, b]: Edge) -> Edge {
    [a.min(b), a.max(b)]
}

pub(super) fn sorted(mut corners: [NodeId; 3]) -> [NodeId; 3] {
    corners.sort_unstable();
    corners
}

pub(super) fn sides([a, b, c]: [NodeId; 3]) -> [Edge; 3] {
    [[a, b], [b, c], [c, a]].map(ordered)
}
