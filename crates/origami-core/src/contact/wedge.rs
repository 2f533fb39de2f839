//! The thickness between two faces that share a crease: a wedge.
//!
//! Two thick panels that are folded onto each other about a common edge of their middle planes cannot be a thickness apart
//! there. Were it asked for of all their parts alike, how far apart they come to lie would depend on how faces are cut into
//! triangles. So it grows from 0 at the crease in such a way that their centroids come to lie one thickness apart.

use std::collections::BTreeMap;

use glam::DVec3;

use super::distance::of_edges;
use crate::ids::{FaceId, NodeId};
use crate::mesh::{Mesh, Side};

/// No part of a wedge is thicker than so many times the paper.
pub(super) const THICKEST: f64 = 2.0;

/// The faces of a sheet, and the lines at which they meet.
#[derive(Clone, Debug)]
pub(super) struct Wedges {
    thickness: f64,
    face_of_triangle: Vec<FaceId>,
    faces_of_node: Vec<Vec<FaceId>>,
    faces_of_edge: Vec<Vec<FaceId>>,
    hinges: BTreeMap<[FaceId; 2], Vec<Hinge>>,
}

/// The line at which two faces meet in the flat sheet.
#[derive(Clone, Copy, Debug)]
struct Hinge {
    at: DVec3,
    along: DVec3,
    /// How far the narrower of the two faces reaches from it, in radii.
    width: f64,
}

impl Hinge {
    fn distance(&self, point: DVec3) -> f64 {
        (point - self.at).cross(self.along).length()
    }

    /// Where a point lies once its face is folded onto the other.
    fn mirrored(&self, point: DVec3) -> DVec3 {
        let foot = self.at + self.along * (point - self.at).dot(self.along);
        2.0 * foot - point
    }
}

impl Wedges {
    /// Those of a sheet with its nodes at `rest`, of paper so thick, in radii; `edges` are the sides that pairs are made of.
    pub(super) fn new(mesh: &Mesh, rest: &[DVec3], edges: &[&Side], thickness: f64) -> Self {
        let face = |triangle: usize| mesh.face_of_triangle[triangle];
        let unique = |mut faces: Vec<FaceId>| {
            faces.sort_unstable();
            faces.dedup();
            faces
        };
        let faces_of_node =
            mesh.triangles_of_node.iter().map(|row| unique(row.iter().map(|t| face(t.index())).collect()));
        let of_side = |side: &Side| unique(side.triangles.iter().flatten().map(|t| face(t.index())).collect());
        let mut corners: BTreeMap<FaceId, Vec<NodeId>> = BTreeMap::new();
        for (triangle, nodes) in mesh.triangles.iter().enumerate() {
            corners.entry(face(triangle)).or_default().extend(nodes);
        }
        let mut hinges: BTreeMap<[FaceId; 2], Vec<Hinge>> = BTreeMap::new();
        for side in edges {
            let [one, other] = *of_side(side).as_slice() else { continue };
            let [a, b] = side.nodes.map(|n| rest[n.index()]);
            let line = Hinge { at: a, along: (b - a).normalize_or_zero(), width: 0.0 };
            let reach =
                |face: FaceId| corners[&face].iter().map(|n| line.distance(rest[n.index()])).fold(0.0, f64::max);
            hinges.entry([one, other]).or_default().push(Hinge { width: reach(one).min(reach(other)), ..line });
        }
        Self {
            thickness,
            face_of_triangle: mesh.face_of_triangle.clone(),
            faces_of_node: faces_of_node.collect(),
            faces_of_edge: edges.iter().map(|side| of_side(side)).collect(),
            hinges,
        }
    }

    /// The thickness between a node and a triangle, of which `points` are the places at rest.
    pub(super) fn of_point(&self, node: NodeId, triangle: usize, points: &[DVec3; 4]) -> f64 {
        let other = [self.face_of_triangle[triangle]];
        self.least(&self.faces_of_node[node.index()], &other, |hinge| hinge.distance(points[0]))
    }

    /// The thickness between two edges, by their numbers, of which `points` are the places at rest.
    pub(super) fn of_edges(&self, [first, second]: [usize; 2], points: &[DVec3; 4]) -> f64 {
        let from = |hinge: &Hinge| {
            let [p, q, r, s] = *points;
            let folded = [p, q, hinge.mirrored(r), hinge.mirrored(s)];
            let weights = of_edges(&folded).weights;
            hinge.distance(weights[0] * p + weights[1] * q)
        };
        self.least(&self.faces_of_edge[first], &self.faces_of_edge[second], from)
    }

    /// The least of all pairs of faces; `from` is the distance from their line at which the two things meet.
    fn least(&self, first: &[FaceId], second: &[FaceId], from: impl Fn(&Hinge) -> f64) -> f64 {
        let mut least = f64::INFINITY;
        for (one, other) in first.iter().flat_map(|one| second.iter().map(move |other| (*one, *other))) {
            for hinge in self.hinges.get(&[one.min(other), one.max(other)]).into_iter().flatten() {
                least = least.min(THICKEST.min(2.0 * from(hinge) / hinge.width));
            }
        }
        self.thickness * if least.is_finite() { least } else { 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fold::Document;
    use crate::model::{Material, Model};
    use crate::pattern::CreasePattern;

    #[test]
    fn it_grows_from_the_crease_on_and_is_one_thickness_at_the_centroids() {
        let text = br#"{"vertices_coords": [[0,0],[1,0],[2,0],[3,0],[3,2],[2,2],[1,2],[0,2]],
            "edges_vertices": [[0,1],[1,2],[2,3],[3,4],[4,5],[5,6],[6,7],[7,0],[1,6],[2,5]],
            "edges_assignment": ["B","B","B","B","B","B","B","B","V","M"]}"#;
        let document = Document::from_slice(text).expect("a document");
        let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
        let model = Model::new(&pattern, &Material::default()).expect("a model");
        let edges: Vec<&Side> = model.mesh.sides.iter().collect();
        let wedges = Wedges::new(&model.mesh, &model.rest, &edges, 0.01);
        let face = |triangle: usize| model.mesh.face_of_triangle[triangle];
        let of_face =
            |wanted: FaceId| (0..model.mesh.triangles.len()).find(|t| face(*t) == wanted).expect("a triangle");
        let faces: Vec<FaceId> = (0..3).map(FaceId).collect();
        // Which panel is which follows from where its triangles are.
        let middle = |f: &FaceId| {
            let nodes = model.mesh.triangles[of_face(*f)];
            nodes.iter().map(|n| model.rest[n.index()].x).sum::<f64>() / 3.0
        };
        let mut by_place = faces.clone();
        by_place.sort_by(|a, b| middle(a).total_cmp(&middle(b)));
        let corner = model.node(crate::ids::VertexId(0)).expect("a node");
        let points = |node: NodeId| [model.rest[node.index()]; 4];
        let at = |panel: usize| wedges.of_point(corner, of_face(by_place[panel]), &points(corner));
        assert!((at(1) - 0.02).abs() < 1e-15, "the far end of a wedge: {}", at(1));
        assert_eq!(at(2), 0.01, "no common crease");
        let halfway = |x: f64| {
            let to_model = |x: f64| model.normalisation.to_model(DVec3::new(x, 1.0, 0.0));
            wedges.of_point(corner, of_face(by_place[1]), &[to_model(x); 4])
        };
        assert!((halfway(0.5) - 0.01).abs() < 1e-12 && (halfway(0.75) - 0.005).abs() < 1e-12, "{}", halfway(0.5));
    }
}
