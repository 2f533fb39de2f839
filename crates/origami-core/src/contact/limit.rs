//! How far the nodes of a pair may move: planes in place of continuous collision detection (after the planar bounds of Divide
//! and Truncate, 2026).
//!
//! Between the nearest points a and b of two convex things lies a slab that is free of both, and a plane divides it. One that
//! stands still leaves each node its share of a move whatever others make of theirs: half-spaces are convex. One that moves along
//! with what it divides leaves more, for what recedes makes room for what comes after it, and what turns together does not come
//! nearer; but it counts on the shares that all four nodes make. No time of impact is sought.

use glam::{DVec2, DVec3};

use super::pairs::{Near, Pair};
use crate::ids::NodeId;

/// The share of a gap that one move may use up.
pub const USABLE: f64 = 0.5;
/// A pair is looked at before a move if its gap, but for what is never used up of it, is below so many times what both of its
/// things may move: what is not looked at uses up no more than a move may.
pub const WITHIN: f64 = 1.0 / USABLE;
/// The share of a pair's width that is never used up: without it gaps would shrink to nothing by halves. Larger: what is pressed
/// into narrow folds has less room.
pub(super) const FLOOR: f64 = 1e-5;

/// And so many radii: the direction from one nearest point to the other is off by rounding over the gap, and with it what lies
/// between.
const LEAST: f64 = 5e-8;
/// What rounding may take from what lies between two things, as a share of their extent.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// What rounding may add to what is used up.
const SLACK: f64 = 1.0 + 1e-9;
/// A plane turns by no more than this in one move, in radians.
const MOST_TILT: f64 = 0.1;
/// Places are on one line where the area that they span is less than this share of their extent squared.
const FLAT: f64 = 1e-8;

/// What divides one pair in the way of its own moves. Its nodes are those of the pair, and all numbers are by node.
#[derive(Clone, Debug)]
pub(super) struct Plane {
    pub(super) nodes: [NodeId; 4],
    /// How many nodes the first thing has.
    split: usize,
    /// Of the nearest points; those of the second thing are below 0.
    weights: [f64; 4],
    /// In the plane: where each node is, from their middle, and its whole move.
    places: [DVec2; 4],
    along: [DVec2; 4],
    /// The rest of the whole move, towards the first thing.
    up: [f64; 4],
    /// How far each is behind the front of its thing.
    room: [f64; 4],
    distance: f64,
    /// Whether something lies between for sure, as far as rounding goes, and what may be used up of the gap.
    certain: bool,
    usable: f64,
    /// The shares that are left as long as it stands still.
    pub(super) standing: [f64; 4],
}

impl Plane {
    /// Of a pair measured at `positions`, which is never to use up that share of its width; none where whole moves are not in each
    /// other's way.
    ///
    /// What lies between is measured along the normal, node by node, so that it is free however well the normal is known.
    pub(super) fn new(pair: &Pair, near: &Near, floor: f64, (positions, moves): (&[DVec3], &[DVec3])) -> Option<Self> {
        let at = pair.points(positions);
        let by = pair.nodes.map(|node| moves[node.index()]);
        let middle = 0.25 * (at[0] + at[1] + at[2] + at[3]);
        let from_middle = at.map(|at| at - middle);
        let distance = near.gap + pair.closed;
        let slab = Slab::best(&from_middle, pair.split, (near.normal, distance));
        let mut plane = Self {
            nodes: pair.nodes,
            split: pair.split,
            weights: near.weights,
            places: [DVec2::ZERO; 4],
            along: [DVec2::ZERO; 4],
            up: by.map(|by| by.dot(slab.normal)),
            room: slab.room,
            distance,
            certain: slab.between > 0.0,
            usable: USABLE * (slab.between - pair.closed - (floor * pair.width).max(LEAST)).max(0.0),
            standing: [0.0; 4],
        };
        // Else nothing moves.
        if plane.certain {
            plane.standing = plane.stand();
            if plane.standing == [1.0; 4] {
                return None;
            }
        }
        let (x, y) = slab.normal.try_normalize().unwrap_or(DVec3::Z).any_orthonormal_pair();
        let flat = |v: DVec3| DVec2::new(v.dot(x), v.dot(y));
        (plane.places, plane.along) = (from_middle.map(flat), by.map(flat));
        Some(plane)
    }

    /// 1 where up is away from the other thing, -1 where it is towards it.
    fn away(&self, node: usize) -> f64 {
        if node < self.split { 1.0 } else { -1.0 }
    }

    /// How far each of the two things comes beyond its front at most, of so much by each node.
    fn beyond(&self, by: impl Fn(usize) -> f64) -> [f64; 2] {
        [0..self.split, self.split..4]
            .map(|thing| thing.map(|i| by(i) - self.room[i]).fold(f64::NEG_INFINITY, f64::max))
    }

    /// The shares of whole moves that keep each node on its side of a plane that stands still. What lies between is shared out
    /// as the things would use it.
    fn stand(&self) -> [f64; 4] {
        let advance = |i: usize| -self.away(i) * self.up[i];
        let beyond = self.beyond(advance).map(|by| by.max(0.0));
        let all = beyond[0] + beyond[1];
        std::array::from_fn(|i| {
            let usable = if all > 0.0 { self.usable * beyond[usize::from(i >= self.split)] / all } else { self.usable };
            let (advance, room) = (advance(i), self.room[i] + usable);
            if advance > room && advance > 0.0 { (room / advance).max(0.0) } else { 1.0 }
        })
    }

