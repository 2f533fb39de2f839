//! Beams on edges outside any triangle.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `loose_beams.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "loose_beams",
    entry: "loose_beams_of_sheet",
    text: wgsl::LOOSE_BEAMS,
    shared: SHARED,
    parts: |variant| vec![variant.material(), variant.soft(), wgsl::WHOLE_NODES, wgsl::SLOTS, wgsl::LOOSE_BEAM],
    uses: &[Binding::Control, Binding::Nodes, Binding::Slots, Binding::LooseBeams],
    springs: false,
    per: Per::LooseBeam,
};
