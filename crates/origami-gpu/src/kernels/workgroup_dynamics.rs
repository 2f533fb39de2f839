//! Dynamics of a small sheet by one workgroup.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, springs};

/// The kernel of `workgroup_dynamics.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "workgroup_dynamics",
    entry: "workgroup_dynamics",
    text: wgsl::WORKGROUP_DYNAMICS,
    parts: |variant| {
        let mut parts = springs(variant);
        parts.extend([wgsl::EDGES, wgsl::FACES, wgsl::GATHER, wgsl::NODES]);
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
