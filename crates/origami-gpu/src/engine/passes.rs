//! The passes of a sheet.

use crate::device::Gpu;
use crate::kernels::{Kernel, triangle_forces, workgroup_dynamics, workgroup_relax};
use crate::pipeline::{Buffers, Pass};
use crate::plan::{CHECK_INTERVAL, Plan};
use crate::variant::{Small, Variant};

/// The passes of a sheet, by when they run.
#[derive(Debug, Default)]
pub(super) struct Passes {
    pub(super) fold_angles: Vec<Pass>,
    /// The forces of the springs alone: those of a relaxation, and what the stopping rule of dynamics takes.
    pub(super) spring_forces: Vec<Pass>,
    pub(super) damped_forces: Vec<Pass>,
    pub(super) settling: Vec<Pass>,
    pub(super) row_sums: Vec<Pass>,
    /// From forces to new positions; where these passes compute the forces too, all of a step.
    pub(super) integration: Vec<Pass>,
    pub(super) checkpoint: Vec<Pass>,
    /// After the last step of a submission.
    pub(super) home: Vec<Pass>,
    /// Whether `integration` needs no forces.
    pub(super) alone: bool,
    /// Steps that it takes at once.
    pub(super) stride: u64,
    /// A pass that takes more steps at once, and how many.
    pub(super) long: Option<(u64, Pass)>,
    /// Steps between two renewals of masses or of the time step; 0 where there are none.
    pub(super) renewal: u64,
}

impl Passes {
    pub(super) fn all_mut(&mut self) -> impl Iterator<Item = &mut Pass> {
        let Self {
            fold_angles, spring_forces, damped_forces, settling, row_sums, integration, checkpoint, home, ..
        } = self;
        let all = [fold_angles, spring_forces, damped_forces, settling, row_sums, integration, checkpoint, home];
        all.into_iter().flatten()
    }

    /// `small`: the variant of a workgroup that has the whole sheet.
    pub(super) fn new(gpu: &Gpu, variant: &Variant, small: Option<&Variant>, buffers: &Buffers, safe: bool) -> Self {
        let pass = |kernel, variant: &Variant, clock| Pass::new(gpu, kernel, variant, clock, buffers);
        let plan = Plan::new(variant, safe);
        let passes = |kernels: &[&'static Kernel]| kernels.iter().map(|k| pass(k, variant, false)).collect();
        if let Some(small) = small {
            let kernel = if variant.relaxing() { &workgroup_relax::KERNEL } else { &workgroup_dynamics::KERNEL };
            let of = |steps: u64| {
                let steps = steps.min(u64::from(small.small.steps));
                #[expect(clippy::cast_possible_truncation, reason = "no more than there were")]
                let own = Small { steps: steps as u32, ..small.small };
                (steps, pass(kernel, &Variant { small: own, ..small.clone() }, false))
            };
            // Sheets that take turns stop at whole intervals.
            let (stride, short) = of(CHECK_INTERVAL);
            return Self {
                integration: vec![short],
                checkpoint: passes(plan.checkpoint),
                alone: true,
                stride,
                long: (u64::from(small.small.steps) > stride).then(|| of(u64::MAX)),
                ..Self::default()
            };
        }
        let undamped =
            |kernels: &[&'static Kernel]| kernels.iter().map(|k| pass(k, &variant.undamped(), false)).collect();
        let alone = variant.blocks.is_some();
        // The pass over the triangles advances the clock.
        let clock = |k: &Kernel| k.name == triangle_forces::KERNEL.name;
        let damped: &[&Kernel] = if alone || variant.relaxing() { &[] } else { &plan.forces };
        Self {
            fold_angles: undamped(plan.angles),
            spring_forces: undamped(&plan.forces),
            damped_forces: damped.iter().map(|k| pass(k, variant, clock(k))).collect(),
            settling: passes(plan.settling),
            row_sums: passes(plan.row_sums),
            integration: passes(plan.integration),
            checkpoint: passes(plan.checkpoint),
            home: passes(plan.home),
            alone,
            stride: 1,
            long: None,
            renewal: plan.renewal,
        }
    }
}
