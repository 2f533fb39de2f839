//! What acts on nodes from outside: loads, forces of one's own, supports. Each such node has one more slot, the last that it
//! gathers; a sheet without them has none and does nothing here.

use super::gather::gathered;
use super::isa::Pass;
use super::lane::GatherScatter;
use super::real::Real;
use crate::scene::Axes;

/// The nodes on which something acts from outside.
#[derive(Clone, Debug)]
pub(super) struct Outside<R: Real> {
    /// In order.
    pub(super) nodes: Vec<u32>,
    /// By node of these: the axes along which it is held.
    pub(super) held: Vec<Axes>,
    /// By node of these: the force from outside.
    pub(super) loads: Vec<R::Quad>,
}

impl<R: Real> Outside<R> {
    pub(super) fn none() -> Self {
        Self { nodes: Vec::new(), held: Vec::new(), loads: Vec::new() }
    }
}

/// Writes the last slot of these nodes: the load along free axes; along held ones what takes back all that the other slots
/// hold, so that the sum is exactly 0.
pub(super) struct Apply<'a, R: Real> {
    pub(super) outside: &'a Outside<R>,
    /// The first slot of each node, and the end of the last.
    pub(super) rows: &'a [u32],
    pub(super) slots: &'a [u32],
    /// The forces of springs.
    pub(super) springs: &'a [R::Quad],
    /// By node of these.
    pub(super) last: &'a mut [R::Quad],
}

impl<R: Real> Pass<R> for Apply<'_, R> {
    type Output = ();

    #[inline(always)]
    fn run<L: GatherScatter<Real = R>>(self, lane: L) {
        let Outside { nodes, held, loads } = self.outside;
        for (((node, axes), load), last) in nodes.iter().zip(held).zip(loads).zip(self.last) {
            *last = *load;
            if *axes != Axes::default() {
                let [from, to] = [self.rows[*node as usize], self.rows[*node as usize + 1] - 1];
                let sum = gathered(lane, &self.slots[from as usize..to as usize], self.springs);
                let (mut numbers, springs) = (R::numbers(*load), R::numbers(lane.store_node((-sum).raw)));
                for ((number, spring), held) in numbers.iter_mut().zip(springs).zip(axes.to_array()) {
                    *number = if held { spring } else { *number };
                }
                *last = R::quad(numbers);
            }
        }
    }
}
