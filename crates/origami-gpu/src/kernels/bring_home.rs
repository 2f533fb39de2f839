//! Nodes to where others look for them, after an odd number of steps in blocks.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `bring_home.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "bring_home",
    entry: "bring_home",
    text: wgsl::BRING_HOME,
    shared: SHARED,
    parts: |_| Vec::new(),
    uses: &[Binding::Control, Binding::Nodes],
    springs: false,
    per: Per::Node,
};
