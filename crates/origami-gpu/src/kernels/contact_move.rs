//! Under contact: moves the nodes.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `contact_move.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "contact_move",
    entry: "contact_move",
    text: wgsl::CONTACT_MOVE,
    shared: SHARED,
    parts: |_| vec![wgsl::PAIR_ROWS, wgsl::MOVES, wgsl::TOUCH],
    uses: &[
        Binding::Control,
        Binding::Nodes,
        Binding::PairRows,
        Binding::Moves,
        Binding::Shares,
        Binding::Ways,
        Binding::Touch,
    ],
    springs: false,
    per: Per::Node,
};