    /// Whether nothing meets anything if the nodes make these shares of their moves.
    pub(super) fn is_free(&self, shares: [f64; 4]) -> bool {
        self.stands_for(shares) || self.used(shares) <= SLACK * self.usable
    }

    /// What these shares of the moves use up of the gap, as a plane sees it that moves and turns along with them; infinite
    /// where it would turn far, or nothing is certain.
    ///
    /// By the end of the move it has risen by `rise + slope . x` at the place x: by as much as the nodes there, but for what the
    /// nearest points have come nearer to each other, half of it each. Four places of which the nearest points are one are so met
    /// exactly. A node at x that moves by v along the plane is above it, at the time t from 0 to 1, by
    /// `h + t (up - rise - slope . x) - t^2 slope . v`: never less than h but for what is counted here. A plane that has turned is
    /// nearer than it is below or above.
    fn used(&self, shares: [f64; 4]) -> f64 {
        let ups: [f64; 4] = std::array::from_fn(|i| shares[i] * self.up[i]);
        let nearer = -(0..4).map(|i| self.weights[i] * ups[i]).sum::<f64>();
        let wanted: [f64; 4] = std::array::from_fn(|i| ups[i] + 0.5 * self.away(i) * nearer);
        let rise = 0.25 * wanted.iter().sum::<f64>();
        let (mut xx, mut xy, mut yy, mut towards) = (0.0, 0.0, 0.0, DVec2::ZERO);
        for (place, wanted) in self.places.iter().zip(wanted) {
            xx += place.x * place.x;
            xy += place.x * place.y;
            yy += place.y * place.y;
            towards += *place * (wanted - rise);
        }
        let (area, extent) = (xx * yy - xy * xy, xx + yy);
        let slope = DVec2::new(yy * towards.x - xy * towards.y, xx * towards.y - xy * towards.x) / area;
        let tilt = slope.length();
        if !self.certain || area.is_nan() || area <= FLAT * extent * extent || tilt > MOST_TILT {
            return f64::INFINITY;
        }
        let beyond = self.beyond(|i| {
            let away = self.away(i);
            let risen = rise + slope.dot(self.places[i]);
            away * (risen - ups[i]) + (away * shares[i] * slope.dot(self.along[i])).max(0.0)
        });
        beyond[0] + beyond[1] + 0.5 * tilt * tilt * self.distance
    }

    /// The shares to go on with: these if they are free; else all less by as much as they use too much, or those that a plane
    /// leaves that stands still, which are free whatever others do, the kinder of both.
    pub(super) fn wanted(&self, shares: [f64; 4]) -> [f64; 4] {
        if self.stands_for(shares) {
            return shares;
        }
        let used = self.used(shares);
        if used <= SLACK * self.usable {
            return shares;
        }
        let (alike, least) = (self.usable / used, |of: [f64; 4]| of.into_iter().fold(1.0, f64::min));
        if alike * least(shares) > least(self.standing) { shares.map(|share| alike * share) } else { self.standing }
    }

    fn stands_for(&self, shares: [f64; 4]) -> bool {
        shares.iter().zip(&self.standing).all(|(share, most)| share <= most)
    }

    /// The largest share of all moves alike that is free: what they use up of the gap grows at least as they do.
    #[cfg(feature = "newton")]
    pub(super) fn alike(&self) -> f64 {
        let used = self.used([1.0; 4]);
        let standing = self.standing.into_iter().fold(1.0, f64::min);
        if used <= SLACK * self.usable { 1.0 } else { standing.max(self.usable / used) }
    }
}

/// What lies between two things along a normal, for sure.
struct Slab {
    normal: DVec3,
    /// By node: how far it is behind the front of its thing.
    room: [f64; 4],
    between: f64,
}

impl Slab {
    fn new(points: &[DVec3; 4], split: usize, normal: DVec3) -> Self {
        let heights = points.map(|point| point.dot(normal));
        let (first, second) = heights.split_at(split);
        let lowest = first.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = second.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let room = std::array::from_fn(|i| if i < split { heights[i] - lowest } else { highest - heights[i] });
        let extent = points.iter().map(|point| point.length_squared()).fold(0.0, f64::max).sqrt();
        Self { normal, room, between: lowest - highest - ROUNDING * extent }
    }

    /// Along the normal from one nearest point to the other; where they are so near that rounding has turned it, along that of
    /// the triangle, or of both edges, if more lies between there.
    fn best(points: &[DVec3; 4], split: usize, (normal, distance): (DVec3, f64)) -> Self {
        let own = Self::new(points, split, normal);
        if own.between > 0.5 * distance {
            return own;
        }
        let [p, q, r, s] = *points;
        let other = if split == 1 { (r - q).cross(s - q) } else { (q - p).cross(s - r) };
        let sign = if other.dot(normal) < 0.0 { -1.0 } else { 1.0 };
        let other = Self::new(points, split, sign * other.normalize_or_zero());
        if other.between > own.between { other } else { own }
    }
}

#[cfg(test)]
mod tests;
