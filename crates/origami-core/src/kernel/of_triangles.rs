//! The springs of a model as triangles have them: which sides are theirs, and what they do of the beams there.

use crate::forces::damping;
use crate::model::Model;

/// The springs of a model.
pub(super) struct OfTriangles {
    /// By triangle: the sides 0-1, 1-2 and 2-0.
    pub(super) sides: Vec<[u32; 3]>,
    /// Sides outside any triangle.
    pub(super) loose: Vec<u32>,
    /// By side.
    pub(super) damping: Vec<f64>,
    /// By triangle: cotangents of the first angle at rest and of the second, and 1; zeros where it has no springs there.
    pub(super) angles: Vec<[f64; 3]>,
}

impl OfTriangles {
    pub(super) fn new(model: &Model) -> Self {
        let triangles = &model.mesh.triangles;
        let (mut sides, mut loose) = (vec![[0; 3]; triangles.len()], Vec::new());
        for (side, s) in model.mesh.sides.iter().zip(0_u32..) {
            if side.triangles == [None; 2] {
                loose.push(s);
            }
            for triangle in side.triangles.iter().flatten() {
                let corners = &triangles[triangle.index()];
                let is_here =
                    |i: &usize| side.nodes.contains(&corners[*i]) && side.nodes.contains(&corners[(i + 1) % 3]);
                let corner = (0..3).find(is_here).expect("a side of a triangle joins two of its corners");
                sides[triangle.index()][corner] = s;
            }
        }
        let mut angles = vec![[0.0; 3]; if model.corner_angles.is_empty() { 0 } else { triangles.len() }];
        for own in &model.corner_angles {
            let [a, b] = own.rest.map(|(cos, sin)| cos / sin);
            angles[own.triangle.index()] = [a, b, 1.0];
        }
        Self { sides, loose, damping: damping::coefficients(model), angles }
    }

    /// The ends of the sides outside any triangle.
    pub(super) fn loose_ends(&self, model: &Model) -> Vec<[u32; 2]> {
        self.loose.iter().map(|side| model.mesh.sides[*side as usize].nodes.map(|n| n.0)).collect()
    }

    /// The part of a beam that each triangle at it does: each of two does half.
    pub(super) fn share_of(&self, model: &Model, side: u32) -> f64 {
        1.0 / model.mesh.sides[side as usize].triangles.iter().flatten().count().max(1) as f64
    }

    /// Rest length, and the stiffness of each triangle's share.
    pub(super) fn beam(&self, model: &Model, side: u32) -> [f64; 2] {
        let beam = &model.beams[side as usize];
        [beam.rest_length, self.share_of(model, side) * beam.stiffness]
    }
}
