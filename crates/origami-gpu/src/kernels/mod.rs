//! The kernels: one file each, with the name of its shader. Here is what they have in common.

mod binding;
mod parts;
#[cfg(test)]
mod tests;

pub(crate) mod block_clock;
pub(crate) mod block_dynamics;
pub(crate) mod block_forces;
pub(crate) mod block_relax;
pub(crate) mod bring_home;
pub(crate) mod checkpoint;
pub(crate) mod contact_aim;
pub(crate) mod contact_clock;
pub(crate) mod contact_move;
pub(crate) mod contact_reduce;
pub(crate) mod fire_move;
pub(crate) mod fire_update;
pub(crate) mod fold_angles;
pub(crate) mod integrate;
pub(crate) mod loose_beams;
pub(crate) mod pair_forces;
pub(crate) mod pair_limits;
pub(crate) mod reduce_forces;
pub(crate) mod row_sums;
pub(crate) mod safe_time_step;
pub(crate) mod settle_decide;
pub(crate) mod settle_windows;
pub(crate) mod state_bounds;
pub(crate) mod stiffness_max;
pub(crate) mod triangle_forces;
pub(crate) mod workgroup_dynamics;
pub(crate) mod workgroup_relax;

use origami_shaders as wgsl;

use crate::variant::Variant;
pub(crate) use binding::Binding;

/// What one invocation works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Per {
    Crease,
    Face,
    LooseBeam,
    Node,
    /// A pair that may touch: as many as are listed.
    Pair,
    /// A workgroup for each block.
    Block,
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
    /// The parts that come first, in every variant.
    pub(crate) shared: &'static [&'static str],
    /// The parts that follow, for a variant.
    pub(crate) parts: fn(&Variant) -> Vec<&'static str>,
    /// The buffers that it uses in every variant; those with `springs` may add some, see [`Kernel::bindings`].
    pub(crate) uses: &'static [Binding],
    /// Whether it computes forces or row sums of triangles, and so reads corner angles and rigidities where there are some.
    pub(crate) springs: bool,
    /// What an invocation works on.
    pub(crate) per: Per,
}

impl Kernel {
    /// The whole shader.
    pub(crate) fn source(&self, variant: &Variant) -> String {
        let mut parts = self.shared.to_vec();
        parts.extend((self.parts)(variant));
        parts.push(self.text);
        parts.join("\n")
    }

    /// All buffers that it uses.
    pub(crate) fn bindings(&self, variant: &Variant) -> Vec<Binding> {
        let mut bindings = self.uses.to_vec();
        let in_blocks = self.springs && variant.blocks.is_some();
        if self.springs && variant.corners && !in_blocks {
            bindings.push(Binding::Corners);
        }
        if self.springs && variant.rigidities && !in_blocks {
            bindings.push(Binding::Rigidities);
        }
        if self.name == row_sums::KERNEL.name && variant.softens {
            // Which creases are on the wrong side.
            bindings.push(Binding::CreaseStates);
        }
        if in_blocks && variant.loads {
            bindings.push(Binding::Loads);
        }
        if self.name == settle_windows::KERNEL.name && variant.contact.is_some() {
            bindings.extend([Binding::PairRows, Binding::Pushes]);
        }
        if variant.blocks.is_some() {
            // What these are in the whole sheet, blocks have in another form.
            bindings.retain(|binding| *binding != Binding::Rows);
            for binding in bindings.iter_mut().filter(|binding| **binding == Binding::CreaseStates) {
                *binding = Binding::Angles;
            }
        }
        bindings.sort_unstable();
        bindings
    }
}

/// What the kernels of this folder begin with.
const SHARED: &[&str] = &[wgsl::CONTROL, wgsl::STATE];

/// The buffers of a workgroup that has its whole sheet.
const WHOLE_SHEET: &[Binding] =
    &[Binding::Control, Binding::Nodes, Binding::Windows, Binding::Blocks, Binding::Angles, Binding::Targets];
