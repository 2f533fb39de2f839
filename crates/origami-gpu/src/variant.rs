//! What a sheet's pipelines are specialised to: which parts they are put together from, and which numbers are constants.

use origami_core::contact::constants as contact;
use origami_core::forces::areas::THRESHOLD;
use origami_core::model::{DEGENERATE, Material};
use origami_core::twins::{checkpoint, fire_update, safe_time_step, settle_decide, state_bounds};
use origami_shaders as wgsl;

use crate::blocks::{Blocks, Extent, INVOCATIONS};
use crate::sheet_arrays::SheetArrays;

/// What moves the nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scheme {
    Relax,
    Dynamics { verlet: bool, damped: bool },
}

/// What the kernels of one workgroup a sheet are built for.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Small {
    /// Steps of one dispatch.
    pub(crate) steps: u32,
    /// Words of the sheet's lists.
    pub(crate) words: usize,
    /// Steps between two renewals of the time step; 0 where it stays.
    pub(crate) renewal: u64,
}

/// What the kernels of a sheet are built for whose layers push each other away.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InContact {
    pub(crate) stiffness: f64,
    /// Whether the paper has a thickness.
    pub(crate) thick: bool,
    /// The farthest that a node may move in one evaluation, in radii.
    pub(crate) longest_move: f64,
    /// Evaluations at the final targets for which it goes on while it is held up.
    pub(crate) patience: u64,
}

/// Nodes from which a workgroup has 256 invocations instead of 64: fewer partial sums.
const LARGE: usize = 16_384;

/// One way to build the kernels.
#[derive(Clone, Debug)]
pub(crate) struct Variant {
    pub(crate) scheme: Scheme,
    pub(crate) corners: bool,
    pub(crate) rigidities: bool,
    /// Whether areas of triangles resist.
    pub(crate) areas: bool,
    /// Whether some sheets are soft on their way.
    pub(crate) softens: bool,
    pub(crate) fixed: bool,
    /// The material of all instances; `None` where they differ.
    pub(crate) material: Option<Material>,
    pub(crate) nodes: usize,
    pub(crate) creases: usize,
    pub(crate) faces: usize,
    pub(crate) loose_beams: usize,
    pub(crate) slots: usize,
    /// Whether some nodes are loaded, or may be; asked by blocks only.
    pub(crate) loads: bool,
    /// Of a sheet that goes by blocks.
    pub(crate) blocks: Option<Extent>,
    pub(crate) workgroup: u32,
    /// Of a sheet that one workgroup has.
    pub(crate) small: Small,
    /// Of a sheet whose layers push each other away.
    pub(crate) contact: Option<InContact>,
}

impl Variant {
    /// The variant for a sheet. `material` is that of all instances, or `None` where they differ.
    pub(crate) fn new(arrays: &SheetArrays, scheme: Scheme, material: Option<Material>) -> Self {
        Self {
            scheme,
            corners: !arrays.corners.is_empty(),
            rigidities: !arrays.rigidities.is_empty(),
            areas: arrays.areas,
            softens: false,
            fixed: arrays.fixed,
            material,
            nodes: arrays.nodes,
            creases: arrays.hinges.len(),
            faces: arrays.faces.len(),
            loose_beams: arrays.loose_beams.len(),
            slots: arrays.slot_count(),
            loads: !arrays.load_slots.is_empty(),
            blocks: None,
            workgroup: if arrays.nodes > LARGE { 256 } else { 64 },
            small: Small::default(),
            contact: None,
        }
    }

    /// The same by blocks: creases are counted as often as blocks have them.
    pub(crate) fn in_blocks(&self, blocks: &Blocks) -> Self {
        Self { blocks: Some(blocks.extent), creases: blocks.copies.of.len(), ..self.clone() }
    }

    /// The same for the kernels that work on blocks.
    pub(crate) fn of_a_block(&self) -> Self {
        Self { workgroup: INVOCATIONS, ..self.clone() }
    }

    /// How many sums FIRE gets for an instance.
    pub(crate) fn sums(&self) -> usize {
        self.blocks.map_or(self.groups(self.nodes), |blocks| blocks.count)
    }

    /// Workgroups over `count` elements.
    pub(crate) fn groups(&self, count: usize) -> usize {
        count.div_ceil(self.workgroup as usize)
    }

    pub(crate) fn relaxing(&self) -> bool {
        self.scheme == Scheme::Relax
    }

    pub(crate) fn damped(&self) -> bool {
        matches!(self.scheme, Scheme::Dynamics { damped: true, .. })
    }

