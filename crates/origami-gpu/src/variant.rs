//! What a scene's pipelines are specialised to: which parts they are put together from, and which numbers are constants.

use origami_core::model::{DEGENERATE, Material};
use origami_core::solve::{fire, guard, relax, settle, time_step};
use origami_shaders as wgsl;

use crate::scene::Scene;

/// What moves the nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Motion {
    Relax,
    Dynamics { verlet: bool, damped: bool },
}

/// Nodes from which a workgroup has 256 invocations instead of 64: fewer partial sums.
const LARGE: usize = 16_384;

/// One way to build the kernels.
#[derive(Clone, Debug)]
pub(crate) struct Variant {
    pub(crate) motion: Motion,
    pub(crate) corners: bool,
    pub(crate) rigidities: bool,
    pub(crate) fixed: bool,
    /// The material of all instances; `None` where they differ.
    pub(crate) material: Option<Material>,
    pub(crate) nodes: usize,
    pub(crate) creases: usize,
    pub(crate) faces: usize,
    pub(crate) loose_beams: usize,
    pub(crate) slots: usize,
    pub(crate) workgroup: u32,
    /// Steps of one dispatch where a workgroup takes many.
    pub(crate) steps: u32,
}

impl Variant {
    /// That of a scene. `material` is that of all instances, or `None` where they differ.
    pub(crate) fn new(scene: &Scene, motion: Motion, material: Option<Material>) -> Self {
        Self {
            motion,
            corners: !scene.corners.is_empty(),
            rigidities: !scene.rigidities.is_empty(),
            fixed: scene.fixed,
            material,
            nodes: scene.nodes,
            creases: scene.hinges.len(),
            faces: scene.faces.len(),
            loose_beams: scene.loose_beams.len(),
            slots: scene.slot_count(),
            workgroup: if scene.nodes > LARGE { 256 } else { 64 },
            steps: 1,
        }
    }

    /// Workgroups over `count` elements.
    pub(crate) fn groups(&self, count: usize) -> usize {
        count.div_ceil(self.workgroup as usize)
    }

    pub(crate) fn relaxing(&self) -> bool {
        self.motion == Motion::Relax
    }

    pub(crate) fn damped(&self) -> bool {
        matches!(self.motion, Motion::Dynamics { damped: true, .. })
    }

    /// The same without damping: what the stopping rule of dynamics looks at.
    pub(crate) fn undamped(&self) -> Self {
        let motion = match self.motion {
            Motion::Dynamics { verlet, .. } => Motion::Dynamics { verlet, damped: false },
            Motion::Relax => Motion::Relax,
        };
        Self { motion, ..self.clone() }
    }

    /// The part that gives the material.
    pub(crate) fn material(&self) -> &'static str {
        if self.material.is_some() { wgsl::MATERIAL_UNIFORM } else { wgsl::MATERIAL_VARIED }
    }

    /// Every constant that a shader may ask for. `ticks`: whether the faces' pass keeps the time.
    pub(crate) fn constants(&self, ticks: bool) -> Vec<(&'static str, f64)> {
        let is = |yes: bool| f64::from(u8::from(yes));
        let material = self.material.unwrap_or_default();
        let (verlet, damped) = match self.motion {
            Motion::Dynamics { verlet, damped } => (verlet, damped),
            Motion::Relax => (false, false),
        };
        vec![
            ("NODES", self.nodes as f64),
            ("CREASES", self.creases as f64),
            ("FACES", self.faces as f64),
            ("LOOSE_BEAMS", self.loose_beams as f64),
            ("SLOTS", self.slots as f64),
            ("WORKGROUP", f64::from(self.workgroup)),
            ("GROUPS", self.groups(self.nodes) as f64),
            ("STEPS", f64::from(self.steps)),
            ("RELAXING", is(self.relaxing())),
            ("DAMPED", is(damped)),
            ("VERLET", is(verlet)),
            ("FIXED", is(self.fixed)),
            ("TICKS", is(ticks)),
            ("EA", material.ea),
            ("K_FOLD", material.k_fold),
            ("K_FACET", material.k_facet),
            ("K_FACE", material.k_face),
            ("ZETA", material.zeta),
            ("DEGENERATE", DEGENERATE),
            ("HOLD", relax::HOLD),
            ("FARTHEST", guard::FARTHEST),
            ("LONGEST_MOVE", guard::LONGEST_MOVE),
            ("GOOD_POSITION", guard::GOOD_POSITION),
            ("GOOD_MOVE", guard::GOOD_MOVE),
            ("SAFE_SHARE", time_step::SAFE_SHARE),
            ("SAFE_MOVE", time_step::SAFE_MOVE),
            ("SAFE_GROWTH", time_step::SAFE_GROWTH),
            ("FIRE_RENEWAL", fire::RENEWAL as f64),
            ("LONGEST_STEP", fire::LONGEST_STEP),
            ("SHORTEST_STEP", fire::SHORTEST_STEP),
            ("LONGER", fire::LONGER),
            ("SHORTER", fire::SHORTER),
            ("MIXING", fire::MIXING),
            ("LESS_MIXING", fire::LESS_MIXING),
            ("PATIENCE", f64::from(fire::PATIENCE)),
            ("WINDOWS", f64::from(settle::WINDOWS)),
            ("SHARE", settle::SHARE),
            ("SMALL_SHARE", settle::SMALL_SHARE),
            ("LEAST_TICKS", settle::LEAST.div_ceil(settle::SHORTEST) as f64),
            ("SHARE_OF_PAST", settle::SHARE_OF_PAST),
        ]
    }
}
