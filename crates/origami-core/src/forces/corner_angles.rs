//! Corner angles (paper 2.4): springs that keep the shape of each triangle.
//!
//! At corner p between q and r, counterclockwise, with the unit normal n: `F = -k_face (alpha - alpha0) dalpha/d.`,
//! `dalpha/dq = -n x (q-p)/|q-p|^2`, `dalpha/dr = n x (r-p)/|r-p|^2`, `dalpha/dp` minus their sum (the paper prints the
//! quotient upside down). Both corners on a side pull along the same vector `n x (b-a)/|b-a|^2`, so that a triangle's
//! forces are one vector a side, with the difference of the two moments.

use glam::DVec3;

use super::angle::small;
use crate::model::{CornerAngles, Model};

/// By how much the three angles exceed those at rest, in radians.
///
/// Turning a corner's cosine and sine back by its rest angle leaves a small angle; the three sum to zero.
#[inline(always)]
pub(crate) fn deviations(corners: &CornerAngles, doubled_area: f64, dots: [f64; 2]) -> [f64; 3] {
    let deviation = |(cos, sin): (f64, f64), dot: f64| {
        let (y, x) = (doubled_area * cos - dot * sin, dot * cos + doubled_area * sin);
        small(y, x).unwrap_or_else(|| y.atan2(x))
    };
    let first = deviation(corners.rest[0], dots[0]);
    let second = deviation(corners.rest[1], dots[1]);
    [first, second, -(first + second)]
}

/// A triangle in one position.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle {
    /// Sides 0-1, 1-2 and 2-0.
    sides: [DVec3; 3],
    normal: DVec3,
    doubled_area: f64,
}

impl Triangle {
    #[inline(always)]
    pub(crate) fn new([a, b, c]: [DVec3; 3]) -> Self {
        let sides = [b - a, c - b, a - c];
        let normal = sides[2].cross(sides[0]);
        Self { sides, normal, doubled_area: normal.length() }
    }

    /// Whether it has shrunk to a line (or is not finite): it has no normal then, and pulls at nothing.
    pub(crate) fn collapsed(&self) -> bool {
        let has_area = self.doubled_area > f64::MIN_POSITIVE;
        !has_area
    }

    pub(crate) fn doubled_area(&self) -> f64 {
        self.doubled_area
    }

    /// How twice the area changes as each corner moves: `n x` the side opposite to it.
    pub(crate) fn area_gradient(&self) -> [DVec3; 3] {
        let [ab, bc, ca] = self.sides;
        [bc, ca, ab].map(|side| self.normal.cross(side) / self.doubled_area)
    }

    #[inline(always)]
    pub(crate) fn deviations(&self, corners: &CornerAngles) -> [f64; 3] {
        let [ab, bc, ca] = self.sides;
        deviations(corners, self.doubled_area, [-ab.dot(ca), -ab.dot(bc)])
    }

    /// `n x (b-a)/|b-a|^2` of each side.
    #[inline(always)]
    pub(crate) fn side_vectors(&self) -> [DVec3; 3] {
        self.sides.map(|s| self.normal.cross(s) * (1.0 / (self.doubled_area * s.length_squared())))
    }
}

/// Adds the forces of all corner angles.
pub(super) fn add_forces(model: &Model, positions: &[DVec3], forces: &mut [DVec3]) {
    for corners in &model.corner_angles {
        let nodes = corners.nodes.map(|n| n.index());
        let triangle = Triangle::new(nodes.map(|n| positions[n]));
        if triangle.collapsed() {
            continue;
        }
        let moments = triangle.deviations(corners).map(|d| -model.material.k_face * d);
        let [ab, bc, ca] = triangle.side_vectors();
        let along_ab = ab * (moments[0] - moments[1]);
        let along_bc = bc * (moments[1] - moments[2]);
        let along_ca = ca * (moments[2] - moments[0]);
        forces[nodes[0]] += along_ab - along_ca;
        forces[nodes[1]] += along_bc - along_ab;
        forces[nodes[2]] += along_ca - along_bc;
    }
}

/// Energy of all corner angles: `k_face (alpha - alpha0)^2 / 2` each.
#[must_use]
pub fn energy(model: &Model, positions: &[DVec3]) -> f64 {
    let squares = model.corner_angles.iter().map(|corners| {
        let triangle = Triangle::new(corners.nodes.map(|n| positions[n.index()]));
        let deviations = triangle.deviations(corners);
        deviations.iter().map(|d| d * d).sum::<f64>()
    });
    0.5 * model.material.k_face * squares.sum::<f64>()
}
