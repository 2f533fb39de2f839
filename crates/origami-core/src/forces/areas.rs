//! Areas: springs that keep a triangle from collapsing to a line. The paper has none; they are ours.
//!
//! With r the area over a fifth of that at rest, the energy is `k (1/r - 2 + r)` where r < 1, and 0 elsewhere: it begins
//! with neither slope nor jump, and no energy brings r to 0. k is [`Model::k_area`] times the perimeter at rest. With D twice
//! the area and T a fifth of that at rest, `F = -k (1/T - T/D^2) dD/d.`, and `dD/da = n x (c - b)` with the unit normal n.

use glam::DVec3;

use super::corner_angles::Triangle;
use crate::ids::{NodeId, TriangleId};
use crate::model::{DEGENERATE, Model};

/// The share of its area at rest below which a triangle resists.
pub const THRESHOLD: f64 = 0.2;

/// The spring of one triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Area {
    /// A force times a length.
    pub(crate) stiffness: f64,
    /// Twice the area below which it acts.
    pub(crate) threshold: f64,
}

impl Area {
    /// That of a triangle that has the corners `rest` at rest; `None` where it is too thin to have one.
    pub(crate) fn new(k_area: f64, rest: [DVec3; 3]) -> Option<Self> {
        let [a, b, c] = rest;
        let sides = [b - a, c - b, a - c].map(DVec3::length);
        let doubled_area = (b - a).cross(c - a).length();
        let longest = sides.into_iter().fold(0.0, f64::max);
        let thick = longest >= DEGENERATE && doubled_area >= DEGENERATE * longest;
        let stiffness = k_area * sides.iter().sum::<f64>();
        thick.then_some(Self { stiffness, threshold: THRESHOLD * doubled_area })
    }

    fn energy(&self, doubled_area: f64) -> f64 {
        let r = doubled_area / self.threshold;
        self.stiffness * (1.0 / r - 2.0 + r)
    }

    /// First derivative of the energy by twice the area.
    pub(crate) fn slope(&self, doubled_area: f64) -> f64 {
        self.stiffness * (1.0 / self.threshold - self.threshold / (doubled_area * doubled_area))
    }

    /// Second derivative.
    pub(crate) fn curvature(&self, doubled_area: f64) -> f64 {
        2.0 * self.stiffness * self.threshold / doubled_area.powi(3)
    }
}

/// The triangles whose areas resist at `positions`: those that have shrunk to nothing have no direction, and so no force.
pub(crate) fn acting<'a>(
    model: &'a Model,
    positions: &'a [DVec3],
) -> impl Iterator<Item = (TriangleId, [NodeId; 3], Triangle, Area)> + 'a {
    let triangles = if model.k_area() > 0.0 { &model.mesh.triangles[..] } else { &[] };
    triangles.iter().enumerate().filter_map(|(t, nodes)| {
        let triangle = Triangle::new(nodes.map(|n| positions[n.index()]));
        if triangle.collapsed() {
            return None;
        }
        let area = Area::new(model.k_area(), nodes.map(|n| model.rest[n.index()]))?;
        (triangle.doubled_area() < area.threshold).then(|| (TriangleId::new(t), *nodes, triangle, area))
    })
}

/// The triangles whose areas resist with the nodes at `positions` (in radii, by node): those with less than [`THRESHOLD`] of
/// their area at rest.
pub fn resisting<'a>(model: &'a Model, positions: &'a [DVec3]) -> impl Iterator<Item = TriangleId> + 'a {
    acting(model, positions).map(|(triangle, ..)| triangle)
}

/// Adds the forces of all areas.
pub(super) fn add_forces(model: &Model, positions: &[DVec3], forces: &mut [DVec3]) {
    for (_, nodes, triangle, area) in acting(model, positions) {
        let slope = area.slope(triangle.doubled_area());
        for (node, gradient) in nodes.into_iter().zip(triangle.area_gradient()) {
            forces[node.index()] -= gradient * slope;
        }
    }
}

/// Energy of all areas: `k (1/r - 2 + r)` each.
#[must_use]
pub fn energy(model: &Model, positions: &[DVec3]) -> f64 {
    acting(model, positions).map(|(_, _, triangle, area)| area.energy(triangle.doubled_area())).sum()
}
