//! Dynamics of a small sheet by one workgroup.

use origami_shaders as wgsl;

use super::{Kernel, Per, SHARED, WHOLE_SHEET, springs};

/// The kernel of `workgroup_dynamics.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "workgroup_dynamics",
    entry: "workgroup_dynamics",
    text: wgsl::WORKGROUP_DYNAMICS,
    shared: SHARED,
    parts: |variant| {
        let mut parts = springs(variant);
        parts.extend([wgsl::FOLD_ANGLES, wgsl::TRIANGLE_FORCES, wgsl::CLOCK, wgsl::GATHER, wgsl::MOTION]);
        parts
    },
    uses: WHOLE_SHEET,
    springs: true,
    per: Per::Instance,
};
