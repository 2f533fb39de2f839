//! What keeps the layers of a nearly flat-folded sheet in their order, found in the exact flat-folded state.
//!
//! Two triangles that lie on each other meet in a convex polygon, whose corners are corners of one in the other or crossings of
//! their sides. Where each of these has its two things in the right order, the triangles are. The list is that of the flat state
//! and is kept: so a thing stays above the plane, or line, of another beyond its end too. There it is wanted where paper folds around
//! that end, for what lies in a fold must find its way into it, and nowhere else.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DVec2, DVec3};

use crate::ids::{NodeId, TriangleId};
use crate::layers::Stacking;
use crate::mesh::Mesh;

/// Things that are nearer than this in the flat state touch, in radii.
const TOUCHING: f64 = 1e-4;
/// Sides that enclose an angle of less sine than this do not cross.
const PARALLEL: f64 = 0.02;
/// What lies in a fold is kept from its crease if it is nearer than this in the flat state, in radii.
const AT_CREASE: f64 = 2e-3;
/// Folds back to back on one line are kept apart if they share more of it, in radii.
const SHARED: f64 = 1e-2;

type Edge = [NodeId; 2];

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
}

/// A node that stays on one side of a line, seen from above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Beside {
    pub(super) node: NodeId,
    /// The line's ends, which may be one.
    pub(super) line: Edge,
    /// Where on the line, 0 to 1.
    pub(super) along: f64,
    /// From the line to the node, of length 1.
    pub(super) away: DVec3,
}

/// The mesh of a sheet in its exact flat-folded state.
pub(super) struct Flat<'a> {
    mesh: &'a Mesh,
    at: Vec<DVec2>,
    ordered: BTreeSet<[TriangleId; 2]>,
    triangles_of: BTreeMap<Edge, Vec<TriangleId>>,
    sides_of: BTreeMap<NodeId, BTreeSet<Edge>>,
}

impl<'a> Flat<'a> {
    pub(super) fn new(mesh: &'a Mesh, positions: &[DVec3], stacking: &Stacking) -> Self {
        let (mut triangles_of, mut sides_of) = (BTreeMap::new(), BTreeMap::new());
        for (t, corners) in mesh.triangles.iter().enumerate() {
            for side in sides(*corners) {
                triangles_of.entry(side).or_insert_with(Vec::new).push(TriangleId::new(t));
                for node in side {
                    sides_of.entry(node).or_insert_with(BTreeSet::new).insert(side);
                }
            }
        }
        let ordered = stacking.triangles.iter().map(|[low, high]| [*low.min(high), *low.max(high)]).collect();
        Self { mesh, at: positions.iter().map(|p| p.truncate()).collect(), ordered, triangles_of, sides_of }
    }

    fn corners(&self, triangle: TriangleId) -> [NodeId; 3] {
        self.mesh.triangles[triangle.index()]
    }

    fn at(&self, node: NodeId) -> DVec2 {
        self.at[node.index()]
    }

    /// Whether two triangles lie on each other, and so have an order.
    pub(super) fn is_ordered(&self, one: TriangleId, other: TriangleId) -> bool {
        self.ordered.contains(&[one.min(other), one.max(other)])
    }

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
        Some(Relation { nodes, split: first.len(), above, sign, folded_around: [false; 4] })
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

    /// What lies in a fold and touches its crease is to stay inside of it, and the corner around which a fold lies outside of what
    /// lies in there.
    pub(super) fn nested(&self, relations: &[Relation]) -> Vec<Beside> {
        let mut all = Vec::new();
        for Relation { nodes: [a, b, c, d], split, folded_around, .. } in relations {
            if *split == 1 {
                for (place, side, inside) in [(1, [c, d], b), (2, [d, b], c), (3, [b, c], d)] {
                    if folded_around[place] {
                        let side = ordered(side.map(|n| *n));
                        all.extend(self.beside(*a, side, self.at(*inside) - self.at(side[0])));
                    }
                }
            } else {
                for (place, end, other) in [(0, a, [*c, *d]), (1, b, [*c, *d]), (2, c, [*a, *b]), (3, d, [*a, *b])] {
                    if let (true, Some(paper)) = (folded_around[place], self.paper(other)) {
                        all.extend(self.beside(*end, other, -paper));
                    }
                }
            }
        }
        distinct(all)
    }

    /// A node at a line that is to stay where `inwards` points to.
    fn beside(&self, node: NodeId, line: Edge, inwards: DVec2) -> Option<Beside> {
        let [from, to] = line.map(|n| self.at(n));
        let (along, off) = (to - from, self.at(node) - from);
        let across = along.perp().normalize_or_zero();
        let away = if across.dot(inwards) < 0.0 { -across } else { across };
        let share = off.dot(along) / along.length_squared();
        let near = away.dot(off).abs() < AT_CREASE && (-0.05..=1.05).contains(&share);
        near.then(|| Beside { node, line, along: share.clamp(0.0, 1.0), away: away.extend(0.0) })
    }

