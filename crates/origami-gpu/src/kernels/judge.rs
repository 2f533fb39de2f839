//! The stopping rule, per instance.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per};

/// The kernel of `judge.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "judge",
    entry: "judge",
    text: wgsl::JUDGE,
    parts: |_| vec![wgsl::REDUCE, wgsl::PARTIALS, wgsl::WINDOWS],
    uses: &[Binding::Control, Binding::Partials],
    springs: false,
    per: Per::Instance,
};
