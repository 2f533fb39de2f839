//! Last pass of a relaxation: moves every node by the step that FIRE has decided on.

use super::bounds::{Bounds, BoundsWatch, displaced};
use super::isa::{Compute, Pass};
use super::lane::{GatherScatter, Num};
use super::real::{Quad64, Real};
use super::share::Cut;

/// What FIRE has decided: how the velocities change and the nodes move.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Decision {
    /// The step, in units of each node's own.
    pub(crate) step: f64,
    /// The share of the velocity that stays.
    pub(crate) keep: f64,
    /// Times force over mass is added to it.
    pub(crate) towards_force: f64,
    /// Times the old velocity is added to the displacement.
    pub(crate) back: f64,
}

/// `v = keep v + towards_force F / m`, `x += step v + back v_old`. True where all nodes are surely in bounds.
pub(super) struct FireMove<'a, R: Real> {
    pub(super) decision: Decision,
    pub(super) bounds: Bounds,
    pub(super) forces: &'a [R::Quad],
    pub(super) masses: &'a [[f64; 2]],
    pub(super) positions: &'a mut [Quad64],
    pub(super) velocities: &'a mut [R::Quad],
}

impl<R: Real> Pass<R> for FireMove<'_, R> {
    type Output = bool;

    #[inline(always)]
    fn run<L: GatherScatter<Real = R>>(self, lane: L) -> bool {
        let mut watch = BoundsWatch::new(lane, self.bounds);
        let node = lane.node();
        let Decision { step, keep, towards_force, back } = self.decision;
        let (step, keep, back) = (Num::splat(node, step), Num::splat(node, keep), Num::splat(node, back));
        let nodes = self.positions.iter_mut().zip(self.velocities).zip(self.forces).zip(self.masses);
        for (((position, velocity), force), [_, inverse]) in nodes {
            let old = Num { lane: node, raw: lane.load_node(*velocity) };
            let force = Num { lane: node, raw: lane.load_node(*force) };
            let new = force.mul_add(Num::splat(node, towards_force * inverse), old * keep);
            *velocity = lane.store_node(new.raw);
            let displacement = new * step;
            watch.see(displaced(lane, position, old.mul_add(back, displacement)), displacement);
        }
        watch.in_bounds()
    }
}

impl<R: Compute> Cut<R> for FireMove<'_, R> {
    fn elements(&self) -> usize {
        self.positions.len()
    }

    fn cut(self, at: usize) -> (Self, Self) {
        let (forces, other_forces) = self.forces.split_at(at);
        let (masses, other_masses) = self.masses.split_at(at);
        let (positions, other_positions) = self.positions.split_at_mut(at);
        let (velocities, other_velocities) = self.velocities.split_at_mut(at);
        let other = Self {
            forces: other_forces,
            masses: other_masses,
            positions: other_positions,
            velocities: other_velocities,
            ..self
        };
        (Self { forces, masses, positions, velocities, ..self }, other)
    }

    fn both(one: bool, other: bool) -> bool {
        one && other
    }
}
