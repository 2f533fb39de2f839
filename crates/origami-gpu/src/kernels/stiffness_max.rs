//! The largest row sum, and the largest velocity.

use origami_shaders as wgsl;

use super::parts::gather;
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `stiffness_max.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "stiffness_max",
    entry: "stiffness_max",
    text: wgsl::STIFFNESS_MAX,
    shared: SHARED,
    parts: |variant| [gather(variant), vec![wgsl::TIME_STEP]].concat(),
    uses: &[Binding::Control, Binding::Nodes, Binding::Slots, Binding::Rows],
    springs: false,
    per: Per::Node,
};
