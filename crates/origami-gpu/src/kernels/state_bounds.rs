//! How far out the nodes are, and how far they move in a step.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `state_bounds.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "state_bounds",
    entry: "state_bounds",
    text: wgsl::STATE_BOUNDS,
    shared: SHARED,
    parts: |_| Vec::new(),
    uses: &[Binding::Control, Binding::Nodes],
    springs: false,
    per: Per::Node,
};
