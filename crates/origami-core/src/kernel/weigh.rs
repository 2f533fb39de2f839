//! Third pass of a relaxation: forces on the nodes, and the sums that FIRE needs of them.

use super::gather::{gathered, rows};
use super::isa::Pass;
use super::lane::{Lane, Mesh, Num};
use super::real::Real;
use super::sheet::Sheet;

/// Nodes whose sums are taken one after the other: the sums of these blocks are then added in their order, so that the
/// result does not depend on who took which.
pub(super) const BLOCK: usize = 1024;

/// Power, and the squared lengths of velocity and acceleration in the norm of the masses.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sums {
    pub(crate) power: f64,
    pub(crate) speed: f64,
    pub(crate) pull: f64,
}

/// Keeps the force on each node; gives the sums.
pub(super) struct Weigh<'a, R: Real> {
    pub(super) sheet: &'a Sheet<R>,
    pub(super) forces: &'a [R::Quad],
    pub(super) velocities: &'a [R::Quad],
    /// By node: the mass and its inverse.
    pub(super) masses: &'a [[f64; 2]],
    pub(super) sums: &'a mut [R::Quad],
}

impl<R: Real> Pass<R> for Weigh<'_, R> {
    type Output = Sums;

    #[inline(always)]
    fn run<L: Mesh<Real = R>>(self, lane: L) -> Sums {
        let mut sums = Sums::default();
        let nodes = self.velocities.chunks(BLOCK).zip(self.masses.chunks(BLOCK)).zip(self.sums.chunks_mut(BLOCK));
        for (block, ((velocities, masses), forces)) in nodes.enumerate() {
            let own = &self.sheet.rows[block * BLOCK..][..masses.len() + 1];
            let zero = Num::splat(lane.place(), 0.0);
            let (mut power, mut speed, mut pull) = (zero, zero, zero);
            let nodes = rows(own, &self.sheet.slots).zip(velocities).zip(masses).zip(forces);
            for (((slots, velocity), [mass, inverse]), kept) in nodes {
                let force = gathered(lane, slots, self.forces);
                *kept = lane.store_node(force.raw);
                let force = Num { lane: lane.place(), raw: lane.widen(force.raw) };
                let velocity = Num { lane: lane.place(), raw: lane.widen(lane.load_node(*velocity)) };
                power = force.mul_add(velocity, power);
                speed = (velocity * velocity).mul_add(Num::splat(lane.place(), *mass), speed);
                pull = (force * force).mul_add(Num::splat(lane.place(), *inverse), pull);
            }
            sums.power += total(power);
            sums.speed += total(speed);
            sums.pull += total(pull);
        }
        sums
    }
}

/// Of the three coordinates.
#[inline(always)]
fn total<L: Lane<Real = f64>>(sum: Num<L>) -> f64 {
    let mut each = [0.0; 4];
    sum.store(&mut each);
    each[0] + each[1] + each[2]
}
