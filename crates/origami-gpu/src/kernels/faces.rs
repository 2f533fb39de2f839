//! Second pass: the forces on the corners of every triangle.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, springs};

/// The kernel of `faces.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "faces",
    entry: "faces_of_sheet",
    text: wgsl::FACES,
    parts: springs,
    uses: &[Binding::Control, Binding::Nodes, Binding::CreaseStates, Binding::Faces, Binding::Slots],
    springs: true,
    per: Per::Face,
};
