//! Last pass of a relaxation: moves the nodes.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per};

/// The kernel of `moves.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "moves",
    entry: "move_nodes",
    text: wgsl::MOVES,
    parts: |_| vec![wgsl::GATHER, wgsl::FIRE],
    uses: &[Binding::Control, Binding::Nodes],
    springs: false,
    per: Per::Node,
};
