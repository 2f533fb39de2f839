//! How far the nodes may move.

use glam::DVec3;

use super::super::limit::{FLOOR, Shares, WITHIN, limit_pair};
use super::Layers;
use crate::ids::NodeId;

impl Layers {
    /// Shortens moves from the positions last measured so that nothing goes through anything: no node beyond a plane between
    /// the nearest points of a pair. Moves that are in no pair's way stay whole. The result has the share of each move that is
    /// left, by node; all 1 where nothing was in the way.
    pub(crate) fn limit(&mut self, positions: &[DVec3], moves: &[DVec3]) -> &[f64] {
        self.lengths.clear();
        self.lengths.extend(moves.iter().map(|by| by.length()));
        self.shares.clear();
        self.shares.resize(moves.len(), 1.0);
        let largest = self.lengths.iter().copied().fold(0.0, f64::max);
        let bound = self.look_for_limits(positions, largest);
        let farthest = self.reach();
        let Self { pairs, lengths, shares, soon, groups, way, contact, .. } = self;
        let most = |nodes: &[NodeId]| nodes.iter().map(|n| lengths[n.index()]).fold(0.0, f64::max);
        let mut look = |number: u32, due: f64| {
            let pair = &pairs[number as usize];
            let (first, second) = pair.nodes.split_at(pair.split);
            let within = WITHIN * (most(first) + most(second)) + FLOOR * pair.width;
            if due - 2.0 * *way >= within {
                return None;
            }
            let near = pair.near(number, positions);
            if near.gap < within {
                limit_pair(pair, &near, (positions, moves), Shares(shares));
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
            if *due - 2.0 * *way < WITHIN * (first + second) + FLOOR * contact.gap {
                group.pairs(places).for_each(|number| _ = look(number, *due));
            }
        }
        &self.shares
    }

    /// Whether some pair may be in the way of moves no longer than this, in radii, from the positions last measured.
    pub(crate) fn in_the_way(&mut self, positions: &[DVec3], largest: f64) -> bool {
        let bound = self.look_for_limits(positions, largest);
        self.soon.is_due(bound) || self.groups.is_due(bound)
    }

    /// Sees to it that all pairs are known that may be in the way of moves no longer than this: they are due before the result.
    fn look_for_limits(&mut self, positions: &[DVec3], largest: f64) -> f64 {
        self.look_for_near_within(positions, 2.0 * WITHIN * largest + FLOOR * self.contact.gap)
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
