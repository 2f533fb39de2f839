//! Relaxation of a small sheet by one workgroup.

use origami_shaders as wgsl;

use super::{Kernel, Per, SHARED, WHOLE_SHEET, springs};

/// The kernel of `workgroup_relax.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "workgroup_relax",
    entry: "workgroup_relax",
    text: wgsl::WORKGROUP_RELAX,
    shared: SHARED,
    parts: |variant| {
        let mut parts = springs(variant);
        let passes = [
            wgsl::FOLD_ANGLES,
            wgsl::TRIANGLE_FORCES,
            wgsl::CLOCK,
            wgsl::ROW_SUMS,
            wgsl::GATHER,
            wgsl::REDUCE,
            wgsl::FIRE,
        ];
        parts.extend(passes);
        parts
    },
    uses: WHOLE_SHEET,
    springs: true,
    per: Per::Instance,
};
