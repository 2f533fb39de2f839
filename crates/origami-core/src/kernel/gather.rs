//! Sums what lies in the slots of a node, in fixed order: the same bits in every run.

use super::lane::{GatherScatter, Num};
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
