//! The safe time step.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per};

/// The kernel of `renew.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "renew",
    entry: "renew",
    text: wgsl::RENEW,
    parts: |_| Vec::new(),
    uses: &[Binding::Control],
    springs: false,
    per: Per::Instance,
};
