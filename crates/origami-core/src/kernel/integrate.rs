//! Third pass of dynamics: sums the forces on every node and moves it (paper 2.5), masses 1.

use super::bounds::{Bounds, BoundsWatch, displaced};
use super::gather::{gathered, rows};
use super::isa::{Compute, Pass};
use super::lane::{GatherScatter, Num};
use super::real::{Quad64, Real};
use super::share::Cut;

/// `v += dt F`, `x += dt v` with the new v. True where all nodes are surely in bounds.
pub(super) struct Euler<'a, R: Real> {
    pub(super) bounds: Bounds,
    /// The first slot of each node, and the end of the last.
    pub(super) rows: &'a [u32],
    pub(super) slots: &'a [u32],
    pub(super) forces: &'a [R::Quad],
    pub(super) positions: &'a mut [Quad64],
    pub(super) velocities: &'a mut [R::Quad],
    pub(super) time_step: f64,
}

impl<R: Real> Pass<R> for Euler<'_, R> {
    type Output = bool;

    #[inline(always)]
    fn run<L: GatherScatter<Real = R>>(self, lane: L) -> bool {
        let mut watch = BoundsWatch::new(lane, self.bounds);
        let time_step = Num::splat(lane.node(), self.time_step);
        let nodes = rows(self.rows, self.slots).zip(self.positions).zip(self.velocities);
        for ((slots, position), velocity) in nodes {
            let force = gathered(lane, slots, self.forces);
            let new = force.mul_add(time_step, Num { lane: lane.node(), raw: lane.load_node(*velocity) });
            *velocity = lane.store_node(new.raw);
            let displacement = new * time_step;
            watch.see(displaced(lane, position, displacement), displacement);
        }
        watch.in_bounds()
    }
}

impl<R: Compute> Cut<R> for Euler<'_, R> {
    fn elements(&self) -> usize {
        self.positions.len()
    }

    fn cut(self, at: usize) -> (Self, Self) {
        let (positions, other_positions) = self.positions.split_at_mut(at);
        let (velocities, other_velocities) = self.velocities.split_at_mut(at);
        let other = Self { rows: &self.rows[at..], positions: other_positions, velocities: other_velocities, ..self };
        (Self { positions, velocities, ..self }, other)
    }

    fn both(one: bool, other: bool) -> bool {
        one && other
    }
}

/// Velocity Verlet. The velocity that is stored, and that the damping acts on, is the one extrapolated by the acceleration
/// before to the end of the step: so the error of the damping is of second order too.
pub(super) struct Verlet<'a, R: Real> {
    pub(super) bounds: Bounds,
    /// The first slot of each node, and the end of the last.
    pub(super) rows: &'a [u32],
    pub(super) slots: &'a [u32],
    pub(super) forces: &'a [R::Quad],
    pub(super) positions: &'a mut [Quad64],
    pub(super) velocities: &'a mut [R::Quad],
    /// By node, those of the step before.
    pub(super) accelerations: &'a mut [R::Quad],
    pub(super) time_step: f64,
    /// 0 in the first step.
    pub(super) previous_step: f64,
}

impl<R: Real> Pass<R> for Verlet<'_, R> {
    type Output = bool;

    #[inline(always)]
    fn run<L: GatherScatter<Real = R>>(self, lane: L) -> bool {
        let mut watch = BoundsWatch::new(lane, self.bounds);
        let node = lane.node();
        let time_step = Num::splat(node, self.time_step);
        let half = Num::splat(node, 0.5 * self.time_step);
        let half_previous = Num::splat(node, 0.5 * self.previous_step);
        let nodes = rows(self.rows, self.slots).zip(self.positions).zip(self.velocities);
        for (((slots, position), velocity), acceleration) in nodes.zip(self.accelerations) {
            let force = gathered(lane, slots, self.forces);
            let before = Num { lane: node, raw: lane.load_node(*acceleration) };
            let old = Num { lane: node, raw: lane.load_node(*velocity) };
            let arrived = (force - before).mul_add(half_previous, old);
            let midway = force.mul_add(half, arrived);
            *velocity = lane.store_node(force.mul_add(half, midway).raw);
            *acceleration = lane.store_node(force.raw);
            let displacement = midway * time_step;
            watch.see(displaced(lane, position, displacement), displacement);
        }
        watch.in_bounds()
    }
}

impl<R: Compute> Cut<R> for Verlet<'_, R> {
    fn elements(&self) -> usize {
        self.positions.len()
    }

    fn cut(self, at: usize) -> (Self, Self) {
        let (positions, other_positions) = self.positions.split_at_mut(at);
        let (velocities, other_velocities) = self.velocities.split_at_mut(at);
        let (accelerations, other_accelerations) = self.accelerations.split_at_mut(at);
        let other = Self {
            rows: &self.rows[at..],
            positions: other_positions,
            velocities: other_velocities,
            accelerations: other_accelerations,
            ..self
        };
        (Self { positions, velocities, accelerations, ..self }, other)
    }

    fn both(one: bool, other: bool) -> bool {
        one && other
    }
}
