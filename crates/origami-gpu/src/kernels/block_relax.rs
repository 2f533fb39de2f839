//! The forces of an evaluation of a relaxation and the sums that FIRE needs, by blocks.

use origami_shaders as wgsl;

use super::parts::in_blocks;
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `block_relax.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "block_relax",
    entry: "block_relax",
    text: wgsl::BLOCK_RELAX,
    shared: SHARED,
    parts: |variant| [in_blocks(variant), vec![wgsl::RAMP, wgsl::PARTIALS, wgsl::FIRE]].concat(),
    uses: &[
        Binding::Control,
        Binding::Nodes,
        Binding::Blocks,
        Binding::Angles,
        Binding::Targets,
        Binding::Slots,
        Binding::Partials,
    ],
    springs: true,
    per: Per::Block,
};
