//! Thick paper as solids.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec3;

use crate::ids::FaceId;
use crate::model::Model;

/// Each face of the pattern as a plate, half of it on either side of where the sheet is: points, and triangles whose corners
/// are seen counterclockwise from outside, for [`write_stl`](super::write_stl).
///
/// `positions` are by node, `thickness` is in their unit, above 0; larger: thicker plates. Every plate is a closed solid of its
/// own. A face that is bent stays whole, and is as thick as that along the mean normal at each node. Faces that are folded on
/// each other have no room near their crease and overlap there, as programs that slice solids for printing allow.
///
/// # Panics
/// If there are fewer positions than nodes.
#[must_use]
pub fn plates(model: &Model, positions: &[DVec3], thickness: f64) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let mut faces: BTreeMap<FaceId, Vec<[u32; 3]>> = BTreeMap::new();
    for (corners, face) in model.mesh.triangles.iter().zip(&model.mesh.face_of_triangle) {
        faces.entry(*face).or_default().push(corners.map(|n| n.0));
    }
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    for face in faces.values() {
        let mut normals: BTreeMap<u32, DVec3> = BTreeMap::new();
        for corners in face {
            let [a, b, c] = corners.map(|n| positions[n as usize]);
            corners.iter().for_each(|n| *normals.entry(*n).or_default() += (b - a).cross(c - a));
        }
        // By node: its point on the front, behind which that on the back follows.
        let mut place: BTreeMap<u32, u32> = BTreeMap::new();
        for (node, normal) in normals {
            place.insert(node, points.len() as u32);
            let half = 0.5 * thickness * normal.normalize_or_zero();
            let at = positions[node as usize];
            points.extend([at + half, at - half]);
        }
        let directed = || face.iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]);
        let inside: BTreeSet<[u32; 2]> = directed().collect();
        for corners in face {
            let [a, b, c] = corners.map(|n| place[&n]);
            triangles.extend([[a, b, c], [c + 1, b + 1, a + 1]]);
        }
        for [a, b] in directed().filter(|[a, b]| !inside.contains(&[*b, *a])) {
            let [a, b] = [place[&a], place[&b]];
            triangles.extend([[a + 1, b + 1, b], [a + 1, b, a]]);
        }
    }
    (points, triangles)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::catalog;
    use crate::model::Material;
    use crate::solve::{Relax, Solver};

    #[test]
    fn plates_are_closed_and_as_thick_as_asked() {
        let model = Model::new(&catalog::generate("miura", &[]).unwrap(), &Material::default()).unwrap();
        let folded = Relax::default().fold_from_rest(&model, 60.0).unwrap().state.positions;
        for positions in [&model.rest, &folded] {
            let (points, triangles) = plates(&model, positions, 0.01);
            let mut edges: BTreeMap<[u32; 2], i32> = BTreeMap::new();
            let mut volume = 0.0;
            for triangle in &triangles {
                let [a, b, c] = triangle.map(|n| points[n as usize]);
                volume += a.dot(b.cross(c)) / 6.0;
                for k in 0..3 {
                    let [p, q] = [triangle[k], triangle[(k + 1) % 3]];
                    *edges.entry([p.min(q), p.max(q)]).or_default() += if p < q { 1 } else { -1 };
                }
            }
            assert!(edges.values().all(|sum| *sum == 0), "every edge is gone along both ways");
            let area = |corners: &[crate::ids::NodeId; 3]| {
                let [a, b, c] = corners.map(|n| positions[n.index()]);
                0.5 * (b - a).cross(c - a).length()
            };
            let area: f64 = model.mesh.triangles.iter().map(area).sum();
            assert!((volume / (0.01 * area) - 1.0).abs() < 1e-3, "{volume} of {}", 0.01 * area);
        }
    }
}