    /// On which side of a side its paper lies; `None` where on both.
    fn paper(&self, side: Edge) -> Option<DVec2> {
        let [from, to] = side.map(|n| self.at(n));
        let apexes = self.triangles_of[&side].iter().flat_map(|t| self.corners(*t)).filter(|n| !side.contains(n));
        let apexes: Vec<DVec2> = apexes.map(|n| self.at(n) - from).collect();
        let left = |apex: &DVec2| (to - from).perp_dot(*apex) > 0.0;
        let first = *apexes.first()?;
        apexes.iter().all(|apex| left(apex) == left(&first)).then_some(first)
    }

    /// Folds that lie back to back on one line are to leave it free between them: only so four of them that meet in a point find
    /// room to lie upon each other in a circle.
    pub(super) fn back_to_back(&self) -> Vec<Beside> {
        let folded = |(_, triangles): &(&Edge, &Vec<TriangleId>)| match triangles[..] {
            [one, other] => self.is_ordered(one, other),
            _ => false,
        };
        let folds: Vec<(&Edge, &Vec<TriangleId>)> = self.triangles_of.iter().filter(folded).collect();
        let left_of = |[from, to]: Edge, t: TriangleId| {
            let middle = self.corners(t).iter().map(|n| self.at(*n)).sum::<DVec2>() / 3.0;
            (self.at(to) - self.at(from)).perp_dot(middle - self.at(from)) > 0.0
        };
        let mut all = Vec::new();
        for (place, (one, triangles)) in folds.iter().enumerate() {
            for (other, others) in &folds[place + 1..] {
                let shared = length_shared(one.map(|n| self.at(n)), other.map(|n| self.at(n)));
                if shared < SHARED || left_of(**one, triangles[0]) == left_of(**one, others[0]) {
                    continue;
                }
                for t in *triangles {
                    for u in others.iter().filter(|u| !self.is_ordered(*t, **u)) {
                        all.extend(self.apart(*t, *u));
                    }
                }
            }
        }
        distinct(all)
    }

    /// Two triangles that lie beside each other in the flat state are to stay so: on the two sides of the line that parts them best.
    pub(super) fn apart(&self, one: TriangleId, other: TriangleId) -> Vec<Beside> {
        let both = [one, other].map(|t| self.corners(t));
        let mut best = (f64::NEG_INFINITY, DVec2::ZERO);
        for (own, others, turn) in [(both[0], both[1], -1.0), (both[1], both[0], 1.0)] {
            for k in 0..3 {
                let [a, b, c] = [0, 1, 2].map(|i| self.at(own[(k + i) % 3]));
                let across = (b - a).perp().normalize_or_zero();
                let outwards = if across.dot(c - a) > 0.0 { -across } else { across };
                let gap = others.iter().map(|n| outwards.dot(self.at(*n) - a)).fold(f64::INFINITY, f64::min);
                if gap > best.0 {
                    best = (gap, turn * outwards);
                }
            }
        }
        let away = best.1.extend(0.0);
        let pairs = both[0].into_iter().flat_map(|n| both[1].map(|m| (n, m))).filter(|(n, m)| n != m);
        pairs.map(|(node, other)| Beside { node, line: [other; 2], along: 0.0, away }).collect()
    }
}

/// Each once, but for directions that enclose less than some tenths of a degree.
pub(super) fn distinct(all: Vec<Beside>) -> Vec<Beside> {
    let mut known = BTreeSet::new();
    let about = |x: f64| (256.0 * x).round() as i64;
    let mut is_new = |own: &Beside| known.insert((own.node, own.line, about(own.away.x), about(own.away.y)));
    all.into_iter().filter(|own| is_new(own)).collect()
}

fn ordered([a, b]: Edge) -> Edge {
    [a.min(b), a.max(b)]
}

fn sorted(mut corners: [NodeId; 3]) -> [NodeId; 3] {
    corners.sort_unstable();
    corners
}

fn sides([a, b, c]: [NodeId; 3]) -> [Edge; 3] {
    [[a, b], [b, c], [c, a]].map(ordered)
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

/// The length over which two segments lie upon each other.
fn length_shared([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> f64 {
    let along = (b - a).normalize_or_zero();
    if [c, d].iter().any(|p| along.perp_dot(*p - a).abs() > AT_CREASE) {
        return 0.0;
    }
    let [s, t] = [c, d].map(|p| along.dot(p - a));
    (s.max(t).min(a.distance(b)) - s.min(t).max(0.0)).max(0.0)
}
