//! Sums the forces on a node, within a block and then over the blocks, in fixed order: the same bits in every run.

use super::blocks::FORCES;
use super::lane::{GatherScatter, Num};
use super::lookup::force;
use super::real::Real;

/// The sum of the forces in `slots`.
#[inline(always)]
pub(super) fn gathered<L: GatherScatter>(lane: L, slots: &[u32], forces: &[<L::Real as Real>::Quad]) -> Num<L::Node> {
    let node = lane.node();
    let mut sum = Num::splat(node, 0.0);
    for slot in slots {
        sum = sum + Num { lane: node, raw: lane.load_node(forces[*slot as usize]) };
    }
    sum
}

/// The slots of each of the first nodes of `rows`.
#[inline(always)]
pub(super) fn rows<'a>(rows: &'a [u32], slots: &'a [u32]) -> impl Iterator<Item = &'a [u32]> {
    rows.windows(2).map(|row| &slots[row[0] as usize..row[1] as usize])
}

/// Writes the sum of the forces on each node of a block: `counts` says how many there are, `summands` where they lie.
#[inline(always)]
pub(super) fn sum_in_block<L: GatherScatter>(
    lane: L,
    counts: &[u16],
    summands: &[u16],
    forces: &[<L::Real as Real>::Quad; FORCES],
    sums: &mut [<L::Real as Real>::Quad],
) {
    let node = lane.node();
    let mut left = summands;
    for (count, to) in counts.iter().zip(sums) {
        let (own, others) = left.split_at(usize::from(*count));
        left = others;
        let mut sum = Num::splat(node, 0.0);
        for place in own {
            sum = sum + Num { lane: node, raw: lane.load_node(force::<L::Real>(forces, *place)) };
        }
        *to = lane.store_node(sum.raw);
    }
}
