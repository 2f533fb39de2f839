//! The kernels: one file each, with the name of its shader. Here is what they have in common.

pub(crate) mod decide;
pub(crate) mod edges;
pub(crate) mod faces;
pub(crate) mod judge;
pub(crate) mod keep;
pub(crate) mod loose_beams;
pub(crate) mod moves;
pub(crate) mod nodes;
pub(crate) mod renew;
pub(crate) mod row_sums;
pub(crate) mod settle;
pub(crate) mod stiffest;
pub(crate) mod survey;
pub(crate) mod weigh;
pub(crate) mod workgroup_dynamics;
pub(crate) mod workgroup_relax;

use origami_shaders as wgsl;

use crate::variant::Variant;

/// A buffer, by its binding in the shaders.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u32)]
pub(crate) enum Binding {
    Control = 0,
    Nodes = 1,
    CreaseStates = 2,
    Hinges = 3,
    Faces = 4,
    Slots = 5,
    Rows = 6,
    Corners = 7,
    LooseBeams = 8,
    Rigidities = 9,
    Partials = 10,
    Windows = 11,
    KeptNodes = 12,
    KeptAngles = 13,
}

impl Binding {
    /// What it holds, for people.
    pub(crate) fn what(self) -> &'static str {
        match self {
            Self::Control => "the control block",
            Self::Nodes => "the nodes",
            Self::CreaseStates => "the fold angles",
            Self::Hinges => "the creases",
            Self::Faces => "the faces",
            Self::Slots => "the forces of the faces",
            Self::Rows => "the rows of the nodes",
            Self::Corners => "the corner angles",
            Self::LooseBeams => "the loose beams",
            Self::Rigidities => "the rigidities of the beams",
            Self::Partials => "the partial sums",
            Self::Windows => "the stopping rule's memory",
            Self::KeptNodes => "the last good nodes",
            Self::KeptAngles => "the last good fold angles",
        }
    }
}

/// What one invocation works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Per {
    Crease,
    Face,
    LooseBeam,
    Node,
    /// The larger of nodes and creases.
    NodeOrCrease,
    /// One workgroup an instance.
    Instance,
}

/// A kernel as it is written.
#[derive(Debug)]
pub(crate) struct Kernel {
    /// The shader's file, without its extension.
    pub(crate) name: &'static str,
    /// Its entry point.
    pub(crate) entry: &'static str,
    /// The text of the kernel itself.
    pub(crate) text: &'static str,
    /// The parts that it is put together from, for a variant.
    pub(crate) parts: fn(&Variant) -> Vec<&'static str>,
    /// The buffers that it uses in every variant; faces may add some, see [`Kernel::bindings`].
    pub(crate) uses: &'static [Binding],
    /// Whether it computes forces or row sums of faces, and so reads corner angles and rigidities where there are some.
    pub(crate) springs: bool,
    /// What an invocation works on.
    pub(crate) per: Per,
}

impl Kernel {
    /// The whole shader.
    pub(crate) fn source(&self, variant: &Variant) -> String {
        let mut parts = vec![wgsl::STATE];
        parts.extend((self.parts)(variant));
        parts.push(self.text);
        parts.join("\n")
    }

    /// All buffers that it uses.
    pub(crate) fn bindings(&self, variant: &Variant) -> Vec<Binding> {
        let mut bindings = self.uses.to_vec();
        if self.springs && variant.corners {
            bindings.push(Binding::Corners);
        }
        if self.springs && variant.rigidities {
            bindings.push(Binding::Rigidities);
        }
        bindings.sort_unstable();
        bindings
    }
}

/// The parts that tell how stiff a crease is.
fn creases(variant: &Variant) -> Vec<&'static str> {
    vec![variant.material(), wgsl::ANGLE, wgsl::HINGE]
}

/// The parts that the faces' forces and row sums have in common.
fn springs(variant: &Variant) -> Vec<&'static str> {
    let mut parts = creases(variant);
    parts.push(wgsl::FACE);
    parts.push(if variant.corners { wgsl::CORNER_ANGLES } else { wgsl::CORNER_ANGLES_NONE });
    parts.push(if variant.rigidities { wgsl::RIGIDITY_OWN } else { wgsl::RIGIDITY_UNIFORM });
    parts
}
