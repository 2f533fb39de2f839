//! Which kernels a sheet runs, and how often.

use origami_core::twins;

use crate::kernels::{
    Kernel, block_clock, block_dynamics, block_forces, block_relax, bring_home, checkpoint, contact_aim, contact_clock,
    contact_move, contact_reduce, fire_move, fire_update, fold_angles, integrate, loose_beams, pair_forces,
    pair_limits, reduce_forces, row_sums, safe_time_step, settle_decide, settle_windows, state_bounds, stiffness_max,
    triangle_forces,
};
use crate::variant::Variant;

/// Evaluations between two checks of the stopping rule: its shortest window.
pub(crate) const CHECK_INTERVAL: u64 = twins::settle_decide::SHORTEST;

// Where blocks go through time, the nodes lie where all others look for them after an even number of steps.
const _: () = assert!(CHECK_INTERVAL.is_multiple_of(2) && twins::safe_time_step::RENEWAL.is_multiple_of(2));

/// Steps of one submission of a small sheet, and of a large one.
const BATCH: u64 = 100;
const LARGE_BATCH: u64 = 20;
const LARGE: usize = 100_000;

/// Steps between two reads of where the instances stand, `nodes` all together.
pub(crate) fn batch(nodes: usize) -> u64 {
    (if nodes > LARGE { LARGE_BATCH } else { BATCH }).next_multiple_of(CHECK_INTERVAL)
}

/// The kernels of a sheet whose passes go over all elements or over blocks, by when they run.
#[derive(Debug)]
pub(crate) struct Plan {
    /// Fold angles, before the forces; blocks have them with these.
    pub(crate) angles: &'static [&'static Kernel],
    /// Forces: every step of a relaxation. The stopping rule of dynamics takes these too, undamped. Blocks compute them anew in
    /// every step; these are for the stopping rule and the renewals.
    pub(crate) forces: Vec<&'static Kernel>,
    /// The stopping rule, every [`CHECK_INTERVAL`] steps.
    pub(crate) settling: &'static [&'static Kernel],
    /// Masses of a relaxation, or the safe time step: every [`Plan::renewal`] steps.
    pub(crate) row_sums: &'static [&'static Kernel],
    /// From forces to new positions, every step.
    pub(crate) integration: &'static [&'static Kernel],
    /// The last good state, once a batch.
    pub(crate) checkpoint: &'static [&'static Kernel],
    /// After the last step of a submission.
    pub(crate) home: &'static [&'static Kernel],
    /// Steps between two renewals; 0 where there are none.
    pub(crate) renewal: u64,
}

impl Plan {
    /// `safe`: whether dynamics renews its time step.
    pub(crate) fn new(variant: &Variant, safe: bool) -> Self {
        let relaxing = variant.relaxing();
        let plan = Self::of_passes(variant, relaxing, safe);
        if variant.blocks.is_none() {
            return plan;
        }
        Self {
            angles: &[],
            forces: vec![&block_forces::KERNEL],
            row_sums: if safe && !relaxing { &[&stiffness_max::KERNEL, &safe_time_step::KERNEL] } else { &[] },
            integration: match relaxing {
                true => &[&block_relax::KERNEL, &fire_update::KERNEL, &fire_move::KERNEL],
                false => &[&block_clock::KERNEL, &block_dynamics::KERNEL],
            },
            home: if relaxing { &[] } else { &[&bring_home::KERNEL] },
            ..plan
        }
    }

    fn of_passes(variant: &Variant, relaxing: bool, safe: bool) -> Self {
        let mut forces = vec![&triangle_forces::KERNEL];
        if variant.loose_beams > 0 {
            forces.push(&loose_beams::KERNEL);
        }
        if variant.contact.is_some() {
            forces.push(&pair_forces::KERNEL);
        }
        Self {
            angles: &[&fold_angles::KERNEL],
            forces,
            settling: &[&settle_windows::KERNEL, &settle_decide::KERNEL],
            row_sums: match (relaxing, safe) {
                (true, _) => &[&row_sums::KERNEL],
                (false, true) => &[&row_sums::KERNEL, &stiffness_max::KERNEL, &safe_time_step::KERNEL],
                (false, false) => &[],
            },
            integration: match (relaxing, variant.contact.is_some()) {
                (true, true) => &[
                    &contact_reduce::KERNEL,
                    &fire_update::KERNEL,
                    &contact_aim::KERNEL,
                    &pair_limits::KERNEL,
                    &contact_move::KERNEL,
                    &contact_clock::KERNEL,
                ],
                (true, false) => &[&reduce_forces::KERNEL, &fire_update::KERNEL, &fire_move::KERNEL],
                (false, _) => &[&integrate::KERNEL],
            },
            checkpoint: &[&state_bounds::KERNEL, &checkpoint::KERNEL],
            home: &[],
            renewal: match (relaxing, safe) {
                (true, _) => twins::fire_update::RENEWAL,
                (false, true) => twins::safe_time_step::RENEWAL,
                (false, false) => 0,
            },
        }
    }
}
