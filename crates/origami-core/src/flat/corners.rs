//! The corners of all faces by vertex, and the edges by their ends.

use glam::DVec2;

use crate::csr::Csr;
use crate::ids::{EdgeId, VertexId};
use crate::pattern::CreasePattern;

/// A face's corner at a vertex, which lies to the left of the line to `next` and to the right of that to `previous`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) face: u32,
    /// The corner after it, counterclockwise around the face.
    pub(super) next: VertexId,
    /// The corner before it.
    pub(super) previous: VertexId,
}

/// All corners, by vertex.
pub(super) fn corners(pattern: &CreasePattern) -> Csr<Corner> {
    let of_face = |(face, corners): (usize, &'_ Vec<VertexId>)| {
        let count = corners.len();
        let corners = corners.clone();
        (0..count).map(move |i| {
            let corner = Corner {
                face: face as u32,
                next: corners[(i + 1) % count],
                previous: corners[(i + count - 1) % count],
            };
            (corners[i].index(), corner)
        })
    };
    let entries: Vec<(usize, Corner)> = pattern.faces.iter().enumerate().flat_map(of_face).collect();
    Csr::from_entries(pattern.vertices.len(), entries.iter().copied())
}

/// Edges by their ends; those that another one stands for are left out.
pub(super) struct Edges(Csr<(VertexId, EdgeId)>);

impl Edges {
    pub(super) fn of(pattern: &CreasePattern) -> Self {
        let live = pattern.edges.iter().enumerate().filter(|(_, edge)| edge.alias_of.is_none());
        let both = live.flat_map(|(e, edge)| {
            let [a, b] = edge.vertices;
            [(a.index(), (b, EdgeId::new(e))), (b.index(), (a, EdgeId::new(e)))]
        });
        let mut rows = Csr::from_entries(pattern.vertices.len(), both);
        (0..rows.rows()).for_each(|vertex| rows.row_mut(vertex).sort_unstable());
        Self(rows)
    }

    /// The edge between two vertices.
    pub(super) fn between(&self, from: VertexId, to: VertexId) -> Option<EdgeId> {
        let row = self.0.row(from.index());
        let at = row.partition_point(|(other, _)| *other < to);
        row.get(at).filter(|(other, _)| *other == to).map(|(_, edge)| *edge)
    }
}

/// Where a vertex lies, seen from above.
pub(super) fn place(pattern: &CreasePattern, vertex: VertexId) -> DVec2 {
    pattern.vertices[vertex.index()].truncate()
}
