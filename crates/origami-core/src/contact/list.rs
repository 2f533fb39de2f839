//! Contact for those who compute it elsewhere: the list of pairs that may touch, and the plain formulas to compare with.

use glam::DVec3;

use super::Contact;
use super::finder::Finder;
use super::layers::{FEW, LONGEST, Layers, MANY, MOST_SKINS, SKIN};
use super::pairs::{Near, Pair};
use crate::ids::NodeId;
use crate::mesh::Mesh;

/// A list is made anew before two nodes could have come so near to each other that but this share of a skin is left of its room.
const LEFT: f64 = 0.1;

/// A point and a triangle, or two edges, that may touch.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ListedPair {
    /// The point and the corners, or the ends of both edges.
    pub nodes: [NodeId; 4],
    /// How many of these the first thing has: 1 of a point and a triangle, 2 of two edges.
    pub split: usize,
    /// The distance at which it is closed, in radii: 0 of paper without thickness.
    pub closed: f64,
    /// The gap from which it pushes, in radii.
    pub width: f64,
    /// Of two edges the product of their squared lengths and of the squared sine below which they are nearly parallel, and
    /// eased out; 0 of a point and a triangle.
    pub eased: f64,
}

impl ListedPair {
    fn of(pair: &Pair) -> Self {
        let Pair { nodes, split, closed, width, eased } = *pair;
        Self { nodes, split, closed, width, eased }
    }
}

/// The pairs of a sheet that may touch, found anew when it has moved.
///
/// A list holds all pairs that can push, and all that a move can close, until a node has come [`PairList::spent`] from where it
/// was and then makes one move more of at most [`PairList::longest_move`].
#[derive(Clone, Debug)]
pub struct PairList {
    finder: Finder,
    skin: f64,
    /// How far beyond the gap pairs are listed.
    room: f64,
    gap: f64,
    pairs: Vec<Pair>,
    gaps: Vec<f64>,
}

impl PairList {
    /// Of a sheet with its nodes at `rest`, in radii; nothing is listed yet.
    #[must_use]
    pub fn new(mesh: &Mesh, rest: &[DVec3], contact: Contact) -> Self {
        let finder = Finder::new(mesh, rest, contact);
        let skin = SKIN * finder.median_edge();
        Self { finder, skin, room: skin, gap: contact.gap, pairs: Vec::new(), gaps: Vec::new() }
    }

    /// Lists the pairs anew, with the nodes at `positions`, one for each node of the sheet.
    pub fn list(&mut self, positions: &[DVec3]) {
        self.finder.find(positions, self.gap + self.room, &mut self.pairs, &mut self.gaps);
    }

    /// Lists the pairs anew, farther than before where they were few and less far where they were many, as the relaxation on the processor does.
    pub fn list_on(&mut self, positions: &[DVec3]) {
        if self.pairs.len() <= FEW * positions.len() {
            self.room = (2.0 * self.room).min(MOST_SKINS * self.skin);
        } else if self.pairs.len() > MANY * positions.len() {
            self.room = (0.5 * self.room).max(self.skin);
        }
        self.list(positions);
    }

    /// The pairs that were listed last, always in the same order.
    pub fn pairs(&self) -> impl ExactSizeIterator<Item = ListedPair> + '_ {
        self.pairs.iter().map(ListedPair::of)
    }

    /// The least gap of all listed pairs where they were listed, in radii; infinite where there are none.
    #[must_use]
    pub fn least_gap(&self) -> f64 {
        self.gaps.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// How far a node may be from where it was listed, in radii, before another list is needed.
    #[must_use]
    pub fn spent(&self) -> f64 {
        0.5 * (self.room - LEFT * self.skin) - self.longest_move()
    }

    /// The farthest that a node may move in one evaluation, in radii.
    #[must_use]
    pub fn longest_move(&self) -> f64 {
        LONGEST * self.skin
    }
}

/// Constants that the shaders share, by the names that they have there.
#[doc(hidden)]
pub mod constants {
    pub use super::super::barrier::NEARER;
    pub use super::super::distance::PARALLEL;
    pub use super::super::limit::{USABLE, WITHIN};
}

/// Contact by the plain formulas, for whoever computes it in another way and compares.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct PlainContact(Layers);

/// A pair that pushes: itself, the weights of its points, the direction from the second thing to the first, and the gap.
#[doc(hidden)]
pub type Pushing = (ListedPair, [f64; 4], DVec3, f64);

impl PlainContact {
    /// Of a sheet with its nodes at `rest`, measured at `positions`.
    #[must_use]
    pub fn new(mesh: &Mesh, (rest, positions): (&[DVec3], &[DVec3]), contact: Contact) -> Self {
        let mut layers = Layers::new(mesh, rest, contact, false);
        layers.measure(positions);
        Self(layers)
    }

    /// The pairs that push.
    #[must_use]
    pub fn pushing(&self) -> Vec<Pushing> {
        let told = |(pair, near): (&Pair, &Near)| (ListedPair::of(pair), near.weights, near.normal, near.gap);
        self.0.pushing().map(told).collect()
    }

    /// Forces on the nodes, and what they add to the masses.
    #[must_use]
    pub fn forces(&self, positions: &[DVec3]) -> (Vec<DVec3>, Vec<f64>) {
        let (mut forces, mut sums) = (vec![DVec3::ZERO; positions.len()], vec![0.0; positions.len()]);
        self.0.add(positions, &mut forces, &mut sums);
        (forces, sums)
    }

    /// The share of its move that each node may make where planes stand still.
    pub fn limit(&mut self, positions: &[DVec3], moves: &[DVec3]) -> Vec<f64> {
        self.0.limit_standing(positions, moves).to_vec()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::catalog;
    use crate::model::{Material, Model};

    #[test]
    fn until_a_list_is_spent_no_pair_beyond_it_pushes() {
        let model = Model::new(&catalog::generate("square-twist", &[]).expect("a pattern"), &Material::default());
        let model = model.expect("a model");
        let mut list = PairList::new(&model.mesh, &model.rest, Contact::default());
        list.list(&model.rest);
        // Two nodes that come towards each other as far as they can.
        let closer = 2.0 * (list.spent() + list.longest_move());
        assert!(closer < list.room && list.spent() > list.longest_move(), "{closer} of {}", list.room);
        assert!(list.longest_move() > 0.0 && list.least_gap() > 0.0);
        let listed: Vec<ListedPair> = list.pairs().collect();
        let reach = Contact::default().gap + list.room;
        let mut all = PairList { room: 3.0, ..list.clone() };
        all.list(&model.rest);
        assert!(all.pairs.len() > listed.len(), "some are too far apart");
        let near = all.pairs().zip(&all.gaps).filter(|(_, gap)| **gap < reach).map(|(pair, _)| pair);
        assert!(near.eq(listed), "those that are near, in their order");
        // Few pairs: the next list lasts longer.
        let before = list.spent();
        (0..5).for_each(|_| list.list_on(&model.rest));
        assert!(list.spent() > before && 2.0 * (list.spent() + list.longest_move()) < list.room);
        assert!(list.room <= MOST_SKINS * list.skin);
    }
}
