//! How far the nodes may move.

use glam::DVec3;

use super::super::limit::{Plane, WITHIN};
use super::Layers;
use crate::ids::NodeId;

/// So often all planes that are asked for too much let their nodes go on more slowly alike; then so often each of them stands
/// still; and then they all do, which is free whatever others do. More: fewer moves are shortened far, and each is dearer.
const ALIKE: usize = 4;
const STANDING: usize = 8;

impl Layers {
    /// Shortens moves from the positions last measured so that nothing goes through anything: a plane is between the two things of
    /// each pair all the way. Moves that are in no pair's way stay whole. The result has the share of each move that is left,
    /// by node; all 1 where nothing was in the way.
    pub(crate) fn limit(&mut self, positions: &[DVec3], moves: &[DVec3]) -> &[f64] {
        self.divide(positions, moves);
        for _ in 0..ALIKE {
            if !self.shorten(Plane::wanted) {
                return &self.shares;
            }
        }
        for _ in 0..STANDING {
            if !self.shorten(|plane, shares| if plane.is_free(shares) { shares } else { plane.standing }) {
                return &self.shares;
            }
        }
        self.shorten(|plane, _| plane.standing);
        &self.shares
    }

    /// As [`Layers::limit`], by planes that all stand still.
    pub(crate) fn limit_standing(&mut self, positions: &[DVec3], moves: &[DVec3]) -> &[f64] {
        self.divide(positions, moves);
        self.shorten(|plane, _| plane.standing);
        &self.shares
    }

    /// The largest share of all moves alike with which nothing goes through anything.
    #[cfg(feature = "newton")]
    pub(crate) fn limit_alike(&mut self, positions: &[DVec3], moves: &[DVec3]) -> f64 {
        self.divide(positions, moves);
        self.planes.iter().map(Plane::alike).fold(1.0, f64::min)
    }

    /// Shares become those that each plane asks for of its nodes, where that is less; true if any has. All planes are asked of
    /// the same shares, so that their order is of no account.
    fn shorten(&mut self, wanted: impl Fn(&Plane, [f64; 4]) -> [f64; 4]) -> bool {
        let Self { planes, shares, old_shares, .. } = self;
        old_shares.clone_from(shares);
        let mut less = false;
        for plane in planes {
            let wanted = wanted(plane, plane.nodes.map(|n| old_shares[n.index()]));
            for (node, wanted) in plane.nodes.iter().zip(wanted) {
                let share = &mut shares[node.index()];
                less |= wanted < *share;
                *share = share.min(wanted);
            }
        }
        less
    }

    /// Finds the planes of all pairs that are in the way of whole moves.
    fn divide(&mut self, positions: &[DVec3], moves: &[DVec3]) {
        self.lengths.clear();
        self.lengths.extend(moves.iter().map(|by| by.length()));
        self.shares.clear();
        self.shares.resize(moves.len(), 1.0);
        self.planes.clear();
        let largest = self.lengths.iter().copied().fold(0.0, f64::max);
        let bound = self.look_for_limits(positions, largest);
        let farthest = self.reach();
        let Self { pairs, lengths, planes, soon, groups, way, contact, floor, .. } = self;
        let most = |nodes: &[NodeId]| nodes.iter().map(|n| lengths[n.index()]).fold(0.0, f64::max);
        let mut look = |number: u32, due: f64| {
            let pair = &pairs[number as usize];
            let (first, second) = pair.nodes.split_at(pair.split);
            let within = WITHIN * (most(first) + most(second)) + *floor * pair.width;
            if due - 2.0 * *way >= within {
                return None;
            }
            let near = pair.near(number, positions);
            if near.gap < within {
                planes.extend(Plane::new(pair, &near, *floor, (positions, moves)));
            }
            Some(near.gap.min(farthest) + 2.0 * *way)
        };
        for (brief, due) in soon.iter_mut().filter(|(_, due)| **due < bound) {
            *due = look(brief.number, *due).unwrap_or(*due);
        }
        let own = groups.all.iter().zip(&groups.places).zip(&groups.due);
        for ((group, places), due) in own.filter(|(_, due)| **due < bound) {
            // The longest that any of its nodes may move.
            let [first, second] = group.corners.map(|c| most(&[c]).max(most(&groups.stars[c.index()].ends)));
            if *due - 2.0 * *way < WITHIN * (first + second) + *floor * contact.gap {
                group.pairs(places).for_each(|number| _ = look(number, *due));
            }
        }
    }

    /// Whether some pair may be in the way of moves no longer than this, in radii, from the positions last measured.
    pub(crate) fn in_the_way(&mut self, positions: &[DVec3], largest: f64) -> bool {
        let bound = self.look_for_limits(positions, largest);
        self.soon.is_due(bound) || self.groups.is_due(bound)
    }

    /// Sees to it that all pairs are known that may be in the way of moves no longer than this: they are due before the result.
    fn look_for_limits(&mut self, positions: &[DVec3], largest: f64) -> f64 {
        self.look_for_near_within(positions, 2.0 * WITHIN * largest + self.floor * self.contact.gap)
    }

    /// Sees to it that all pairs are known whose gap may be below `within`: they are due before the result.
    pub(super) fn look_for_near_within(&mut self, positions: &[DVec3], within: f64) -> f64 {
        self.measured_at();
        let known = !self.near.is_empty();
        if self.list_for(positions, within.max(self.contact.gap)) && known {
            // They have other places in the list.
            self.measure(positions);
        }
        let bound = within + 2.0 * self.way;
        self.look_ahead(bound);
        bound
    }
}
