//! What lies beside each other in the exact flat-folded state, touches there, and is to stay beside each other near it.

use std::collections::BTreeSet;

use glam::{DVec2, DVec3};

use super::flat::{Edge, Flat, ordered};
use super::relations::Relation;
use crate::ids::{NodeId, TriangleId};

/// What lies in a fold is kept from its crease if it is nearer than this in the flat state, in radii.
const AT_CREASE: f64 = 2e-3;
/// Folds back to back on one line are kept apart if they share more of it, in radii.
const SHARED: f64 = 1e-2;

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

impl Flat<'_> {
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

/// The length over which two segments lie upon each other.
fn length_shared([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> f64 {
    let along = (b - a).normalize_or_zero();
    if [c, d].iter().any(|p| along.perp_dot(*p - a).abs() > AT_CREASE) {
        return 0.0;
    }
    let [s, t] = [c, d].map(|p| along.dot(p - a));
    (s.max(t).min(a.distance(b)) - s.min(t).max(0.0)).max(0.0)
}
