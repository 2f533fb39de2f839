//! Third pass of dynamics: moves the nodes.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per};

/// The kernel of `nodes.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "nodes",
    entry: "nodes_of_sheet",
    text: wgsl::NODES,
    parts: |_| vec![wgsl::GATHER],
    uses: &[Binding::Control, Binding::Nodes, Binding::Slots, Binding::Rows],
    springs: false,
    per: Per::Node,
};
