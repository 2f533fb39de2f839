//! What a block works with: its own copies, so that all it reads again and again is near.

use super::blocks::{CREASES, FILLING, FORCES, NODES};
use super::layout::DUMMY;
use super::real::{Quad64, Real};

/// Nodes and moments of the block that is at work.
#[derive(Clone, Debug)]
pub(super) struct Scratch<R: Real> {
    pub(super) positions: [Quad64; NODES],
    pub(super) velocities: [R::Quad; NODES],
    /// By crease of the block: numbers in proportion to the sines of fold angles, and moments.
    pub(super) sines: [R; CREASES],
    pub(super) moments: [R; CREASES],
    /// By chunk of triangles, corner after corner; then by chunk of loose beams.
    pub(super) forces: [R::Quad; FORCES],
}

impl<R: Real> Scratch<R> {
    pub(super) fn new() -> Self {
        let mut positions = [Quad64::default(); NODES];
        positions[FILLING..].copy_from_slice(&DUMMY.map(Quad64));
        Self {
            positions,
            velocities: [R::Quad::default(); NODES],
            sines: [R::default(); CREASES],
            moments: [R::default(); CREASES],
            forces: [R::Quad::default(); FORCES],
        }
    }

    /// Copies what `nodes` are at `positions` to the first places.
    #[inline(always)]
    pub(super) fn take_positions(&mut self, positions: &[Quad64], nodes: &[u32]) {
        copy(&mut self.positions, positions, nodes);
    }

    /// Copies the velocities of `nodes` to the first places.
    #[inline(always)]
    pub(super) fn take_velocities(&mut self, velocities: &[R::Quad], nodes: &[u32]) {
        copy(&mut self.velocities, velocities, nodes);
    }
}

#[inline(always)]
fn copy<T: Copy>(to: &mut [T; NODES], from: &[T], nodes: &[u32]) {
    for (own, node) in to[..FILLING].iter_mut().zip(nodes) {
        *own = from[*node as usize];
    }
}
