//! Third pass of a relaxation: forces on the nodes, and the sums that FIRE needs.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per};

/// The kernel of `weigh.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "weigh",
    entry: "weigh_nodes",
    text: wgsl::WEIGH,
    parts: |_| vec![wgsl::GATHER, wgsl::REDUCE, wgsl::PARTIALS, wgsl::FIRE],
    uses: &[Binding::Control, Binding::Nodes, Binding::Slots, Binding::Rows, Binding::Partials],
    springs: false,
    per: Per::Node,
};
