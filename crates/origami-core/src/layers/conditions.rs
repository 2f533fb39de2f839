//! What folds demand of layers: paper does not go through paper.

use crate::model::Crease;
use crate::model::Model;
use glam::{DVec2, DVec3};

use super::order::{Literal, Order};
use super::overlap::{length_inside, length_shared};
use super::pairs::{Flat, PARALLEL, Pairs};

/// Lines nearer than this count as one, in radii; shorter common parts are rounding.
const MARGIN: f64 = 3e-3;

/// A side of two triangles that both lie in a stack of layers.
struct Joint {
    triangles: [u32; 2],
    /// Whether one triangle lies on the other, rather than beside it.
    folded: bool,
    ends: [DVec2; 2],
    /// The first triangle's corner off the side.
    apex: DVec2,
}

/// Adds all demands to `order`.
///
/// `angles` are those of the creases, in radians; where there are none, they are taken to fold as the pattern asks.
pub fn add(model: &Model, positions: &[DVec3], angles: &[f64], pairs: &Pairs, order: &mut Order) {
    for pair in 0..pairs.triangles.len() {
        if let Some(above) = pairs.clear(pair) {
            order.demand(Literal { pair, turned: false }, above);
        }
    }
    directions(model, angles, pairs, order);
    for pair in 0..pairs.triangles.len() {
        if let Some(above) = pairs.own(pair) {
            order.demand(Literal { pair, turned: false }, above);
        }
    }
    let joints = joints(model, positions, pairs);
    let corners = |t: u32| {
        let flat = Flat::new(pairs.up[t as usize]);
        model.mesh.triangles[t as usize].map(|n| flat.of(positions[n.index()]))
    };
    // No layer that goes on past a joint lies between its two triangles, nor above one and below the other.
    for joint in &joints {
        let [t, u] = joint.triangles;
        for (third, _) in pairs.of(t as usize) {
            let [Some(on_t), Some(on_u)] = [t, u].map(|face| order.is_above(face, *third)) else { continue };
            if length_inside(joint.ends, &corners(*third), MARGIN) > MARGIN {
                order.demand_even(&[on_t, on_u]);
            }
        }
    }
    between_joints(pairs, order, &joints);
}

/// A valley lays its second triangle on the front of the first, a mountain on the back.
fn directions(model: &Model, angles: &[f64], pairs: &Pairs, order: &mut Order) {
    let angle = |(index, crease): (usize, &Crease)| angles.get(index).copied().unwrap_or(crease.full_target);
    for (angle, crease) in model.creases.iter().enumerate().map(|crease| (angle(crease), crease.1)) {
        if angle.abs() <= 0.1 {
            continue;
        }
        let [Some(one), Some(two)] = model.mesh.sides[crease.side.index()].triangles else { continue };
        if let Some(above) = order.is_above(one.0, two.0) {
            let front_is_up = pairs.normals[one.index()].dot(pairs.up[one.index()]) > 0.0;
            order.demand(above, (angle > 0.0) == front_is_up);
        }
    }
}

fn joints(model: &Model, positions: &[DVec3], pairs: &Pairs) -> Vec<Joint> {
    let mut joints = Vec::new();
    for side in &model.mesh.sides {
        let ([Some(one), Some(two)], Some(apex)) = (side.triangles, side.apexes[0]) else { continue };
        let [up, up2] = [one, two].map(|t| pairs.up[t.index()]);
        let folded = pairs.between(one.0, two.0).is_some();
        let flat = pairs.normals[one.index()].dot(pairs.normals[two.index()]) > PARALLEL;
        if up == DVec3::ZERO || up != up2 || !(folded || flat) {
            continue;
        }
        let plane = Flat::new(up);
        let seen = |n: crate::ids::NodeId| plane.of(positions[n.index()]);
        joints.push(Joint { triangles: [one.0, two.0], folded, ends: side.nodes.map(seen), apex: seen(apex) });
    }
    joints
}

/// Two joints at one place: folds lie in each other or beside each other, and do not interleave; and no layer goes through
/// a fold.
fn between_joints(pairs: &Pairs, order: &mut Order, joints: &[Joint]) {
    let mut joints_of = vec![Vec::new(); pairs.normals.len()];
    for (place, joint) in joints.iter().enumerate() {
        joint.triangles.iter().for_each(|t| joints_of[*t as usize].push(place));
    }
    for (place, one) in joints.iter().enumerate() {
        let [t, u] = one.triangles;
        // Only joints of triangles that lie on one of this joint's can bear on it.
        let mut others: Vec<usize> = { [t, u].into_iter().flat_map(|face| pairs.of(face as usize)) }
            .flat_map(|(face, _)| joints_of[*face as usize].iter().copied())
            .filter(|other| *other > place)
            .collect();
        others.sort_unstable();
        others.dedup();
        for other in others {
            let two = &joints[other];
            if length_shared(one.ends, two.ends, MARGIN) > MARGIN {
                let [v, w] = two.triangles;
                condition(order, [t, u, v, w], one, two);
            }
        }
    }
}

fn condition(order: &mut Order, [t, u, v, w]: [u32; 4], one: &Joint, two: &Joint) {
    let side = |joint: &Joint| (one.ends[1] - one.ends[0]).perp_dot(joint.apex - one.ends[0]) > 0.0;
    let same_side = side(one) == side(two);
    let even = |order: &mut Order, pairs: &[[u32; 2]]| {
        let literals: Option<Vec<_>> = pairs.iter().map(|[a, b]| order.is_above(*a, *b)).collect();
        if let Some(literals) = literals {
            order.demand_even(&literals);
        }
    };
    match (one.folded, two.folded) {
        (true, true) if same_side => even(order, &[[t, v], [v, u], [t, w], [w, u]]),
        (true, true) => {}
        // Two sheets that go on past the same line.
        (false, false) if same_side => even(order, &[[t, v], [u, w]]),
        (false, false) => even(order, &[[t, w], [u, v]]),
        // The half of the sheet that lies on the folded triangles' side.
        (true, false) => {
            let half = if same_side { v } else { w };
            even(order, &[[t, half], [u, half]]);
        }
        (false, true) => {
            let half = if same_side { t } else { u };
            even(order, &[[v, half], [w, half]]);
        }
    }
}
