//! Pairs that have the same two nearest points: they are measured once, and push together.
//!
//! Where a corner of a layer lies on a corner of another, so do the edges and triangles that meet there: up to 48 pairs, of which
//! most have these corners as their nearest points. To be near each other is a convex matter, so that two corners are the nearest
//! points of two edges that end there if and only if neither edge goes on towards the other corner; of a triangle both edges at
//! its corner count. So it is with a corner and a place within an edge.

mod place;

use glam::DVec3;

use super::lanes::{Arms, not_below_zero};
use super::soon::Brief;
use super::stars::{ARMS, Star};
use crate::ids::NodeId;
use place::Place;

/// A corner, and another corner or an edge, with the pairs whose nearest points are there and on it. Edges that are eased out
/// are in none.
#[derive(Clone, Debug)]
pub(super) struct Group {
    /// Both corners, or the corner and one end of the edge.
    pub(super) corners: [NodeId; 2],
    /// The other end of the edge; else the second corner.
    pub(super) end: NodeId,
    /// Which edge it is of the second corner's star.
    along: Option<u8>,
    /// Pairs of two edges, by edge of the second star: which edges of the first, as bits.
    edges: [u8; ARMS],
    /// Pairs of a corner and a triangle of the other's star, as bits: those of the first corner, and those of the second.
    points: [u8; 2],
    /// The edges of both stars that must not go on towards the other thing, as bits.
    needs: [u8; 2],
    /// Until nodes have moved so far none of its edges is eased out.
    until: f64,
    /// The group before with the same first corner.
    before: u32,
}

/// The places of the pairs of a group in the list: those of edges as in [`Group::edges`], then those of points.
pub(super) type Places = [[u32; ARMS]; ARMS + 2];

/// No group.
const NONE: u32 = u32::MAX;

impl Group {
    /// How many pairs it has.
    pub(super) fn count(&self) -> u32 {
        u64::from_le_bytes(self.edges).count_ones() + u16::from_le_bytes(self.points).count_ones()
    }

    pub(super) fn is_empty(&self) -> bool {
        u64::from_le_bytes(self.edges) == 0 && self.points == [0; 2]
    }

    /// The pairs that it has, as places in the list.
    pub(super) fn pairs<'a>(&self, places: &'a Places) -> impl Iterator<Item = u32> + use<'a> {
        let rows = self.edges.into_iter().chain(self.points).zip(places);
        rows.flat_map(|(row, places)| bits(row).map(|i| places[i]))
    }

    /// From the second nearest point to the first, and how far along its edge the second is.
    #[inline(always)]
    pub(super) fn apart(&self, positions: &[DVec3]) -> (DVec3, f64) {
        let [p, q] = self.corners.map(|corner| positions[corner.index()]);
        let apart = p - q;
        if self.along.is_none() {
            return (apart, 0.0);
        }
        let edge = positions[self.end.index()] - q;
        let along = apart.dot(edge) / edge.length_squared();
        (apart - along * edge, along)
    }

    /// Sees to it that its pairs are its own, and tells `lost` of those that are no more. `apart` and `along` are as
    /// [`Group::apart`] has them; nodes have moved so far along their `path`.
    #[inline(always)]
    pub(super) fn look(
        &mut self,
        (apart, along): (DVec3, f64),
        (stars, arms): ([&Star; 2], [&Arms; 2]),
        path: f64,
        (places, lost): (&Places, &mut impl FnMut(u32)),
    ) {
        let (within, on) = match self.along {
            Some(arm) => (along > 0.0 && along < 1.0, 1 << arm),
            None => (true, 0),
        };
        let first = not_below_zero(&arms[0].dot(apart));
        let second = not_below_zero(&arms[1].dot(-apart)) | on;
        if within && self.needs[0] & !first | self.needs[1] & !second == 0 && self.until >= path {
            return;
        }
        self.keep(if within { [first, second] } else { [0; 2] }, (stars, arms), path, (places, lost));
    }

    /// Keeps the pairs of these edges and of these triangles alone, and of them those that are not eased out.
    #[cold]
    fn keep(
        &mut self,
        [first, second]: [u8; 2],
        (stars, arms): ([&Star; 2], [&Arms; 2]),
        path: f64,
        (places, lost): (&Places, &mut impl FnMut(u32)),
    ) {
        let looks = self.until < path;
        let mut until = f64::INFINITY;
        self.needs = [0; 2];
        let [of_edges, of_points] = [&places[..ARMS], &places[ARMS..]];
        for (k, (own, places)) in self.edges.iter_mut().zip(of_edges).enumerate() {
            for j in bits(*own) {
                let mut keep = second >> k & first >> j & 1 == 1;
                if keep && looks {
                    let room = uneased(arms[0].at(j), arms[1].at(k), stars[0].eased[j] * stars[1].eased[k]);
                    keep = room >= 0.0;
                    until = until.min(room.max(0.0));
                }
                if keep {
                    self.needs[0] |= 1 << j;
                    self.needs[1] |= 1 << k;
                } else {
                    *own &= !(1 << j);
                    lost(places[j]);
                }
            }
        }
        for (i, (own, places)) in self.points.iter_mut().zip(of_points).enumerate() {
            // The corner of the triangles is the other one.
            let (star, there) = if i == 0 { (stars[1], second) } else { (stars[0], first) };
            for triangle in bits(*own) {
                let arms = star.triangles[triangle];
                if arms & !there == 0 {
                    self.needs[1 - i] |= arms;
                } else {
                    *own &= !(1 << triangle);
                    lost(places[triangle]);
                }
            }
        }
        if looks {
            self.until = path + until;
        }
    }
}

