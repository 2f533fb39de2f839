//! Third pass of a relaxation: forces on the nodes, and the sums that FIRE needs of them.

use super::gather::{gathered, rows};
use super::isa::{Compute, Pass};
use super::lane::{GatherScatter, Lane, Num};
use super::real::Real;
use super::share::Cut;
use crate::twins::fire_update::Sums;

/// Nodes whose sums are taken one after the other: the sums of these blocks are then added in their order, so that the
/// result does not depend on who took which.
pub(super) const BLOCK: usize = 256;

/// Adds up the sums of all blocks, in their order.
pub(super) fn total_of(blocks: &[Sums]) -> Sums {
    let add = |a: Sums, b: &Sums| Sums { power: a.power + b.power, speed: a.speed + b.speed, pull: a.pull + b.pull };
    blocks.iter().fold(Sums::default(), add)
}

/// Stores the force on each node, and the sums of each block of nodes.
pub(super) struct ReduceForces<'a, R: Real> {
    /// The first slot of each node, and the end of the last.
    pub(super) rows: &'a [u32],
    pub(super) slots: &'a [u32],
    pub(super) forces: &'a [R::Quad],
    pub(super) velocities: &'a [R::Quad],
    /// By node: the mass and its inverse.
    pub(super) masses: &'a [[f64; 2]],
    pub(super) node_forces: &'a mut [R::Quad],
    pub(super) sums: &'a mut [Sums],
}

impl<R: Real> Pass<R> for ReduceForces<'_, R> {
    type Output = ();

    #[inline(always)]
    fn run<L: GatherScatter<Real = R>>(self, lane: L) {
        let nodes =
            self.velocities.chunks(BLOCK).zip(self.masses.chunks(BLOCK)).zip(self.node_forces.chunks_mut(BLOCK));
        for (block, (((velocities, masses), forces), sums)) in nodes.zip(self.sums).enumerate() {
            let own = &self.rows[block * BLOCK..][..masses.len() + 1];
            let zero = Num::splat(lane.position(), 0.0);
            let (mut power, mut speed, mut pull) = (zero, zero, zero);
            let nodes = rows(own, self.slots).zip(velocities).zip(masses).zip(forces);
            for (((slots, velocity), [mass, inverse]), node_forces) in nodes {
                let force = gathered(lane, slots, self.forces);
                *node_forces = lane.store_node(force.raw);
                let force = Num { lane: lane.position(), raw: lane.widen(force.raw) };
                let velocity = Num { lane: lane.position(), raw: lane.widen(lane.load_node(*velocity)) };
                power = force.mul_add(velocity, power);
                speed = (velocity * velocity).mul_add(Num::splat(lane.position(), *mass), speed);
                pull = (force * force).mul_add(Num::splat(lane.position(), *inverse), pull);
            }
            *sums = Sums { power: total(power), speed: total(speed), pull: total(pull) };
        }
    }
}

impl<R: Compute> Cut<R> for ReduceForces<'_, R> {
    const GRAIN: usize = BLOCK;

    fn elements(&self) -> usize {
        self.velocities.len()
    }

    fn cut(self, at: usize) -> (Self, Self) {
        let (velocities, other_velocities) = self.velocities.split_at(at);
        let (masses, other_masses) = self.masses.split_at(at);
        let (node_forces, other_node_forces) = self.node_forces.split_at_mut(at);
        let (sums, other_sums) = self.sums.split_at_mut(at / BLOCK);
        let other = Self {
            rows: &self.rows[at..],
            velocities: other_velocities,
            masses: other_masses,
            node_forces: other_node_forces,
            sums: other_sums,
            ..self
        };
        (Self { velocities, masses, node_forces, sums, ..self }, other)
    }

    fn both((): (), (): ()) {}
}

/// The sum of the three coordinates.
#[inline(always)]
fn total<L: Lane<Real = f64>>(sum: Num<L>) -> f64 {
    let mut each = [0.0; 4];
    sum.store(&mut each);
    each[0] + each[1] + each[2]
}
