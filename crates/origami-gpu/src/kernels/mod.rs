//! The kernels: one file each, with the name of its shader. Here is what they have in common.

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
    CheckpointNodes = 12,
    CheckpointAngles = 13,
    // Of the paper's five passes; 14 is where positions for pictures go.
    Settings = 15,
    RestNodes = 16,
    Motions = 17,
    NextVelocities = 18,
    Triangles = 19,
    FaceNormals = 20,
    Creases = 21,
    Springs = 22,
    BeamEnds = 23,
    Roles = 24,
    // Of blocks.
    Blocks = 25,
    Angles = 26,
    Targets = 27,
    Loads = 28,
    // Of contact.
    Pairs = 29,
    PairRows = 30,
    Nears = 31,
    Pushes = 32,
    Moves = 33,
    Shares = 34,
    Ways = 35,
    Touch = 36,
}

impl Binding {
    /// What the buffer holds, in words for error messages.
    pub(crate) fn what(self) -> &'static str {
        match self {
            Self::Control => "the control block",
            Self::Nodes => "the nodes",
            Self::CreaseStates => "the fold angles",
            Self::Hinges => "the creases",
            Self::Faces => "the triangles",
            Self::Slots => "the forces of the triangles",
            Self::Rows => "the rows of the nodes",
            Self::Corners => "the corner angles",
            Self::LooseBeams => "the loose beams",
            Self::Rigidities => "the rigidities of the beams",
            Self::Partials => "the partial sums",
            Self::Windows => "the stopping rule's memory",
            Self::CheckpointNodes => "the last good nodes",
            Self::CheckpointAngles => "the last good fold angles",
            Self::Settings => "the settings",
            Self::RestNodes => "the list of nodes",
            Self::Motions => "the motion of the nodes",
            Self::NextVelocities => "the next velocities of the nodes",
            Self::Triangles => "the list of triangles",
            Self::FaceNormals => "the normals of the triangles",
            Self::Creases => "the list of creases",
            Self::Springs => "the springs of the creases",
            Self::BeamEnds => "the list of beams at nodes",
            Self::Roles => "the list of creases and triangles at nodes",
            Self::Blocks => "the lists of the blocks",
            Self::Angles => "the fold angles in blocks",
            Self::Targets => "the target angles in blocks",
            Self::Loads => "the loads",
            Self::Pairs => "the pairs that may touch",
            Self::PairRows => "the rows of the pairs",
            Self::Nears => "the gaps of the pairs",
            Self::Pushes => "the forces of the pairs",
            Self::Moves => "the moves of the nodes",
            Self::Shares => "the shares of moves that pairs leave",
            Self::Ways => "the ways of the nodes",
            Self::Touch => "what contact does",
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

/// The parts of kernels that work on blocks of a sheet.
fn in_blocks(variant: &Variant) -> Vec<&'static str> {
    [springs_of_block(variant), vec![wgsl::BLOCK_WORDS, wgsl::BLOCK_NODES, wgsl::BLOCK_CREASES]].concat()
}

/// The parts of kernels that have a whole sheet.
fn whole_sheet(variant: &Variant) -> Vec<&'static str> {
    let own = vec![wgsl::RAMP, wgsl::SMALL_SHEET, soft_creases(variant), wgsl::ROW_SUMS, wgsl::BLOCK_ROW_SUMS];
    [springs_of_block(variant), own, vec![wgsl::REDUCE, wgsl::WINDOWS, wgsl::SETTLING]].concat()
}

/// The springs of a block, wherever it is.
fn springs_of_block(variant: &Variant) -> Vec<&'static str> {
    let mut parts = vec![variant.material(), variant.soft(), wgsl::ANGLE, wgsl::HINGE, wgsl::FACE, wgsl::LOOSE_BEAM];
    parts.extend([wgsl::BLOCK, wgsl::BLOCK_ANGLES]);
    parts.extend(match variant.corners {
        true => &[wgsl::CORNER_ANGLES, wgsl::BLOCK_CORNERS][..],
        false => &[wgsl::CORNER_ANGLES_NONE],
    });
    parts.extend(if variant.areas { &[wgsl::AREAS, wgsl::BLOCK_AREAS][..] } else { &[wgsl::AREAS_NONE] });
    parts.push(if variant.rigidities { wgsl::BLOCK_RIGIDITY_OWN } else { wgsl::RIGIDITY_UNIFORM });
    parts.push(if variant.loads { wgsl::LOADS } else { wgsl::LOADS_NONE });
    parts.extend([wgsl::FOLD_ANGLES, wgsl::TRIANGLE_FORCES, wgsl::CLOCK, wgsl::BLOCK_SPRINGS]);
    parts
}

/// The part that tells what creases on the wrong side add to the row sums.
fn soft_creases(variant: &Variant) -> &'static str {
    if variant.softens { wgsl::SOFT_CREASES } else { wgsl::SOFT_CREASES_NONE }
}

/// The parts of FIRE.
fn fire(variant: &Variant) -> Vec<&'static str> {
    vec![variant.soft(), wgsl::FIRE]
}

