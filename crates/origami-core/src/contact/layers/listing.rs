//! Which pairs are known: a list that is made anew where nodes have moved far, and those of it that are due soon.

use glam::DVec3;

use super::super::drift::nearer;
use super::Layers;

/// Pairs are listed up to so many skins beyond the gap where few are found there. More: lists last longer and are longer.
pub(in crate::contact) const MOST_SKINS: f64 = 4.0;
/// As many pairs for each node are few, and many.
pub(in crate::contact) const FEW: usize = 4;
pub(in crate::contact) const MANY: usize = 32;
/// Pairs that may come near within about so many evaluations are looked at in each of them.
const SOON: f64 = 8.0;
/// Or within a move of this share of the gap.
const AT_REST: f64 = 0.1;

impl Layers {
    /// Lists the pairs anew where nodes have moved so far that others may be nearer than `distance`; true if so.
    pub(super) fn list_for(&mut self, positions: &[DVec3], distance: f64) -> bool {
        let most = 0.5 * (self.contact.gap + self.room - distance);
        if !self.listed_at.is_empty() {
            if self.way - self.listed_way <= most {
                return false;
            }
            // What is not listed was farther apart; it cannot come nearer than that before the way is so much longer.
            let half = 0.5 * nearer(&self.listed_at, positions, self.reach() + self.finder.thickest());
            self.listed_way = self.way - half;
            if half <= most {
                return false;
            }
        }
        self.list(positions);
        true
    }

    /// Lists the pairs anew.
    pub(super) fn list(&mut self, positions: &[DVec3]) {
        if !self.listed_at.is_empty() {
            let listed = self.pairs.len();
            if listed <= FEW * positions.len() {
                self.room *= 2.0;
            } else if listed > MANY * positions.len() {
                self.room *= 0.5;
            }
        }
        self.room = self.room.clamp(self.least_room, self.least_room.max(MOST_SKINS * self.skin));
        self.finder.find(positions, self.reach(), &mut self.pairs, &mut self.gaps);
        self.due.clear();
        self.due.extend(self.gaps.iter().map(|gap| gap + 2.0 * self.way));
        self.listed_at.clear();
        self.listed_at.extend_from_slice(positions);
        self.listed_way = self.way;
        self.soon.forget();
        self.groups.clear();
    }

    /// Pairs whose gap is below this are listed, in radii.
    pub(super) fn reach(&self) -> f64 {
        self.contact.gap + self.room
    }

    /// Sees to it that all pairs that are due before `bound` are known.
    pub(super) fn look_ahead(&mut self, bound: f64) {
        let later = (SOON * 2.0 * self.last).max(AT_REST * self.contact.gap);
        self.soon.look_ahead(bound, later, (&self.pairs, &mut self.due));
    }
}
