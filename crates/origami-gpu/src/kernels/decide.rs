//! Fourth pass of a relaxation: FIRE's decision.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per};

/// The kernel of `decide.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "decide",
    entry: "decide",
    text: wgsl::DECIDE,
    parts: |_| vec![wgsl::GATHER, wgsl::REDUCE, wgsl::PARTIALS, wgsl::FIRE],
    uses: &[Binding::Control, Binding::Partials],
    springs: false,
    per: Per::Instance,
};
