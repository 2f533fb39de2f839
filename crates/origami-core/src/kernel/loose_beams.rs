//! Beams on edges outside any triangle, which most scenes do not have.

use std::ops::Range;

use super::lane::{GatherScatter, Num, Vec3};
use super::real::Real;
use super::triangle_forces::Input;

/// Writes the forces on the ends of these beams of a block.
#[inline(always)]
pub(super) fn loose_beams<L: GatherScatter>(
    lane: L,
    input: &Input<'_, L::Real>,
    beams: Range<usize>,
    forces: &mut [<L::Real as Real>::Quad],
) {
    let zero = Num::splat(lane, 0.0);
    let ends = input.layout.loose_ends[2 * beams.start..2 * beams.end].chunks_exact(2 * L::WIDTH);
    let springs = input.layout.loose_beams[3 * beams.start..3 * beams.end].chunks_exact(3 * L::WIDTH);
    for ((ends, spring), to) in ends.zip(springs).zip(forces.chunks_exact_mut(2 * L::WIDTH)) {
        let (one, other) = ends.split_at(L::WIDTH);
        let [rest, stiffness, damping] = [0, 1, 2].map(|i| Num::load(lane, &spring[i * L::WIDTH..]));
        let along = Vec3::new(lane, lane.gather_differences(input.near, one, other));
        let length = along.dot(along).sqrt();
        let tension = stiffness * (length - rest) / length;
        let mut force = along * Num::splat(lane, L::Real::LEAST).less(length).select(tension, zero);
        if input.damped {
            force =
                Vec3::new(lane, lane.gather_velocity_differences(input.velocities, one, other)).mul_add(damping, force);
        }
        let (first, second) = to.split_at_mut(L::WIDTH);
        lane.scatter(force.raw(), first);
        lane.scatter((-force).raw(), second);
    }
}