/// The numbers of the bits that are set.
fn bits(of: u8) -> impl Iterator<Item = usize> {
    (0..u8::BITS as usize).filter(move |i| of >> i & 1 == 1)
}

/// How far nodes may move before two edges are eased out; below 0 where they are. `inverse` is that of what
/// [`super::barrier::mollifier`] wants of them.
fn uneased(one: DVec3, other: DVec3, inverse: f64) -> f64 {
    let (is, least) = (one.cross(other).length(), 1.0 / inverse.sqrt());
    let lengths = one.length() + other.length();
    ((is - least) / (2.5 * lengths)).min(0.1 * lengths)
}

/// All groups of a list of pairs.
#[derive(Clone, Debug)]
pub(super) struct Groups {
    pub(super) stars: Vec<Star>,
    pub(super) all: Vec<Group>,
    /// By group, as of pairs: never where it has none.
    pub(super) due: Vec<f64>,
    pub(super) places: Vec<Places>,
    /// By node: the edges of its star, as last placed.
    pub(super) arms: Vec<Arms>,
    /// By node: the last of its groups.
    last: Vec<u32>,
}

impl Groups {
    pub(super) fn new(stars: Vec<Star>) -> Self {
        let last = vec![NONE; stars.len()];
        Self { stars, all: Vec::new(), due: Vec::new(), places: Vec::new(), arms: Vec::new(), last }
    }

    /// Takes note of where the nodes are.
    pub(super) fn place(&mut self, positions: &[DVec3]) {
        if !self.all.is_empty() {
            let arms = self.stars.iter().zip(positions).map(|(star, at)| Arms::from(*at, &star.ends, positions));
            self.arms.clear();
            self.arms.extend(arms);
        }
    }

    /// No pair is in a group.
    pub(super) fn clear(&mut self) {
        self.all.clear();
        self.due.clear();
        self.places.clear();
        self.last.fill(NONE);
    }

    /// Whether a pair of any may be nearer than asked.
    pub(super) fn is_due(&self, bound: f64) -> bool {
        self.due.iter().any(|due| *due < bound)
    }

    /// Takes a pair whose nearest points are where its weights are not 0, as bits of its nodes. False if it is for no group.
    pub(super) fn take(&mut self, pair: &Brief, points: bool, weights: u8, due: f64) -> bool {
        let Some(Place { corners, along, row, bit }) = Place::of(pair.nodes, points, weights, &self.stars) else {
            return false;
        };
        let last = &mut self.last[corners[0].index()];
        let mut at = *last;
        while let Some(group) = self.all.get(at as usize)
            && (group.corners != corners || group.along != along)
        {
            at = group.before;
        }
        if at == NONE {
            let Ok(new) = u32::try_from(self.all.len()) else { return false };
            at = new;
            let end = along.map_or(corners[1], |arm| self.stars[corners[1].index()].ends[usize::from(arm)]);
            self.all.push(Group {
                corners,
                end,
                along,
                edges: [0; ARMS],
                points: [0; 2],
                needs: [0; 2],
                until: due,
                before: *last,
            });
            self.due.push(due);
            self.places.push([[0; ARMS]; ARMS + 2]);
            *last = new;
        }
        let (group, places) = (&mut self.all[at as usize], &mut self.places[at as usize]);
        let own = if row < ARMS { &mut group.edges[row] } else { &mut group.points[row - ARMS] };
        *own |= 1 << bit;
        places[row][bit] = pair.number;
        self.due[at as usize] = self.due[at as usize].min(due);
        group.until = f64::NEG_INFINITY;
        true
    }
}