    /// The same without damping: what the stopping rule of dynamics takes the forces of.
    pub(crate) fn undamped(&self) -> Self {
        let scheme = match self.scheme {
            Scheme::Dynamics { verlet, .. } => Scheme::Dynamics { verlet, damped: false },
            Scheme::Relax => Scheme::Relax,
        };
        Self { scheme, ..self.clone() }
    }

    /// The part that gives the material.
    pub(crate) fn material(&self) -> &'static str {
        if self.material.is_some() { wgsl::MATERIAL_UNIFORM } else { wgsl::MATERIAL_VARIED }
    }

    /// The part that says how soft the sheet is on its way.
    pub(crate) fn soft(&self) -> &'static str {
        if self.softens { wgsl::SOFT } else { wgsl::SOFT_NONE }
    }

    /// Every constant that a shader may ask for. `advances_clock`: whether the pass over the triangles keeps the time.
    pub(crate) fn constants(&self, advances_clock: bool) -> Vec<(&'static str, f64)> {
        let is = |yes: bool| f64::from(u8::from(yes));
        let material = self.material.unwrap_or_default();
        let (verlet, damped) = match self.scheme {
            Scheme::Dynamics { verlet, damped } => (verlet, damped),
            Scheme::Relax => (false, false),
        };
        let room = self.blocks.unwrap_or_default().room;
        let mut constants = vec![
            ("NODES", self.nodes as f64),
            ("CREASES", self.creases as f64),
            ("FACES", self.faces as f64),
            ("LOOSE_BEAMS", self.loose_beams as f64),
            ("SLOTS", self.slots as f64),
            ("WORKGROUP", f64::from(self.workgroup)),
            ("GROUPS", self.groups(self.nodes) as f64),
            ("SUMS", self.sums() as f64),
            ("POSITION_WORDS", 3.0 * room.nodes as f64),
            ("MOMENTS", room.creases as f64),
            ("FORCE_WORDS", 3.0 * room.slots as f64),
            ("STEPS", f64::from(self.small.steps)),
            ("LIST_WORDS", self.small.words as f64),
            ("SAFE_RENEWAL", self.small.renewal as f64),
            ("CHECK_INTERVAL", settle_decide::SHORTEST as f64),
            ("RELAXING", is(self.relaxing())),
            ("DAMPED", is(damped)),
            ("VERLET", is(verlet)),
            ("FIXED", is(self.fixed)),
            ("ADVANCES_CLOCK", is(advances_clock)),
            ("EA", material.ea),
            ("K_FOLD", material.k_fold),
            ("K_FACET", material.k_facet),
            ("K_FACE", material.k_face),
            ("ZETA", material.zeta),
            ("THRESHOLD", THRESHOLD),
            ("DEGENERATE", DEGENERATE),
            ("HOLD", fire_update::HOLD),
            ("FARTHEST", state_bounds::FARTHEST),
            ("LONGEST_MOVE", state_bounds::LONGEST_MOVE),
            ("GOOD_POSITION", checkpoint::GOOD_POSITION),
            ("GOOD_MOVE", checkpoint::GOOD_MOVE),
            ("SAFE_SHARE", safe_time_step::SAFE_SHARE),
            ("SAFE_MOVE", safe_time_step::SAFE_MOVE),
            ("SAFE_GROWTH", safe_time_step::SAFE_GROWTH),
            ("FIRE_RENEWAL", fire_update::RENEWAL as f64),
            ("LONGEST_STEP", fire_update::LONGEST_STEP),
            ("SHORTEST_STEP", fire_update::SHORTEST_STEP),
            ("LONGER", fire_update::LONGER),
            ("SHORTER", fire_update::SHORTER),
            ("MIXING", fire_update::MIXING),
            ("LESS_MIXING", fire_update::LESS_MIXING),
            ("PATIENCE", f64::from(fire_update::PATIENCE)),
            ("WINDOWS", f64::from(settle_decide::WINDOWS)),
            ("SHARE", settle_decide::SHARE),
            ("SMALL_SHARE", settle_decide::SMALL_SHARE),
            ("LEAST_CHECKS", settle_decide::LEAST.div_ceil(settle_decide::SHORTEST) as f64),
            ("SHARE_OF_PAST", settle_decide::SHARE_OF_PAST),
        ];
        if let Some(own) = self.contact {
            constants.extend([
                ("CONTACT_STIFFNESS", own.stiffness),
                ("CONTACT_LONGEST", own.longest_move),
                ("HELD_UP_AFTER", own.patience.min(u64::from(u32::MAX)) as f64),
                ("RECENT", checkpoint::COPY_EVERY as f64),
                ("PARALLEL", contact::PARALLEL),
                ("NEARER", contact::NEARER),
                ("WITHIN", contact::WITHIN),
                ("USABLE", contact::USABLE),
            ]);
        }
        constants
    }
}
