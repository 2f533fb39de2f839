//! Topology of the triangulated sheet: the nodes, sides and triangles that touch each other. Positions are not known here.
//!
//! The geometry that a triangulation needs stays in `triangulate`; everything below it is integers.

mod order;
mod sides;
pub mod triangulate;

pub use sides::Side;

use crate::csr::Csr;
use crate::error::Error;
use crate::ids::{EdgeId, FaceId, NodeId, SideId, TriangleId, VertexId};
use crate::pattern::CreasePattern;

/// A triangulated sheet. Its nodes are the pattern's vertices that some face or edge uses. They are numbered as in the
/// pattern, unless the sheet is large and that numbering scatters neighbours over memory: then by reverse Cuthill-McKee.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Mesh {
    /// The pattern's vertex of each node.
    pub vertex_of_node: Vec<VertexId>,
    /// The node of each pattern vertex; `None` for an isolated vertex, which is no part of the sheet.
    pub node_of_vertex: Vec<Option<NodeId>>,
    /// Sides of triangles and edges outside any face, in the order of their nodes.
    pub sides: Vec<Side>,
    /// The side of each pattern edge, or of the edge that stands for it; `None` where there is no such side.
    pub side_of_edge: Vec<Option<SideId>>,
    /// Corners, in the orientation of the face that the triangle is a part of. Ordered by the lowest node of each, so that
    /// neighbours in space are neighbours in memory.
    pub triangles: Vec<[NodeId; 3]>,
    /// The pattern's face of each triangle.
    pub face_of_triangle: Vec<FaceId>,
    /// The triangles in the order in which they were cut from the pattern's faces, which is the order in files.
    pub triangles_by_face: Vec<TriangleId>,
    /// Sides at each node.
    pub sides_of_node: Csr<SideId>,
    /// Triangles at each node.
    pub triangles_of_node: Csr<TriangleId>,
}

impl Mesh {
    /// The mesh of a pattern whose faces have been cut into `triangles`, each a part of the face in `face_of_triangle`.
    ///
    /// # Errors
    /// [`Error::Invalid`] where more than two triangles meet at a side, or two lie on the same side of it.
    pub fn new(
        pattern: &CreasePattern,
        triangles: &[[VertexId; 3]],
        face_of_triangle: Vec<FaceId>,
    ) -> Result<Self, Error> {
        let (vertex_of_node, node_of_vertex) = number_nodes(pattern, triangles);
        let node = |v: VertexId| node_of_vertex[v.index()].expect("every corner and edge end was numbered");
        let by_face: Vec<[NodeId; 3]> = triangles.iter().map(|t| t.map(node)).collect();
        let (triangles, triangles_by_face) = sorted(&by_face);
        let mut face_of = face_of_triangle.clone();
        for (face, triangle) in face_of_triangle.into_iter().zip(&triangles_by_face) {
            face_of[triangle.index()] = face;
        }

        let own_edges: Vec<(EdgeId, [NodeId; 2])> = own_edges(pattern).map(|(id, ends)| (id, ends.map(node))).collect();
        let (sides, side_of_own_edge) = sides::build(&triangles, &own_edges, &vertex_of_node)?;
        let mut side_of_edge = vec![None; pattern.edges.len()];
        for ((edge, _), side) in own_edges.iter().zip(side_of_own_edge) {
            side_of_edge[edge.index()] = Some(side);
        }
        for (i, edge) in pattern.edges.iter().enumerate() {
            if let Some(alias) = edge.alias_of {
                side_of_edge[i] = side_of_edge[alias.index()];
            }
        }

        let nodes = vertex_of_node.len();
        let sides_of_node = Csr::inverted(nodes, sides.iter().map(|s| s.nodes.as_slice()), |n| n.index(), SideId::new);
        let triangles_of_node =
            Csr::inverted(nodes, triangles.iter().map(|t| t.as_slice()), |n| n.index(), TriangleId::new);
        Ok(Self {
            vertex_of_node,
            node_of_vertex,
            sides,
            side_of_edge,
            triangles,
            face_of_triangle: face_of,
            triangles_by_face,
            sides_of_node,
            triangles_of_node,
        })
    }

    /// How many nodes there are.
    #[must_use]
    pub fn node_count(&self) -> usize {
        self.vertex_of_node.len()
    }
}

/// The pattern's edges that stand for themselves, with their ends.
fn own_edges(pattern: &CreasePattern) -> impl Iterator<Item = (EdgeId, [VertexId; 2])> + Clone {
    let edges = pattern.edges.iter().enumerate();
    edges.filter(|(_, e)| e.alias_of.is_none()).map(|(i, e)| (EdgeId::new(i), e.vertices))
}

