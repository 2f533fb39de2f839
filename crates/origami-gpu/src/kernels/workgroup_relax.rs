//! Relaxation of a small sheet by one workgroup.

use origami_shaders as wgsl;

use super::parts::whole_sheet;
use super::{Kernel, Per, SHARED, WHOLE_SHEET};

/// The kernel of `workgroup_relax.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "workgroup_relax",
    entry: "workgroup_relax",
    text: wgsl::WORKGROUP_RELAX,
    shared: SHARED,
    parts: |variant| [whole_sheet(variant), vec![wgsl::FIRE]].concat(),
    uses: WHOLE_SHEET,
    springs: true,
    per: Per::Instance,
};
