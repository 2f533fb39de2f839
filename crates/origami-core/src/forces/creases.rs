//! Creases (paper 2.3): hinges between two triangles with a spring towards a target angle.
//!
//! Nodes 1 and 2 are the apexes, 3 and 4 the ends; with `e = p4 - p3` and normals `n1 = e x (p1 - p3)`,
//! `n2 = (p2 - p3) x e`, the fold angle is `theta = atan2(|e| n2 . (p1 - p3), n1 . n2)`: 0 flat, valley positive.
//! `F_i = -k (theta - target) dtheta/dp_i`.

use glam::DVec3;

use super::angle::{Anchor, unwrapped};
use crate::model::{DEGENERATE, Model};

/// A hinge in one position: its angle as a direction, and how it changes as its nodes move.
#[derive(Clone, Copy, Debug)]
pub struct Hinge {
    y: f64,
    x: f64,
    /// `dtheta/dp`, for nodes 1 to 4, in radians per radius of the sheet.
    pub gradient: [DVec3; 4],
}

impl Hinge {
    /// The fold angle within half a turn, in radians.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.y.atan2(self.x)
    }
}

/// The hinge of four points; `None` where a triangle beside it is too thin for its angle to mean anything.
///
/// `dtheta/dp1 = n1/h1` and `dtheta/dp2 = n2/h2` with unit normals and the apexes' heights h over the crease; the ends
/// take the opposite, shared by the foot `s` of each height: `-(1 - s1) n1/h1 - (1 - s2) n2/h2` and
/// `-s1 n1/h1 - s2 n2/h2`. The paper's cotangents say the same.
#[inline(always)]
#[must_use]
pub fn hinge([p1, p2, p3, p4]: [DVec3; 4]) -> Option<Hinge> {
    const LIMIT: f64 = DEGENERATE * DEGENERATE;
    let (e, a1, a2) = (p4 - p3, p1 - p3, p2 - p3);
    let (n1, n2) = (e.cross(a1), a2.cross(e));
    let (squared, squared1, squared2) = (e.length_squared(), n1.length_squared(), n2.length_squared());
    // n1 and n2 are |e| h long.
    let least = LIMIT * squared;
    if !(squared >= LIMIT && squared1 >= least && squared2 >= least) {
        return None;
    }
    let length = squared.sqrt();
    let (g1, g2) = (n1 * (length / squared1), n2 * (length / squared2));
    let inverse = 1.0 / squared;
    let (s1, s2) = (a1.dot(e) * inverse, a2.dot(e) * inverse);
    let at_4 = -(g1 * s1 + g2 * s2);
    Some(Hinge { y: length * n2.dot(a1), x: n1.dot(n2), gradient: [g1, g2, -(g1 + g2) - at_4, at_4] })
}

/// Adds the forces of all creases and writes their angles. A crease whose triangle has collapsed keeps its last angle
/// and pulls at nothing until it opens again.
pub(super) fn add_forces(
    model: &Model,
    positions: &[DVec3],
    targets: &[f64],
    fold_angles: &mut [f64],
    anchors: &mut [Anchor],
    forces: &mut [DVec3],
) {
    let springs = model.creases.iter().zip(targets).zip(fold_angles).zip(anchors);
    for (((crease, target), angle), anchor) in springs {
        let nodes = crease.nodes.map(|n| n.index());
        let Some(hinge) = hinge(nodes.map(|n| positions[n])) else { continue };
        *angle = anchor.angle(hinge.y, hinge.x, *angle);
        let moment = crease.stiffness * (target - *angle);
        for (n, gradient) in nodes.into_iter().zip(hinge.gradient) {
            forces[n] += gradient * moment;
        }
    }
}

/// The fold angle of each crease at `positions`, whole turns chosen by the angles `previous`; in radians.
#[must_use]
pub fn fold_angles(model: &Model, positions: &[DVec3], previous: &[f64]) -> Vec<f64> {
    let creases = model.creases.iter().zip(previous);
    creases
        .map(|(crease, previous)| {
            let points = crease.nodes.map(|n| positions[n.index()]);
            hinge(points).map_or(*previous, |hinge| unwrapped(hinge.angle(), *previous))
        })
        .collect()
}

/// Energy of all creases at the given angles: `k (theta - target)^2 / 2` each.
#[must_use]
pub fn energy(model: &Model, fold_angles: &[f64], targets: &[f64]) -> f64 {
    let creases = model.creases.iter().zip(fold_angles).zip(targets);
    creases.map(|((crease, angle), target)| 0.5 * crease.stiffness * (angle - target).powi(2)).sum()
}
