//! Checks that no node leaves its bounds, coordinate by coordinate, while the nodes are moved.

use super::lane::{GatherScatter, Mask, Num};
use super::real::Quad64;

/// How far nodes may be, and move in one step; in radii.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    pub(crate) farthest: f64,
    pub(crate) longest_move: f64,
}

/// Notes whether all coordinates seen so far are small enough for their vectors to be in bounds.
#[derive(Clone, Copy)]
pub(super) struct BoundsWatch<L: GatherScatter> {
    farthest: Num<L::Position>,
    longest_move: Num<L::Node>,
    positions_in_bounds: Mask<L::Position>,
    moves_in_bounds: Mask<L::Node>,
}

impl<L: GatherScatter> BoundsWatch<L> {
    #[inline(always)]
    pub(super) fn new(lane: L, bounds: Bounds) -> Self {
        let share = 1.0 / 3.0_f64.sqrt();
        let farthest = Num::splat(lane.position(), share * bounds.farthest);
        let longest_move = Num::splat(lane.node(), share * bounds.longest_move);
        let (no_position, no_move) = (Num::splat(lane.position(), 0.0), Num::splat(lane.node(), 0.0));
        Self {
            farthest,
            longest_move,
            positions_in_bounds: no_position.less(farthest),
            moves_in_bounds: no_move.less(longest_move),
        }
    }

    /// Takes note of a node that moved by `moved` and is now at `position`.
    #[inline(always)]
    pub(super) fn see(&mut self, position: Num<L::Position>, moved: Num<L::Node>) {
        self.positions_in_bounds = self.positions_in_bounds & position.abs().less(self.farthest);
        self.moves_in_bounds = self.moves_in_bounds & moved.abs().less(self.longest_move);
    }

    /// True only if every node seen is certainly in bounds; NaN counts as out of bounds.
    #[inline(always)]
    pub(super) fn in_bounds(self) -> bool {
        self.positions_in_bounds.all() && self.moves_in_bounds.all()
    }
}

/// Moves a node by `displacement`; the result is its new position.
#[inline(always)]
pub(super) fn displaced<L: GatherScatter>(
    lane: L,
    position: &mut Quad64,
    displacement: Num<L::Node>,
) -> Num<L::Position> {
    let new = Num { lane: lane.position(), raw: lane.load_position(*position) }
        + Num { lane: lane.position(), raw: lane.widen(displacement.raw) };
    *position = lane.store_position(new.raw);
    new
}
