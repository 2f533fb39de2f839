//! What keeps the layers of a nearly flat-folded sheet in their order, found in the exact flat-folded state.
//!
//! Two triangles that lie on each other meet in a convex polygon, whose corners are corners of one in the other or crossings of
//! their sides. Where each of these has its two things in the right order, the triangles are. The list is that of the flat state
//! and is kept: so a thing stays above the plane, or line, of another beyond its end too. There it is wanted where paper folds around
//! that end, for what lies in a fold must find its way into it, and nowhere else.

use std::collections::BTreeMap;

use glam::DVec2;

use super::flat::{Edge, Flat, ordered, sides, sorted};
use crate::ids::{NodeId, TriangleId};
use crate::layers::Stacking;

/// Things that are nearer than this in the flat state touch, in radii.
const TOUCHING: f64 = 1e-4;
/// Sides that enclose an angle of less sine than this do not cross.
const PARALLEL: f64 = 0.02;

/// A node above or below a triangle, or a side above or below another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Relation {
    /// The node and the corners, or the ends of both sides.
    pub(super) nodes: [NodeId; 4],
    /// How many of these the first thing has: 1 or 2.
    pub(super) split: usize,
    /// Whether the first thing is above.
    above: bool,
    /// 1 or -1: with this the normal, of the triangle or of both sides, points from the second thing to the first.
    pub(super) sign: f64,
    /// By node: whether paper folds around the end there: that of a side at the node, of a triangle the side opposite to it.
    pub(super) folded_around: [bool; 4],
    /// How many times stiffer than others it is.
    pub(super) stiffer: f64,
}

impl Relation {
    /// Whether one of its things is of one triangle, and the other of the other.
    pub(super) fn is_between(&self, one: [NodeId; 3], other: [NodeId; 3]) -> bool {
        let (first, second) = self.nodes.split_at(self.split);
        let are_of = |nodes: &[NodeId], corners: [NodeId; 3]| nodes.iter().all(|n| corners.contains(n));
        are_of(first, one) && are_of(second, other) || are_of(first, other) && are_of(second, one)
    }
}

impl Flat<'_> {
    /// All relations of a stacking. Where the paper at a node lies on both sides of a triangle, or that of a side on both of
    /// another, it goes around it, and there is none.
    pub(super) fn relations(&self, stacking: &Stacking) -> Vec<Relation> {
        let mut found: BTreeMap<(Vec<NodeId>, Vec<NodeId>), Option<bool>> = BTreeMap::new();
        let mut add = |first: &[NodeId], second: &[NodeId], above: bool| {
            let swapped = first.len() == second.len() && second < first;
            let (key, above) = if swapped {
                ((second.to_vec(), first.to_vec()), !above)
            } else {
                ((first.to_vec(), second.to_vec()), above)
            };
            let known = found.entry(key).or_insert(Some(above));
            *known = known.filter(|known| *known == above);
        };
        for pair in &stacking.triangles {
            let [low, high] = pair.map(|t| self.corners(t));
            for (own, other, above) in [(low, high, false), (high, low, true)] {
                for node in own {
                    if !other.contains(&node) && covers(other.map(|n| self.at(n)), self.at(node)) {
                        add(&[node], &other, above);
                    }
                }
            }
            for one in sides(low) {
                for other in sides(high).iter().filter(|other| !other.iter().any(|n| one.contains(n))) {
                    if meet(one.map(|n| self.at(n)), other.map(|n| self.at(n))) {
                        add(&one, other, false);
                    }
                }
            }
        }
        let agreed = found.into_iter().filter_map(|(things, above)| Some((things, above?)));
        let mut relations: Vec<Relation> =
            agreed.filter_map(|((first, second), above)| self.relation(&first, &second, above)).collect();
        self.find_folds(&mut relations);
        relations
    }

    fn relation(&self, first: &[NodeId], second: &[NodeId], above: bool) -> Option<Relation> {
        let nodes: [NodeId; 4] = first.iter().chain(second).copied().collect::<Vec<_>>().try_into().ok()?;
        let [a, b, c, d] = nodes.map(|n| self.at(n));
        let up = if first.len() == 1 { (c - b).perp_dot(d - b) } else { (b - a).perp_dot(d - c) };
        let sign = if above { up.signum() } else { -up.signum() };
        Some(Relation { nodes, split: first.len(), above, sign, folded_around: [false; 4], stiffer: 1.0 })
    }

    /// Paper folds around an end where the next triangle, or side, has the first thing on its other side.
    fn find_folds(&self, relations: &mut [Relation]) {
        let (mut of_points, mut of_sides) = (BTreeMap::new(), BTreeMap::new());
        for Relation { nodes: [a, b, c, d], split, above, .. } in relations.iter().copied() {
            if split == 1 {
                of_points.insert((a, sorted([b, c, d])), above);
            } else {
                of_sides.insert(([a, b], [c, d]), above);
                of_sides.insert(([c, d], [a, b]), !above);
            }
        }
        for relation in relations {
            let ([a, b, c, d], above) = (relation.nodes, relation.above);
            if relation.split == 1 {
                for (place, side) in [(1, [c, d]), (2, [d, b]), (3, [b, c])] {
                    let beyond = |t: &TriangleId| of_points.get(&(a, sorted(self.corners(*t)))) == Some(&!above);
                    relation.folded_around[place] = self.triangles_of[&ordered(side)].iter().any(beyond);
                }
            } else {
                let around = |end: NodeId, own: Edge, other: Edge, above: bool| {
                    let beyond = |side: &Edge| *side != own && of_sides.get(&(*side, other)) == Some(&!above);
                    self.sides_of[&end].iter().any(beyond)
                };
                relation.folded_around = [
                    around(a, [a, b], [c, d], above),
                    around(b, [a, b], [c, d], above),
                    around(c, [c, d], [a, b], !above),
                    around(d, [c, d], [a, b], !above),
                ];
            }
        }
    }
}

/// Whether a point lies in a triangle or touches it.
fn covers(corners: [DVec2; 3], p: DVec2) -> bool {
    let [a, b, c] = corners;
    let turn = (b - a).perp_dot(c - a).signum();
    let inside = |from: DVec2, to: DVec2| turn * (to - from).normalize_or_zero().perp_dot(p - from) > -TOUCHING;
    inside(a, b) && inside(b, c) && inside(c, a)
}

/// Whether two segments cross or touch and are not parallel.
fn meet([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    let (u, v) = (b - a, d - c);
    let cross = u.perp_dot(v);
    if cross.abs() < PARALLEL * u.length() * v.length() {
        return false;
    }
    let [s, t] = [v, u].map(|along| ((c - a).perp_dot(along) / cross).clamp(0.0, 1.0));
    let [p, q] = [a + s * u, c + t * v];
    let near = |p: DVec2, from: DVec2, along: DVec2| {
        let share = ((p - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        p.distance(from + share * along) < TOUCHING
    };
    near(p, c, v) || near(q, a, u)
}
