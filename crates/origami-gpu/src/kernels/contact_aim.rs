//! Under contact after FIRE's decision: the move of every node as it would be.

use origami_shaders as wgsl;

use super::parts::fire;
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `contact_aim.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "contact_aim",
    entry: "contact_aim",
    text: wgsl::CONTACT_AIM,
    shared: SHARED,
    parts: |variant| [fire(variant), vec![wgsl::MOVES]].concat(),
    uses: &[Binding::Control, Binding::Nodes, Binding::Moves],
    springs: false,
    per: Per::Node,
};
