//! Angles and forces, block by block: the first two passes of a step, of which the second finds what the first has left near.

use super::blocks::NODES;
use super::gather::sum_in_block;
use super::isa::{Compute, Pass};
use super::lane::{GatherScatter, Num};
use super::layout::{Layout, Starts};
use super::real::{Quad64, Real};
use super::scratch::{Scratch, take_positions};
use super::share::Cut;
use super::{fold_angles, loose_beams, triangle_forces};

/// Writes the fold angles, and the forces of all springs on the nodes of each block; the result is the most by which a crease
/// turned, in radians.
pub(super) struct Springs<'a, R: Real> {
    pub(super) layout: &'a Layout<R>,
    /// Where these blocks begin, and where the last one ends.
    pub(super) blocks: &'a [Starts],
    pub(super) positions: &'a [Quad64],
    /// Empty: no damping.
    pub(super) velocities: &'a [R::Quad],
    /// Of all blocks.
    pub(super) targets: &'a [R],
    /// The creases of these blocks alone.
    pub(super) angles: &'a mut [R],
    /// The slots of these blocks alone.
    pub(super) slots: &'a mut [[R::Quad; NODES]],
    /// One for each task.
    pub(super) scratch: &'a mut [Scratch<R>],
}

impl<R: Real> Pass<R> for Springs<'_, R> {
    type Output = f64;

    #[inline(always)]
    fn run<L: GatherScatter<Real = R>>(self, lane: L) -> f64 {
        let Self { layout, blocks, positions, velocities, targets, mut angles, slots, scratch } = self;
        let mut most = Num::splat(lane, 0.0);
        let Some(scratch) = scratch.first_mut() else { return 0.0 };
        for (own, slots) in blocks.windows(2).zip(slots) {
            let (start, end) = (own[0], own[1]);
            let nodes = &layout.block_nodes[start.nodes..end.nodes];
            take_positions(lane, &mut scratch.near, positions, nodes);
            if !velocities.is_empty() {
                scratch.take_velocities(velocities, &nodes[..start.acted_on]);
            }
            let Scratch { near, velocities: near_velocities, sines, moments, forces } = &mut *scratch;
            let creases = start.creases..end.creases;
            let (own_angles, others) = angles.split_at_mut(creases.len());
            angles = others;
            let turned = fold_angles::fold_angles(
                lane,
                near,
                &layout.hinges[4 * start.creases..4 * end.creases],
                (&layout.stiffness[creases.clone()], &targets[creases], layout.wrong_side),
                own_angles,
                [&mut sines[..], &mut moments[..]],
            );
            most = most.max(turned);

            let damped = !velocities.is_empty();
            let input = triangle_forces::Input { layout, near, velocities: near_velocities, damped, moments };
            let (of_triangles, of_loose) = forces.split_at_mut(3 * (end.triangles - start.triangles));
            triangle_forces::triangle_forces(lane, &input, start.triangles..end.triangles, of_triangles);
            if start.loose < end.loose {
                loose_beams::loose_beams(lane, &input, start.loose..end.loose, of_loose);
            }
            let (counts, summands) =
                (&layout.counts[start.sums..end.sums], &layout.summands[start.summands..end.summands]);
            sum_in_block(lane, counts, summands, forces, slots);
        }
        let mut each = [R::default(); 16];
        most.store(&mut each);
        each.iter().map(|turn| turn.to_f64()).fold(0.0, f64::max)
    }
}

impl<R: Compute> Cut<R> for Springs<'_, R> {
    const GRAIN: usize = 1;

    fn elements(&self) -> usize {
        self.slots.len()
    }

    fn cut(self, at: usize) -> (Self, Self) {
        let (angles, other_angles) = self.angles.split_at_mut(self.blocks[at].creases - self.blocks[0].creases);
        let (slots, other_slots) = self.slots.split_at_mut(at);
        // As many as there are tasks, which are halved alike.
        let (scratch, other_scratch) = self.scratch.split_at_mut(self.scratch.len() / 2);
        let (blocks, other_blocks) = (&self.blocks[..=at], &self.blocks[at..]);
        let other =
            Self { blocks: other_blocks, angles: other_angles, slots: other_slots, scratch: other_scratch, ..self };
        (Self { blocks, angles, slots, scratch, ..self }, other)
    }

    fn both(one: f64, other: f64) -> f64 {
        one.max(other)
    }
}
