//! Positions of a block's nodes, as near as its springs need them.
//!
//! In f64 they are what they are. In f32 they are whole numbers of a small unit, counted from one node of the block: differences
//! of those are exact, and have all the digits that an f32 has as long as they are no less than a hundredth of the block; a
//! whole number takes half the room of an f64, and turning it into an f32 half the work.

use super::blocks::{FILLING, NODES};
use super::real::Real;

/// Where the nodes of a block are.
#[derive(Clone, Debug)]
pub(crate) struct Near<R: Real> {
    /// By node of the block.
    pub(super) places: [R::Place; NODES],
    /// The unit of whole numbers, a power of two; 0 where places are positions.
    pub(super) unit: R,
}

impl<R: Real> Near<R> {
    /// With the nodes of the filling only.
    pub(super) fn new() -> Self {
        let mut places = [R::Place::default(); NODES];
        places[FILLING..].copy_from_slice(&R::FILLING);
        Self { places, unit: R::default() }
    }
}
