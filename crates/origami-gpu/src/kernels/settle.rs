//! The stopping rule, per node.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per};

/// The kernel of `settle.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "settle",
    entry: "settle",
    text: wgsl::SETTLE,
    parts: |_| vec![wgsl::GATHER, wgsl::REDUCE, wgsl::PARTIALS, wgsl::WINDOWS],
    uses: &[Binding::Control, Binding::Nodes, Binding::Slots, Binding::Rows, Binding::Partials, Binding::Windows],
    springs: false,
    per: Per::Node,
};
