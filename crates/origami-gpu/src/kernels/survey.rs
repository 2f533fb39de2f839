//! How good a state is.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per};

/// The kernel of `survey.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "survey",
    entry: "survey",
    text: wgsl::SURVEY,
    parts: |_| Vec::new(),
    uses: &[Binding::Control, Binding::Nodes],
    springs: false,
    per: Per::Node,
};