/// The parts that sum the forces on a node.
fn gather(variant: &Variant) -> Vec<&'static str> {
    if variant.blocks.is_some() { vec![wgsl::BLOCK_GATHER] } else { vec![wgsl::SLOTS, wgsl::GATHER] }
}

/// The parts that tell the force on a node.
fn force_on(variant: &Variant) -> Vec<&'static str> {
    let mut parts = gather(variant);
    parts.extend(match variant.contact {
        Some(_) => &[wgsl::PAIR_ROWS, wgsl::PUSHES, wgsl::FORCE_IN_CONTACT][..],
        None => &[wgsl::FORCE_OF_SPRINGS],
    });
    parts
}

/// The parts of kernels that work on pairs.
fn pairs(variant: &Variant) -> Vec<&'static str> {
    let thick = variant.contact.is_some_and(|contact| contact.thick);
    vec![wgsl::PAIR_ROWS, wgsl::PAIRS, if thick { wgsl::THICK } else { wgsl::THICK_NONE }]
}

/// The parts that tell how stiff a crease is.
fn creases(variant: &Variant) -> Vec<&'static str> {
    let mut parts = vec![variant.material(), variant.soft(), wgsl::ANGLE, wgsl::RAMP, wgsl::HINGE, wgsl::FACE];
    parts.extend([wgsl::WHOLE_NODES, wgsl::WHOLE_CREASES, wgsl::WHOLE_LISTS]);
    parts
}

