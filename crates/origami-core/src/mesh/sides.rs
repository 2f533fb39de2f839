//! Sides of a triangulation, found by sorting rather than hashing.

use crate::error::{Error, ErrorCode, Place};
use crate::ids::{EdgeId, NodeId, SideId, TriangleId, VertexId};

/// A side of the triangulation: a beam, and a crease where two triangles meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Side {
    /// Its ends, nodes 3 and 4 of a crease: the first triangle, counterclockwise, runs from the first to the second.
    pub nodes: [NodeId; 2],
    /// The triangle to its left, then the one to its right.
    pub triangles: [Option<TriangleId>; 2],
    /// The corner of each triangle that is not on the side: nodes 1 and 2 of a crease.
    pub apexes: [Option<NodeId>; 2],
    /// The pattern's edge; `None` for a diagonal that the triangulation added.
    pub edge: Option<EdgeId>,
}

/// Where a side is named: by a pattern edge, or by the corner `corner` of a triangle (opposite to its apex).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Mention {
    Edge(u32),
    Triangle { triangle: u32, corner: u8 },
}

/// All sides, in the order of their nodes, so that neighbours in space are neighbours in memory where the numbering of the
/// nodes is; and the side of each of `edges`.
pub(super) fn build(
    triangles: &[[NodeId; 3]],
    edges: &[(EdgeId, [NodeId; 2])],
    vertex_of_node: &[VertexId],
) -> Result<(Vec<Side>, Vec<SideId>), Error> {
    let mut mentions = Vec::with_capacity(edges.len() + 3 * triangles.len());
    for (i, (_, ends)) in edges.iter().enumerate() {
        mentions.push((key(*ends), Mention::Edge(SideId::new(i).0)));
    }
    for (t, corners) in triangles.iter().enumerate() {
        for corner in 0..3_u8 {
            let mention = Mention::Triangle { triangle: TriangleId::new(t).0, corner };
            mentions.push((key(ends_of(corners, corner)), mention));
        }
    }
    mentions.sort_unstable();

    let mut side_of_edge = vec![SideId(0); edges.len()];
    let groups = mentions.chunk_by(|a, b| a.0 == b.0).enumerate();
    let sides = groups.map(|(i, group)| {
        // `Mention::Edge` sorts before `Mention::Triangle`.
        if let Mention::Edge(e) = group[0].1 {
            side_of_edge[e as usize] = SideId::new(i);
        }
        side(group, triangles, edges).map_err(|(code, problem, expected)| {
            let ends = group[0].0.map(|n| vertex_of_node[n.index()]);
            Error::new(code, Place::Vertices(ends.to_vec()), problem, expected)
        })
    });
    let sides = sides.collect::<Result<_, _>>()?;
    Ok((sides, side_of_edge))
}

/// The side that `group` mentions; an error is its kind, the problem and what was expected.
fn side(
    group: &[([NodeId; 2], Mention)],
    triangles: &[[NodeId; 3]],
    edges: &[(EdgeId, [NodeId; 2])],
) -> Result<Side, (ErrorCode, &'static str, &'static str)> {
    let ends = group[0].0;
    let mut side = Side { nodes: ends, triangles: [None; 2], apexes: [None; 2], edge: None };
    for (_, mention) in group {
        match *mention {
            Mention::Edge(_) if side.edge.is_some() => {
                let problem = "two edges lie between them";
                return Err((ErrorCode::EdgeTwice, problem, "one edge, the other its alias"));
            }
            Mention::Edge(e) => {
                side.edge = Some(edges[e as usize].0);
                side.nodes = edges[e as usize].1;
            }
            Mention::Triangle { triangle, corner } => {
                let corners = &triangles[triangle as usize];
                let ends = ends_of(corners, corner);
                let hand = usize::from(side.triangles[0].is_some());
                if hand == 0 {
                    side.nodes = ends;
                } else if side.triangles[1].is_some() || side.nodes == ends {
                    return Err((
                        ErrorCode::EdgeOfManyFaces,
                        "more than two triangles meet at the line between them, or two lie on the same side of it",
                        "at most one triangle on each side",
                    ));
                }
                side.triangles[hand] = Some(TriangleId(triangle));
                side.apexes[hand] = Some(corners[usize::from(corner)]);
            }
        }
    }
    Ok(side)
}

/// The side opposite to a corner, in the triangle's direction.
fn ends_of(corners: &[NodeId; 3], corner: u8) -> [NodeId; 2] {
    let c = usize::from(corner);
    [corners[(c + 1) % 3], corners[(c + 2) % 3]]
}

/// The ends in ascending order: one key for both directions.
fn key([a, b]: [NodeId; 2]) -> [NodeId; 2] {
    if a <= b { [a, b] } else { [b, a] }
}
