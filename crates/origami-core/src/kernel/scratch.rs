//! What a block works with: its own copies, so that all it reads again and again is near.

use super::blocks::{CREASES, FILLING, FORCES, NODES};
use super::lane::{GatherScatter, Lane, Num};
use super::near::Near;
use super::real::{Quad64, Real};

/// Nodes and moments of the block that is at work.
#[derive(Clone, Debug)]
pub(super) struct Scratch<R: Real> {
    pub(super) near: Near<R>,
    pub(super) velocities: Box<[R::Quad; NODES]>,
    /// By crease of the block: numbers in proportion to the sines of fold angles, and moments.
    pub(super) sines: Box<[R; CREASES]>,
    pub(super) moments: Box<[R; CREASES]>,
    /// By chunk of triangles, corner after corner; then by chunk of loose beams.
    pub(super) forces: Box<[R::Quad; FORCES]>,
}

impl<R: Real> Scratch<R> {
    pub(super) fn new() -> Self {
        Self { near: Near::new(), velocities: list(), sines: list(), moments: list(), forces: list() }
    }

    /// Copies the velocities of `nodes` to the first places.
    #[inline(always)]
    pub(super) fn take_velocities(&mut self, velocities: &[R::Quad], nodes: &[u32]) {
        for (own, node) in self.velocities[..FILLING].iter_mut().zip(nodes) {
            *own = velocities[*node as usize];
        }
    }
}

/// A list that is nowhere but in its place: a large one is slow to move there.
fn list<T: Copy + Default, const N: usize>() -> Box<[T; N]> {
    vec![T::default(); N].into_boxed_slice().try_into().unwrap_or_else(|_| Box::new([T::default(); N]))
}

/// Takes the positions of `nodes`, which become the first ones of a block.
#[inline(always)]
pub(super) fn take_positions<L: GatherScatter>(lane: L, near: &mut Near<L::Real>, positions: &[Quad64], nodes: &[u32]) {
    let position = lane.position();
    if !L::Real::WHOLE {
        for (place, node) in near.places[..FILLING].iter_mut().zip(nodes) {
            *place = lane.place(lane.load_position(positions[*node as usize]));
        }
        return;
    }
    // One amid the others, as their order goes: the nearer all are, the smaller is the unit.
    let Some(middle) = nodes.get(nodes.len() / 2) else { return };
    let origin = Num { lane: position, raw: lane.load_position(positions[*middle as usize]) };
    // Most blocks have the unit of the one before: only of others the places are taken once more.
    loop {
        let unit = near.unit.to_f64();
        let units = Num::splat(position, 1.0 / unit);
        let mut farthest = Num::splat(position, 0.0);
        for (own, node) in near.places[..FILLING].iter_mut().zip(nodes) {
            let place = Num { lane: position, raw: lane.load_position(positions[*node as usize]) } - origin;
            farthest = farthest.max(place.abs());
            *own = lane.place((place * units).raw);
        }
        let right = unit_of(farthest);
        if right == unit {
            return;
        }
        near.unit = L::Real::of(right);
    }
}

/// The least power of two of which numbers up to the largest of these are less than 2^30 units.
#[inline(always)]
fn unit_of<L: Lane<Real = f64>>(farthest: Num<L>) -> f64 {
    let mut each = [0.0; 4];
    farthest.store(&mut each);
    // A little more, so that rounding does not reach 2^30.
    let farthest = (1.0 + 1e-6) * each[0].max(each[1]).max(each[2]);
    // A block that has shrunk to a point, or has burst, still has a unit that is a sound f32.
    let exponent = ((farthest.to_bits() >> 52) & 0x7ff).clamp(1023 - 90, 1023 + 90);
    f64::from_bits((exponent - 29) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::isa::{Compute, Isa, Pass};

    struct Take<'a>(&'a [[f64; 3]]);

    impl Pass<f32> for Take<'_> {
        type Output = Near<f32>;

        fn run<L: GatherScatter<Real = f32>>(self, lane: L) -> Near<f32> {
            let positions: Vec<Quad64> = self.0.iter().map(|[x, y, z]| Quad64([*x, *y, *z, 0.0])).collect();
            let nodes: Vec<u32> = (0..).take(positions.len()).collect();
            let mut near = Near::new();
            take_positions(lane, &mut near, &positions, &nodes);
            near
        }
    }

    #[test]
    fn whole_numbers_are_as_exact_as_there_is_room_for() {
        for size in [1e-3, 0.3, 1.0, 1.9999999999, 50.0] {
            let origin = [0.123_456_789, -7.0, 3.0];
            let shares = [[1.0, 0.1, -1.0], [-1.0, 1.0 / 3.0, 0.77], [0.0; 3], [1e-9, -0.5, 1.0]];
            let positions = shares.map(|share| [0, 1, 2].map(|i| origin[i] + size * share[i]));
            for isa in Isa::all() {
                let near = f32::run(isa, Take(&positions));
                let unit = f64::from(near.unit);
                assert!(
                    unit <= size * 2.0_f64.powi(-28) && unit >= size * 2.0_f64.powi(-30),
                    "{isa:?}: {unit} of {size}"
                );
                for (place, position) in near.places.iter().zip(&positions) {
                    for axis in 0..3 {
                        let off = f64::from(place.0[axis]) * unit - (position[axis] - positions[2][axis]);
                        assert!(off.abs() <= 0.5 * unit * (1.0 + 1e-6), "{isa:?}, {size}: {off} of {unit}");
                        assert!(place.0[axis].abs() < 1 << 30, "{isa:?}, {size}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_block_without_size_has_a_unit() {
        for isa in Isa::all() {
            for size in [0.0, f64::INFINITY, f64::NAN] {
                let near = f32::run(isa, Take(&[[0.0; 3], [size, 0.0, 0.0]]));
                assert!(near.unit.is_normal() && near.unit > 0.0, "{isa:?}, {size}: {}", near.unit);
            }
        }
    }
}
