//! How large the numbers are that go into the forces: what rounding takes its share of.

use glam::DVec3;
use origami_core::forces::areas::{THRESHOLD, resisting};
use origami_core::forces::{creases, damping};
use origami_core::ids::TriangleId;

use crate::layout::QUANTUM;
use crate::testing::cases::Case;

/// By how much rounding errors of a triangle's normal grow: its parts are rounded to a share of [`QUANTUM`] times the longest
/// side, and it is as long as that side times the height.
fn thinness(longest: f64, height: f64) -> f64 {
    1.0 + QUANTUM * longest / height
}

/// A crease's triangles as a bound sees them.
pub(crate) struct Bound {
    /// The lengths of the gradient's parts, summed without cancellation.
    pub(crate) gradient: f64,
    /// How much more the angle is off than in a triangle that is not thin.
    pub(crate) thinness: f64,
}

/// By crease; `None` where a triangle is collapsed.
pub(crate) fn of_creases(case: &Case) -> Vec<Option<Bound>> {
    let bound = |crease: &origami_core::model::Crease| {
        let points = crease.nodes.map(|n| case.state.positions[n.index()]);
        creases::hinge(points)?;
        let [p1, p2, p3, p4] = points;
        let e = p4 - p3;
        let mut bound = Bound { gradient: 0.0, thinness: 1.0 };
        for apex in [p1, p2] {
            let height = e.cross(apex - p3).length() / e.length();
            let longest = e.length().max((apex - p3).length());
            let foot = (apex - p3).length() / e.length();
            bound.gradient += (2.0 + foot) / height;
            bound.thinness = bound.thinness.max(thinness(longest, height));
        }
        Some(bound)
    };
    case.model.creases.iter().map(bound).collect()
}

/// By node: all that is summed there, by magnitude, with what rounding amplifies. A beam's elongation comes of squares in two
/// parts and is rounded to a share of [`QUANTUM`]. `damped`: with the damping.
pub(crate) fn of_forces(case: &Case, damped: bool) -> Vec<f64> {
    let (model, state) = (&case.model, &case.state);
    let distance = |i: usize, j: usize| state.positions[i].distance(state.positions[j]);
    let mut sums = vec![0.0; model.node_count()];
    for (beam, c) in model.beams.iter().zip(damping::coefficients(model)) {
        let [i, j] = beam.nodes.map(|n| n.index());
        let apart = state.velocities[i].distance(state.velocities[j]);
        let elongation = (distance(i, j) - beam.rest_length).abs() + QUANTUM;
        for n in [i, j] {
            sums[n] += beam.stiffness * elongation + if damped { c * apart } else { 0.0 };
        }
    }
    let springs = model.creases.iter().zip(of_creases(case)).zip(&state.targets);
    for ((crease, bound), target) in springs {
        let Some(bound) = bound else { continue };
        // Angles are rounded to a share of pi.
        let moment = crease.stiffness * (std::f64::consts::PI + target.abs());
        for n in crease.nodes {
            sums[n.index()] += moment * bound.gradient * bound.thinness;
        }
    }
    for corners in &model.corner_angles {
        let [a, b, c] = corners.nodes.map(|n| n.index());
        let sides = [distance(a, b), distance(b, c), distance(c, a)];
        let longest = sides.iter().copied().fold(0.0, f64::max);
        let [p, q, r] = [a, b, c].map(|n| state.positions[n]);
        let height = (q - p).cross(r - p).length() / longest;
        let pull: f64 = sides.iter().map(|side| 1.0 / side).sum();
        for n in [a, b, c] {
            sums[n] += std::f64::consts::PI * model.material.k_face * pull * thinness(longest, height);
        }
    }
    for (nodes, area) in of_areas(case) {
        for n in nodes {
            sums[n] += area.slope * area.longest * area.amplified;
        }
    }
    sums
}

/// An area that resists.
struct Area {
    /// The parts of the slope of its energy by twice the area, without cancellation.
    slope: f64,
    curvature: f64,
    longest: f64,
    /// By how much rounding errors of the area grow, now and at rest.
    amplified: f64,
}

fn of_areas(case: &Case) -> Vec<([usize; 3], Area)> {
    let (model, positions) = (&case.model, &case.state.positions);
    let own = |triangle: TriangleId| {
        let nodes = model.mesh.triangles[triangle.index()].map(|n| n.index());
        let shape = |points: [DVec3; 3]| {
            let [a, b, c] = points;
            let sides = [b - a, c - b, a - c].map(DVec3::length);
            (sides, (b - a).cross(c - a).length())
        };
        let (sides, doubled_area) = shape(nodes.map(|n| positions[n]));
        let (at_rest, doubled_at_rest) = shape(nodes.map(|n| model.rest[n]));
        let longest = sides.into_iter().fold(0.0, f64::max);
        let threshold = THRESHOLD * doubled_at_rest;
        let stiffness = model.k_area() * at_rest.iter().sum::<f64>();
        let from_sides = (at_rest[0] * at_rest[2] / doubled_at_rest).powi(2);
        let area = Area {
            slope: stiffness * (1.0 / threshold + threshold / doubled_area.powi(2)),
            curvature: 2.0 * stiffness * threshold / doubled_area.powi(3),
            longest,
            amplified: 3.0 * (thinness(longest, doubled_area / longest) + from_sides),
        };
        (nodes, area)
    };
    resisting(model, positions).map(own).collect()
}

/// By node: what its row sum is made of, without cancellation and with what rounding amplifies.
pub(crate) fn of_row_sums(case: &Case) -> Vec<f64> {
    let (model, positions) = (&case.model, &case.state.positions);
    let mut sums = vec![0.0; model.node_count()];
    for beam in &model.beams {
        beam.nodes.iter().for_each(|n| sums[n.index()] += 2.0 * beam.stiffness);
    }
    for (crease, bound) in model.creases.iter().zip(of_creases(case)) {
        let Some(bound) = bound else { continue };
        let all = crease.stiffness * bound.gradient * bound.gradient * bound.thinness;
        crease.nodes.iter().for_each(|n| sums[n.index()] += all);
    }
    for corners in &model.corner_angles {
        let points = corners.nodes.map(|n| positions[n.index()]);
        let sides = [0, 1, 2].map(|i| 1.0 / points[i].distance(points[(i + 1) % 3]));
        let pull: f64 = sides.iter().sum();
        corners.nodes.iter().for_each(|n| sums[n.index()] += 4.0 * model.material.k_face * pull * pull);
    }
    for (nodes, area) in of_areas(case) {
        nodes.iter().for_each(|n| sums[*n] += 3.0 * area.curvature * area.longest * area.longest * area.amplified);
    }
    sums
}
