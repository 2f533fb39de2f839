//! Whether nodes are where they can be: looked at in passing, coordinate by coordinate.

use super::lane::{Mask, Mesh, Num};
use super::real::Quad64;

/// How far nodes may be, and move in one step; in radii.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    pub(crate) farthest: f64,
    pub(crate) longest_move: f64,
}

/// Sees whether coordinates are so small that the vectors are in bounds.
#[derive(Clone, Copy)]
pub(super) struct Watch<L: Mesh> {
    farthest: Num<L::Place>,
    longest_move: Num<L::Node>,
    places_hold: Mask<L::Place>,
    moves_hold: Mask<L::Node>,
}

impl<L: Mesh> Watch<L> {
    #[inline(always)]
    pub(super) fn new(lane: L, bounds: Bounds) -> Self {
        let share = 1.0 / 3.0_f64.sqrt();
        let farthest = Num::splat(lane.place(), share * bounds.farthest);
        let longest_move = Num::splat(lane.node(), share * bounds.longest_move);
        let (no_place, no_move) = (Num::splat(lane.place(), 0.0), Num::splat(lane.node(), 0.0));
        Self { farthest, longest_move, places_hold: no_place.less(farthest), moves_hold: no_move.less(longest_move) }
    }

    /// Sees a node that moved by `moved` and is now at `place`. What is not a number does not hold.
    #[inline(always)]
    pub(super) fn see(&mut self, place: Num<L::Place>, moved: Num<L::Node>) {
        self.places_hold = self.places_hold & place.abs().less(self.farthest);
        self.moves_hold = self.moves_hold & moved.abs().less(self.longest_move);
    }

    /// Whether all that it saw are surely in bounds.
    #[inline(always)]
    pub(super) fn holds(self) -> bool {
        self.places_hold.all() && self.moves_hold.all()
    }
}

/// Moves a node.
#[inline(always)]
pub(super) fn moved<L: Mesh>(lane: L, place: &mut Quad64, way: Num<L::Node>) -> Num<L::Place> {
    let new =
        Num { lane: lane.place(), raw: lane.load_place(*place) } + Num { lane: lane.place(), raw: lane.widen(way.raw) };
    *place = lane.store_place(new.raw);
    new
}
