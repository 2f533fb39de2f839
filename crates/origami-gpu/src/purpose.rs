//! What an engine is built for.

use std::fmt;

use origami_core::model::Material;

use crate::sheet_arrays::SheetArrays;
use crate::variant::{Scheme, Variant};

/// How the passes of a step reach the GPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dispatch {
    /// As the size of the sheet suggests.
    Auto,
    /// Each pass over all elements, one dispatch after the other.
    Passes,
    /// One workgroup for each sheet, which has it in its memory and takes many steps in one dispatch. Where that memory does not
    /// hold it: by passes.
    Workgroup,
    /// A workgroup for each block of nodes, which computes from their positions all that pulls at them: fewer bytes, more
    /// arithmetic. Where no workgroup's memory holds what pulls at one node: by passes.
    Blocks,
}

impl Dispatch {
    /// All ways that there are: each but [`Dispatch::Auto`], which is one of them. [`OnGpu::way`](crate::OnGpu::way) tells
    /// which a sheet can go.
    pub const WAYS: &[Self] = &[Self::Passes, Self::Workgroup, Self::Blocks];
}

/// `auto`, `passes`, `one workgroup` or `blocks`.
impl fmt::Display for Dispatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Auto => "auto",
            Self::Passes => "passes",
            Self::Workgroup => "one workgroup",
            Self::Blocks => "blocks",
        })
    }
}

/// Nodes up to which [`Dispatch::Auto`] gives a workgroup the whole sheet.
///
/// Measured on a software adapter only (llvmpipe, LLVM 15, two cores, over which it spreads passes but not one workgroup):
/// one workgroup wins at 49 nodes and loses at 64, in both solvers (`cargo bench --features gpu --bench gpu_step --
/// crossover`), and with kernels that read from buffers. Hardware may differ either way.
pub const WORKGROUP_NODES: usize = 50;

/// What an engine is built for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Purpose {
    pub(crate) scheme: Scheme,
    /// Whether dynamics renews its time step.
    pub(crate) safe: bool,
    /// Whether a relaxation may be soft on its way.
    pub(crate) softens: bool,
    pub(crate) dispatch: Dispatch,
}

impl Purpose {
    /// The variant for a sheet; `material` is that of all instances, or `None` where they differ.
    pub(crate) fn variant(self, arrays: &SheetArrays, material: Option<Material>) -> Variant {
        Variant { softens: self.softens, ..Variant::new(arrays, self.scheme, material) }
    }
}
