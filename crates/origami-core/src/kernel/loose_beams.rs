//! Beams on edges outside any triangle: a pass that most scenes do not have.

use super::isa::Pass;
use super::lane::{GatherScatter, Num, Vec3};
use super::layout::Layout;
use super::real::{Quad64, Real};

/// Writes the forces on the two ends of each.
pub(super) struct LooseBeams<'a, R: Real> {
    pub(super) layout: &'a Layout<R>,
    pub(super) positions: &'a [Quad64],
    /// Empty: no damping.
    pub(super) velocities: &'a [R::Quad],
    pub(super) slots: &'a mut [R::Quad],
}

impl<R: Real> Pass<R> for LooseBeams<'_, R> {
    type Output = ();

    #[inline(always)]
    fn run<L: GatherScatter<Real = R>>(self, lane: L) {
        let zero = Num::splat(lane, 0.0);
        let ends = self.layout.loose_ends.chunks_exact(2 * L::WIDTH);
        let beams = self.layout.loose_beams.chunks_exact(3 * L::WIDTH);
        let slots = self.slots.chunks_exact_mut(2 * L::WIDTH);
        for ((ends, beam), slots) in ends.zip(beams).zip(slots) {
            let (from, to) = ends.split_at(L::WIDTH);
            let [rest, stiffness, damping] = [0, 1, 2].map(|i| Num::load(lane, &beam[i * L::WIDTH..]));
            let along = Vec3::new(lane, lane.gather_differences(self.positions, from, to));
            let length = along.dot(along).sqrt();
            let tension = stiffness * (length - rest) / length;
            let mut force = along * Num::splat(lane, R::LEAST).less(length).select(tension, zero);
            if !self.velocities.is_empty() {
                force = Vec3::new(lane, lane.gather_velocity_differences(self.velocities, from, to))
                    .mul_add(damping, force);
            }
            let (first, second) = slots.split_at_mut(L::WIDTH);
            lane.scatter(force.raw(), first);
            lane.scatter((-force).raw(), second);
        }
    }
}
