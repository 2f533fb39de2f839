//! Relaxation of a small sheet by one workgroup.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, springs};

/// The kernel of `workgroup_relax.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "workgroup_relax",
    entry: "workgroup_relax",
    text: wgsl::WORKGROUP_RELAX,
    parts: |variant| {
        let mut parts = springs(variant);
        let passes = [wgsl::EDGES, wgsl::FACES, wgsl::ROW_SUMS, wgsl::GATHER, wgsl::REDUCE, wgsl::FIRE];
        parts.extend(passes);
        parts
    },
    uses: &[
        Binding::Control,
        Binding::Nodes,
        Binding::CreaseStates,
        Binding::Hinges,
        Binding::Faces,
        Binding::Slots,
        Binding::Rows,
    ],
    springs: true,
    per: Per::Instance,
};
