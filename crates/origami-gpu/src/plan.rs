//! Which kernels a scene runs, and how often.

use origami_core::solve::{dynamics, fire, settle};

use crate::kernels::{
    Kernel, decide, edges, faces, judge, keep, loose_beams, moves, nodes, renew, row_sums, settle as settle_kernel,
    stiffest, survey, weigh,
};
use crate::variant::Variant;

/// Evaluations between two looks of the stopping rule: its shortest window.
pub(crate) const TICK: u64 = settle::SHORTEST;

/// Steps of one submission of a small scene, and of a large one.
const BATCH: u64 = 100;
const LARGE_BATCH: u64 = 20;
const LARGE: usize = 100_000;

/// Steps between two reads of where the instances stand, `nodes` all together.
pub(crate) fn batch(nodes: usize) -> u64 {
    (if nodes > LARGE { LARGE_BATCH } else { BATCH }).next_multiple_of(TICK)
}

/// The kernels of a scene whose passes go over all elements, by when they run.
#[derive(Debug)]
pub(crate) struct Plan {
    /// Fold angles, then forces: every step of a relaxation. The stopping rule of dynamics looks at these too, undamped.
    pub(crate) forces: Vec<&'static Kernel>,
    /// The stopping rule, every [`TICK`] steps.
    pub(crate) settling: &'static [&'static Kernel],
    /// Masses of a relaxation, or the safe time step: every [`Plan::renewal`] steps.
    pub(crate) row_sums: &'static [&'static Kernel],
    /// From forces to new positions, every step.
    pub(crate) motion: &'static [&'static Kernel],
    /// The last good state, once a batch.
    pub(crate) keeping: &'static [&'static Kernel],
    /// Steps between two renewals.
    pub(crate) renewal: u64,
}

impl Plan {
    /// `safe`: whether dynamics renews its time step.
    pub(crate) fn new(variant: &Variant, safe: bool) -> Self {
        let mut forces = vec![&edges::KERNEL, &faces::KERNEL];
        if variant.loose_beams > 0 {
            forces.push(&loose_beams::KERNEL);
        }
        let relaxing = variant.relaxing();
        Self {
            forces,
            settling: &[&settle_kernel::KERNEL, &judge::KERNEL],
            row_sums: match (relaxing, safe) {
                (true, _) => &[&row_sums::KERNEL],
                (false, true) => &[&row_sums::KERNEL, &stiffest::KERNEL, &renew::KERNEL],
                (false, false) => &[],
            },
            motion: match relaxing {
                true => &[&weigh::KERNEL, &decide::KERNEL, &moves::KERNEL],
                false => &[&nodes::KERNEL],
            },
            keeping: &[&survey::KERNEL, &keep::KERNEL],
            renewal: if relaxing { fire::RENEWAL } else { dynamics::RENEWAL },
        }
    }
}
