//! Creases that end inside a face, which cannot fold: the paper around their end is in one piece.

use super::corners::{Edges, corners, place};
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

/// The ends of all creases that are asked for an angle other than 0 and end inside a face, by vertex.
#[must_use]
pub fn open_ends(pattern: &CreasePattern) -> Vec<OpenEnd> {
    let (corners, edges) = (corners(pattern), Edges::of(pattern));
    let mut ends = Vec::new();
    for (vertex, corners) in corners.iter().enumerate() {
        let vertex = VertexId::new(vertex);
        // A face that runs out to the vertex and back is all that there is around it.
        let [tip] = corners else { continue };
        if tip.next != tip.previous {
            continue;
        }
        let Some(crease) = edges.between(vertex, tip.next) else { continue };
        if pattern.edges[crease.index()].fold_angle.is_none_or(|angle| angle == 0.0) {
            continue;
        }
        let face = FaceId(tip.face);
        ends.push(OpenEnd { vertex, crease, face, nearest: nearest(pattern, &edges, face, (vertex, crease)) });
    }
    ends
}

/// The line around `face` that is nearest to the end of a crease.
fn nearest(
    pattern: &CreasePattern,
    edges: &Edges,
    face: FaceId,
    (vertex, crease): (VertexId, EdgeId),
) -> Option<(EdgeId, f64)> {
    let corners = &pattern.faces[face.index()];
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let end = place(pattern, vertex);
    let distance = |(a, b): (&VertexId, &VertexId)| {
        let edge = edges.between(*a, *b).filter(|edge| *edge != crease)?;
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

    fn ends(creases: &str, letters: &str) -> Vec<(u32, u32, Option<(u32, f64)>)> {
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
    }
}