/// The parts that the triangles' forces and row sums have in common.
fn springs(variant: &Variant) -> Vec<&'static str> {
    let mut parts = creases(variant);
    parts.push(wgsl::SLOTS);
    parts.extend(if variant.corners {
        &[wgsl::CORNER_ANGLES, wgsl::WHOLE_CORNERS][..]
    } else {
        &[wgsl::CORNER_ANGLES_NONE]
    });
    parts.extend(if variant.areas { &[wgsl::AREAS, wgsl::WHOLE_AREAS][..] } else { &[wgsl::AREAS_NONE] });
    parts.push(if variant.rigidities { wgsl::RIGIDITY_OWN } else { wgsl::RIGIDITY_UNIFORM });
    parts
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use naga::{AddressSpace, ArraySize, Module, ShaderStage, TypeInner};

    use super::*;
    use crate::paper::PASSES;
    use crate::plan::Plan;
    use crate::shader_checks::{bindings, checked};
    use crate::testing::variants;

    const ALL: [&Kernel; 32] = [
        &block_clock::KERNEL,
        &block_dynamics::KERNEL,
        &block_forces::KERNEL,
        &block_relax::KERNEL,
        &bring_home::KERNEL,
        &fire_update::KERNEL,
        &fold_angles::KERNEL,
        &triangle_forces::KERNEL,
        &settle_decide::KERNEL,
        &checkpoint::KERNEL,
        &contact_aim::KERNEL,
        &contact_clock::KERNEL,
        &contact_move::KERNEL,
        &contact_reduce::KERNEL,
        &pair_forces::KERNEL,
        &pair_limits::KERNEL,
        &loose_beams::KERNEL,
        &fire_move::KERNEL,
        &integrate::KERNEL,
        &safe_time_step::KERNEL,
        &row_sums::KERNEL,
        &settle_windows::KERNEL,
        &stiffness_max::KERNEL,
        &state_bounds::KERNEL,
        &reduce_forces::KERNEL,
        &workgroup_dynamics::KERNEL,
        &workgroup_relax::KERNEL,
        // With those of the paper, which are made of the same.
        PASSES[0],
        PASSES[1],
        PASSES[2],
        PASSES[3],
        PASSES[4],
    ];

    /// What every WebGPU device has.
    const STORAGE_BUFFERS: usize = 8;
    const INVOCATIONS: u32 = 256;
    const WORKGROUP_STORAGE: u32 = 16_384;

    /// Whether the engine ever builds it so.
    fn is_built(kernel: &Kernel, variant: &Variant) -> bool {
        if variant.blocks.is_some() {
            let plan = Plan::new(variant, true);
            let lists =
                [plan.forces.as_slice(), plan.settling, plan.row_sums, plan.integration, plan.checkpoint, plan.home];
            let whole = kernel.springs && kernel.per == Per::Instance;
            return whole || lists.concat().iter().any(|planned| planned.name == kernel.name);
        }
        let of_contact = kernel.per == Per::Pair || kernel.name.starts_with("contact");
        let without = [reduce_forces::KERNEL.name, fire_move::KERNEL.name];
        if if variant.contact.is_some() { without.contains(&kernel.name) } else { of_contact } {
            return false;
        }
        let of_blocks =
            kernel.per == Per::Block || [block_clock::KERNEL.name, bring_home::KERNEL.name].contains(&kernel.name);
        !of_blocks && (kernel.per != Per::Instance || !kernel.springs)
    }

    /// Every kernel in every variant that has a text of its own: constants alone do not change it.
    fn texts() -> impl Iterator<Item = (&'static Kernel, Variant, String)> {
        let all = variants::of_texts().into_iter().flat_map(|variant| ALL.map(|kernel| (kernel, variant.clone())));
        all.filter(|(kernel, variant)| is_built(kernel, variant)).map(|(kernel, variant)| {
            let text = kernel.source(&variant);
            (kernel, variant, text)
        })
    }

    /// The constants of a module that get no value from `given`.
    fn without_value(module: &Module, given: &[(&str, f64)]) -> Vec<String> {
        let names = module.overrides.iter().filter_map(|(_, constant)| constant.name.clone());
        names.filter(|name| given.iter().all(|(known, _)| known != name)).collect()
    }

    /// Bytes of a module's workgroup variables, with these values for the constants that arrays are as long as.
    fn workgroup_storage(module: &Module, given: &[(&str, f64)]) -> u32 {
        let variables = module.global_variables.iter().map(|(_, variable)| variable);
        let shared = variables.filter(|variable| variable.space == AddressSpace::WorkGroup);
        let value = |constant: naga::Handle<naga::Override>| {
            let name = module.overrides[constant].name.as_deref();
            given.iter().find(|(known, _)| Some(*known) == name).expect("it has a value").1 as u32
        };
        let size = |variable: &naga::GlobalVariable| match module.types[variable.ty].inner {
            TypeInner::Array { size: ArraySize::Pending(length), stride, .. } => stride * value(length),
            ref inner => inner.size(module.to_ctx()),
        };
        shared.map(size).sum()
    }

    #[test]
    fn each_kernel_is_valid_and_touches_what_it_is_given() {
        let mut count = 0;
        for (kernel, variant, text) in texts() {
            let shader = checked(kernel.name, &text);
            let given: BTreeSet<u32> = kernel.bindings(&variant).into_iter().map(|binding| binding as u32).collect();
            assert_eq!(
                bindings(&shader, kernel.entry),
                given,
                "{} of {variant:?}: in the shader, in Rust",
                kernel.name
            );
            let storage = given.iter().filter(|binding| **binding != Binding::Settings as u32).count();
            assert!(storage <= STORAGE_BUFFERS, "{} of {variant:?} fits the default limits", kernel.name);
            count += 1;
        }
        assert!(count > 100, "{count} texts");
    }

    #[test]
    fn each_constant_gets_a_value_and_workgroups_are_small_enough() {
        for (kernel, variant, text) in texts() {
            let module = naga::front::wgsl::parse_str(&text).expect("valid");
            let constants = variant.constants(false);
            let missing = without_value(&module, &constants);
            assert!(missing.is_empty(), "{}: {missing:?} have no value", kernel.name);
            let storage = workgroup_storage(&module, &constants);
            assert!(storage <= WORKGROUP_STORAGE, "{}", kernel.name);
            let room = variant.blocks.filter(|_| kernel.springs).map(|blocks| match kernel.per {
                Per::Block => blocks.room.memory(),
                _ => blocks.room.memory_of_whole(variant.small.words, variant.workgroup as usize),
            });
            assert!(
                room.is_none_or(|room| storage as usize == room),
                "{}: {storage} bytes, {room:?} counted",
                kernel.name
            );
            let entry = module.entry_points.iter().find(|entry| entry.name == kernel.entry).expect("it is there");
            assert_eq!(entry.stage, ShaderStage::Compute);
            // Either one invocation or as many as the constant says, which is no more than 256.
            let by_constant = entry.workgroup_size_overrides.is_some_and(|sizes| sizes[0].is_some());
            assert!(by_constant || entry.workgroup_size == [1, 1, 1], "{}", kernel.name);
        }
    }

    #[test]
    fn workgroups_have_what_every_device_has_and_a_power_of_two() {
        for variant in variants::of_texts() {
            assert!(variant.workgroup <= INVOCATIONS && variant.workgroup.is_power_of_two(), "{variant:?}");
        }
    }

    #[test]
    fn each_kernel_has_the_shader_of_its_name() {
        for kernel in ALL {
            let file = format!("{}.wgsl", kernel.name);
            let folder = if kernel.shared == SHARED { wgsl::ALL } else { wgsl::paper::ALL };
            let of_this_name = |(name, _): &&(&str, &str)| name.rsplit('/').next() == Some(file.as_str());
            let (_, text) = folder.iter().find(of_this_name).expect("a file of this name");
            assert_eq!(*text, kernel.text, "{file}");
        }
    }

    #[test]
    fn the_checks_can_fail() {
        let text = "override KNOWN: u32 = 1u; override NEW: f32 = 2.0; var<workgroup> some: array<vec4<f32>, KNOWN>;
            var<workgroup> one: u32;
            @compute @workgroup_size(KNOWN) fn f() { some[0] = vec4<f32>(NEW); one = 1u; }";
        let module = naga::front::wgsl::parse_str(text).expect("valid");
        assert_eq!(without_value(&module, &[("KNOWN", 1.0)]), ["NEW"]);
        assert_eq!(workgroup_storage(&module, &[("KNOWN", 1024.0)]), 16_388);
    }
}
