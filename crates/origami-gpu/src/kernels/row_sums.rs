//! Row sums of the stiffness: the masses of a relaxation, and what bounds a time step.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, springs};

/// The kernel of `row_sums.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "row_sums",
    entry: "row_sums",
    text: wgsl::ROW_SUMS,
    parts: springs,
    uses: &[Binding::Control, Binding::Nodes, Binding::Hinges, Binding::Faces, Binding::Slots],
    springs: true,
    per: Per::Face,
};
