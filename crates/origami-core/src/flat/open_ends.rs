//! Creases that end inside a face, which cannot fold: the paper around their end is in one piece.

use super::Role;
use super::corners::{Edges, corners, place};
use super::rings::{Ring, rings};
use crate::ids::{EdgeId, FaceId, VertexId};
use crate::pattern::CreasePattern;
use glam::DVec2;

/// The end of a crease inside a face.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct OpenEnd {
    /// The vertex at the end.
    pub vertex: VertexId,
    /// The crease that ends there.
    pub crease: EdgeId,
    /// The face that it ends in.
    pub face: FaceId,
    /// The nearest other line around that face and how far it is from the end, in the file's unit.
    pub nearest: Option<(EdgeId, f64)>,
}

/// The ends of all creases that are asked for an angle other than 0 and end inside a face, by vertex: where nothing else
/// leaves their end, or nothing but lines that stay flat.
#[must_use]
pub fn open_ends(pattern: &CreasePattern) -> Vec<OpenEnd> {
    let (corners, edges) = (corners(pattern), Edges::of(pattern));
    let mut ends: Vec<(VertexId, EdgeId)> = Vec::new();
    for (vertex, corners) in corners.iter().enumerate() {
        let vertex = VertexId::new(vertex);
        // A face that runs out to the vertex and back is all that there is around it.
        let tip = if let [tip] = corners { Some(tip.next).filter(|next| *next == tip.previous) } else { None };
        ends.extend(tip.and_then(|next| edges.between(vertex, next)).map(|crease| (vertex, crease)));
    }
    if pattern.is_flat() {
        ends.extend(rings(pattern).iter().filter_map(|ring| Some((ring.vertex, lone_crease(pattern, ring)?))));
    }
    ends.retain(|(_, crease)| matches!(Role::of(&pattern.edges[crease.index()]), Role::Folded { .. } | Role::Partial));
    ends.sort_unstable();
    let end = |(vertex, crease): (VertexId, EdgeId)| {
        let around = corners.row(vertex.index());
        let other_end = pattern.edges[crease.index()].vertices.into_iter().find(|end| *end != vertex)?;
        let face = around.iter().find(|corner| corner.next == other_end)?.face;
        let faces = around.iter().map(|corner| corner.face);
        Some(OpenEnd { vertex, crease, face: FaceId(face), nearest: nearest(pattern, &edges, faces, vertex) })
    };
    ends.into_iter().filter_map(end).collect()
}

/// The one line at a vertex that does not stay flat, where there is just one.
fn lone_crease(pattern: &CreasePattern, ring: &Ring) -> Option<EdgeId> {
    let mut others = ring.spokes.iter().map(|(edge, _)| *edge).filter(|edge| !stays_flat(pattern, *edge));
    others.next().filter(|_| others.next().is_none())
}

fn stays_flat(pattern: &CreasePattern, edge: EdgeId) -> bool {
    Role::of(&pattern.edges[edge.index()]) == Role::Flat
}

/// The line around `faces` that is nearest to a vertex, of those that do not stay flat and do not end there.
fn nearest(
    pattern: &CreasePattern,
    edges: &Edges,
    faces: impl Iterator<Item = u32>,
    vertex: VertexId,
) -> Option<(EdgeId, f64)> {
    let sides = faces.flat_map(|face| {
        let corners = &pattern.faces[face as usize];
        corners.iter().zip(corners.iter().cycle().skip(1))
    });
    let end = place(pattern, vertex);
    let distance = |(a, b): (&VertexId, &VertexId)| {
        let edge = edges.between(*a, *b).filter(|edge| *a != vertex && *b != vertex && !stays_flat(pattern, *edge))?;
        Some((edge, to_segment(end, [place(pattern, *a), place(pattern, *b)])))
    };
    sides.filter_map(distance).min_by(|a, b| a.1.total_cmp(&b.1))
}

/// How far a point is from a segment.
fn to_segment(point: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let along = b - a;
    let share = ((point - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    point.distance(a + share * along)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fold::Document;

    /// Edge, vertex, and the nearest line with its distance.
    type End = (u32, u32, Option<(u32, f64)>);

    fn ends(creases: &str, letters: &str) -> Vec<End> {
        let text = format!(
            r#"{{"vertices_coords": [[0,0], [4,0], [4,2], [0,2], [1,1], [3,0.5]],
                "edges_vertices": [[0,1], [1,2], [2,3], [3,0], {creases}],
                "edges_assignment": ["B","B","B","B", {letters}]}}"#
        );
        let document = Document::from_slice(text.as_bytes()).unwrap();
        let pattern = CreasePattern::from_document(&document, 0).unwrap();
        let plain = |end: OpenEnd| (end.vertex.0, end.crease.0, end.nearest.map(|(edge, by)| (edge.0, by)));
        open_ends(&pattern).into_iter().map(plain).collect()
    }

    #[test]
    fn the_ends_of_creases_are_found_with_the_nearest_line() {
        assert_eq!(ends("[0,4], [4,2]", r#""V","V""#), [], "it runs from rim to rim");
        assert_eq!(ends("[0,4]", r#""V""#), [(4, 4, Some((0, 1.0)))]);
        assert_eq!(ends("[0,4]", r#""F""#), [], "what stays flat does not matter");
        assert_eq!(ends("[0,4], [4,5]", r#""V","M""#), [(5, 5, Some((0, 0.5)))]);
        let island = ends("[4,5]", r#""V""#);
        assert_eq!(
            island.iter().map(|end| (end.0, end.1)).collect::<Vec<_>>(),
            [(4, 4), (5, 4)],
            "both ends of an island"
        );
        assert_eq!(
            ends("[0,4], [4,2], [4,1]", r#""V","F","F""#),
            [(4, 4, Some((0, 1.0)))],
            "what is beyond stays flat"
        );
    }
}
