//! First pass: the fold angle and the moment of every crease.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, creases};

/// The kernel of `edges.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "edges",
    entry: "edges",
    text: wgsl::EDGES,
    parts: creases,
    uses: &[Binding::Control, Binding::Nodes, Binding::CreaseStates, Binding::Hinges],
    springs: false,
    per: Per::Crease,
};
