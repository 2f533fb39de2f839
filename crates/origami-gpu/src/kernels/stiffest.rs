//! The largest row sum.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per};

/// The kernel of `stiffest.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "stiffest",
    entry: "stiffest",
    text: wgsl::STIFFEST,
    parts: |_| vec![wgsl::GATHER],
    uses: &[Binding::Control, Binding::Nodes, Binding::Slots, Binding::Rows],
    springs: false,
    per: Per::Node,
};