/// The vertex of each node, and the node of each vertex that has one.
fn number_nodes(pattern: &CreasePattern, triangles: &[[VertexId; 3]]) -> (Vec<VertexId>, Vec<Option<NodeId>>) {
    let mut used = vec![false; pattern.vertices.len()];
    for vertex in triangles.iter().flatten() {
        used[vertex.index()] = true;
    }
    for (_, ends) in own_edges(pattern) {
        ends.iter().for_each(|v| used[v.index()] = true);
    }
    let vertices = used.iter().enumerate().filter(|(_, used)| **used);
    let mut vertex_of_node: Vec<VertexId> = vertices.map(|(i, _)| VertexId::new(i)).collect();
    let mut node_of_vertex = vec![None; pattern.vertices.len()];
    let number = |node_of_vertex: &mut [Option<NodeId>], vertex_of_node: &[VertexId]| {
        vertex_of_node.iter().enumerate().for_each(|(i, v)| node_of_vertex[v.index()] = Some(NodeId::new(i)));
    };
    number(&mut node_of_vertex, &vertex_of_node);
    let nodes = vertex_of_node.len();
    if order::is_scattered(nodes, neighbours(pattern, triangles, &node_of_vertex)) {
        let neighbours = Csr::from_entries(nodes, neighbours(pattern, triangles, &node_of_vertex));
        let order = order::reverse_cuthill_mckee(&neighbours);
        vertex_of_node = order.iter().map(|n| vertex_of_node[n.index()]).collect();
        number(&mut node_of_vertex, &vertex_of_node);
    }
    (vertex_of_node, node_of_vertex)
}

/// Each node with the nodes beside it, some of them twice: along sides of triangles, and along edges in both directions,
/// since not every side has a triangle on either hand.
fn neighbours(
    pattern: &CreasePattern,
    triangles: &[[VertexId; 3]],
    node_of_vertex: &[Option<NodeId>],
) -> impl Iterator<Item = (usize, NodeId)> + Clone {
    let along_triangles = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let along_edges = own_edges(pattern).flat_map(|(_, [a, b])| [[a, b], [b, a]]);
    let numbered = |ends: [VertexId; 2]| {
        let [a, b] = ends.map(|v| node_of_vertex[v.index()]);
        Some((a?.index(), b?))
    };
    along_triangles.chain(along_edges).filter_map(numbered)
}

/// The triangles in the order of their lowest nodes, those of one node in the order given; and the new index of each.
fn sorted(given: &[[NodeId; 3]]) -> (Vec<[NodeId; 3]>, Vec<TriangleId>) {
    let lowest = |corners: &[NodeId; 3]| corners.iter().copied().min();
    if given.is_sorted_by_key(lowest) {
        return (given.to_vec(), (0..given.len()).map(TriangleId::new).collect());
    }
    let mut order: Vec<TriangleId> = (0..given.len()).map(TriangleId::new).collect();
    order.sort_by_key(|t| lowest(&given[t.index()]));
    let mut new_index = order.clone();
    order.iter().enumerate().for_each(|(new, t)| new_index[t.index()] = TriangleId::new(new));
    (order.iter().map(|t| given[t.index()]).collect(), new_index)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Place;
    use crate::pattern::{Assignment, PatternEdge};

    fn edge(a: u32, b: u32) -> PatternEdge {
        PatternEdge {
            vertices: [VertexId(a), VertexId(b)],
            assignment: Assignment::Mountain,
            fold_angle: Some(-1.0),
            k_crease: None,
            ea: None,
            alias_of: None,
        }
    }

    /// A square 0 1 2 3 with the diagonal 0-2 and an isolated vertex 4 between.
    fn square() -> CreasePattern {
        CreasePattern {
            vertices: vec![glam::DVec3::ZERO; 6],
            edges: vec![edge(0, 1), edge(2, 0), PatternEdge { alias_of: Some(EdgeId(0)), ..edge(1, 0) }],
            ..CreasePattern::default()
        }
    }

    #[test]
    fn sides_know_their_triangles_in_orientation() {
        let pattern = square();
        let triangles = [[0, 1, 2], [0, 2, 5]].map(|t| t.map(VertexId));
        let mesh = Mesh::new(&pattern, &triangles, vec![FaceId(0); 2]).expect("a square");
        assert_eq!(mesh.node_count(), 4, "vertices 3 and 4 are isolated");
        assert_eq!(mesh.node_of_vertex[3], None);
        assert_eq!(mesh.sides.len(), 5);
        // In the order of their nodes: 0-1, 0-2, 0-3, 1-2, 2-3.
        assert_eq!(mesh.side_of_edge, vec![Some(SideId(0)), Some(SideId(1)), Some(SideId(0))]);

        let diagonal = &mesh.sides[mesh.side_of_edge[1].expect("a side").index()];
        // The first triangle has its corners in the order 2, 0, 1: so the side runs from 2 to 0.
        assert_eq!(diagonal.nodes, [NodeId(2), NodeId(0)]);
        assert_eq!(diagonal.triangles, [Some(TriangleId(0)), Some(TriangleId(1))]);
        assert_eq!(diagonal.apexes, [Some(NodeId(1)), Some(NodeId(3))]);
        assert_eq!(mesh.sides_of_node.row(0).len(), 3);
        assert_eq!(mesh.triangles_of_node.row(3), &[TriangleId(1)]);
    }

    #[test]
    fn a_third_triangle_and_a_wrong_turn_are_refused() {
        let triangles = [[0, 1, 2], [0, 2, 5], [0, 2, 3]].map(|t| t.map(VertexId));
        let error = Mesh::new(&square(), &triangles, vec![FaceId(0); 3]).expect_err("three at one side");
        assert!(error.to_string().contains("vertices 0, 2"), "{error}");
        assert_eq!(error.place(), Place::Vertices(vec![VertexId(0), VertexId(2)]));
        let triangles = [[0, 1, 2], [2, 0, 5]].map(|t| t.map(VertexId));
        assert!(Mesh::new(&square(), &triangles, vec![FaceId(0); 2]).is_err(), "both run from 2 to 0");
    }
}
