//! Keeps a good state.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per};

/// The kernel of `keep.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "keep",
    entry: "keep",
    text: wgsl::KEEP,
    parts: |_| Vec::new(),
    uses: &[Binding::Control, Binding::Nodes, Binding::CreaseStates, Binding::KeptNodes, Binding::KeptAngles],
    springs: false,
    per: Per::NodeOrCrease,
};
