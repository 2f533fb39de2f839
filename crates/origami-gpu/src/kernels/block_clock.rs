//! The clock of dynamics by blocks.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `block_clock.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "block_clock",
    entry: "block_clock",
    text: wgsl::BLOCK_CLOCK,
    shared: SHARED,
    parts: |_| vec![wgsl::CLOCK],
    uses: &[Binding::Control],
    springs: false,
    per: Per::Instance,
};
