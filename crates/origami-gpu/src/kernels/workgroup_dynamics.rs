//! Dynamics of a small sheet by one workgroup.

use origami_shaders as wgsl;

use super::parts::whole_sheet;
use super::{Kernel, Per, SHARED, WHOLE_SHEET};

/// The kernel of `workgroup_dynamics.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "workgroup_dynamics",
    entry: "workgroup_dynamics",
    text: wgsl::WORKGROUP_DYNAMICS,
    shared: SHARED,
    parts: |variant| [whole_sheet(variant), vec![wgsl::MOTION, wgsl::TIME_STEP]].concat(),
    uses: WHOLE_SHEET,
    springs: true,
    per: Per::Instance,
};
