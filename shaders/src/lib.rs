//! The WGSL compute shaders of origami as text, one kernel or one part of several kernels a file.
//!
//! A kernel is [`STATE`], the parts that its scene needs and its own file, one after the other; what a scene does without is in
//! no text. `origami_gpu` puts them together and gives the constants that the files declare with `override` their values.
//! `README.md` lists the buffers that they work on.
//!
//! ```
//! use origami_shaders::{ANGLE, paper};
//!
//! // The second of the paper's five passes: the fold angle of each crease.
//! let source = [paper::SHEET, ANGLE, paper::FOLD_ANGLES].concat();
//! assert_eq!(source.matches("@compute").count(), 1);
//! ```
//!
//! [`ALL`] has the name and text of every file of the pipeline, [`paper::ALL`] those of the paper's passes; with the feature
//! `render` there are those of pictures too.
#![forbid(unsafe_code)]

/// Makes a constant of each file, by its name in capitals.
macro_rules! shaders {
    ($($(#[$doc:meta])* $name:ident = $file:literal;)*) => {
        $($(#[$doc])* pub const $name: &str = include_str!($file);)*

        /// All files: name and text.
        pub const ALL: &[(&str, &str)] = &[$(($file, $name)),*];
    };
}

shaders! {
    /// What all kernels share: constants and the control block.
    CONTROL = "control.wgsl";
    /// The state of a sheet, with positions finer than f32.
    STATE = "state.wgsl";
    /// The ramp of the target angles.
    RAMP = "ramp.wgsl";
    /// Angles from sine and cosine.
    ANGLE = "angle.wgsl";
    /// One material for all instances.
    MATERIAL_UNIFORM = "material_uniform.wgsl";
    /// Instances that differ in material.
    MATERIAL_VARIED = "material_varied.wgsl";
    /// All beams of one rigidity.
    RIGIDITY_UNIFORM = "rigidity_uniform.wgsl";
    /// Beams with a rigidity of their own.
    RIGIDITY_OWN = "rigidity_own.wgsl";
    /// Nodes, for passes over all elements.
    WHOLE_NODES = "whole_nodes.wgsl";
    /// The state of the creases, for the same.
    WHOLE_CREASES = "whole_creases.wgsl";
    /// Lists of creases and triangles, for the same.
    WHOLE_LISTS = "whole_lists.wgsl";
    /// Corner angles at rest, for the same.
    WHOLE_CORNERS = "whole_corners.wgsl";
    /// Corner angles of a triangle.
    CORNER_ANGLES = "corner_angles.wgsl";
    /// A scene without them.
    CORNER_ANGLES_NONE = "corner_angles_none.wgsl";
    /// A sheet that is soft on its way.
    SOFT = "soft.wgsl";
    /// One that is not.
    SOFT_NONE = "soft_none.wgsl";
    /// Creases on the wrong side of a soft sheet.
    SOFT_CREASES = "soft_creases.wgsl";
    /// A sheet without such.
    SOFT_CREASES_NONE = "soft_creases_none.wgsl";
    /// Areas of triangles, kept from collapse.
    AREAS = "areas.wgsl";
    /// A scene without them.
    AREAS_NONE = "areas_none.wgsl";
    /// Areas at rest, for passes over all elements.
    WHOLE_AREAS = "whole_areas.wgsl";
    /// Areas at rest, in a block.
    BLOCK_AREAS = "block_areas.wgsl";
    /// Creases as hinges.
    HINGE = "hinge.wgsl";
    /// A triangle and its sides.
    FACE = "face.wgsl";
    /// A beam outside any face.
    LOOSE_BEAM = "loose_beam.wgsl";
    /// Where forces on the nodes are left.
    SLOTS = "slots.wgsl";
    /// Forces on a node, summed in fixed order.
    GATHER = "gather.wgsl";
    /// The force on a node without contact.
    FORCE_OF_SPRINGS = "force_of_springs.wgsl";
    /// The force on a node under contact.
    FORCE_IN_CONTACT = "force_in_contact.wgsl";
    /// The stopping rule's decision.
    SETTLING = "settling.wgsl";
    /// The safe time step.
    TIME_STEP = "time_step.wgsl";
    /// The clock of dynamics.
    CLOCK = "clock.wgsl";
    /// One step of a node.
    MOTION = "motion.wgsl";
    /// Sums over a workgroup.
    REDUCE = "reduce.wgsl";
    /// Sums of the workgroups.
    PARTIALS = "partials.wgsl";
    /// FIRE.
    FIRE = "fire.wgsl";
    /// The stopping rule's memory.
    WINDOWS = "windows.wgsl";
    /// Kernel: fold angles and moments.
    FOLD_ANGLES = "fold_angles.wgsl";
    /// Kernel: forces of triangles on their corners.
    TRIANGLE_FORCES = "triangle_forces.wgsl";
    /// Kernel: beams outside any face.
    LOOSE_BEAMS = "loose_beams.wgsl";
    /// Kernel: sums the forces on the nodes of dynamics, and moves them.
    INTEGRATE = "integrate.wgsl";
    /// Kernel: row sums of the stiffness.
    ROW_SUMS = "row_sums.wgsl";
    /// Kernel: the largest row sum and velocity.
    STIFFNESS_MAX = "stiffness_max.wgsl";
    /// Kernel: the safe time step.
    SAFE_TIME_STEP = "safe_time_step.wgsl";
    /// Kernel: sums the forces on the nodes of a relaxation, for FIRE.
    REDUCE_FORCES = "reduce_forces.wgsl";
    /// Kernel: FIRE's step and mixing.
    FIRE_UPDATE = "fire_update.wgsl";
    /// Kernel: FIRE's move.
    FIRE_MOVE = "fire_move.wgsl";
    /// Kernel: the stopping rule per node.
    SETTLE_WINDOWS = "settle_windows.wgsl";
    /// Kernel: the stopping rule per instance.
    SETTLE_DECIDE = "settle_decide.wgsl";
    /// Kernel: how far out the nodes are and how far they move.
    STATE_BOUNDS = "state_bounds.wgsl";
    /// Kernel: copies a good state.
    CHECKPOINT = "checkpoint.wgsl";
    /// A block: the part of a sheet that one workgroup works on, in its memory.
    BLOCK = "block.wgsl";
    /// The lists of the blocks.
    BLOCK_WORDS = "block_words.wgsl";
    /// Nodes of a block.
    BLOCK_NODES = "block_nodes.wgsl";
    /// Fold angles in blocks.
    BLOCK_ANGLES = "block_angles.wgsl";
    /// The state of a block's creases.
    BLOCK_CREASES = "block_creases.wgsl";
    /// Corner angles at rest, in a block.
    BLOCK_CORNERS = "block_corners.wgsl";
    /// Beams with a rigidity of their own, in a block.
    BLOCK_RIGIDITY_OWN = "block_rigidity_own.wgsl";
    /// All springs of a block.
    BLOCK_SPRINGS = "block_springs.wgsl";
    /// Row sums in a block.
    BLOCK_ROW_SUMS = "block_row_sums.wgsl";
    /// Forces on the nodes, as blocks leave them.
    BLOCK_GATHER = "block_gather.wgsl";
    /// Loads on the nodes of blocks.
    LOADS = "loads.wgsl";
    /// A scene without them.
    LOADS_NONE = "loads_none.wgsl";
    /// Kernel: forces and row sums, by blocks.
    BLOCK_FORCES = "block_forces.wgsl";
    /// Kernel: the clock of dynamics by blocks.
    BLOCK_CLOCK = "block_clock.wgsl";
    /// Kernel: a step of dynamics, by blocks.
    BLOCK_DYNAMICS = "block_dynamics.wgsl";
    /// Kernel: an evaluation of a relaxation, by blocks.
    BLOCK_RELAX = "block_relax.wgsl";
    /// Kernel: nodes to where others look for them.
    BRING_HOME = "bring_home.wgsl";
    /// A small sheet as one block.
    SMALL_SHEET = "small_sheet.wgsl";
    /// Kernel: many steps of dynamics by one workgroup.
    WORKGROUP_DYNAMICS = "workgroup_dynamics.wgsl";
    /// Kernel: many evaluations of a relaxation by one workgroup.
    WORKGROUP_RELAX = "workgroup_relax.wgsl";
    /// Contact: where nodes find what pairs do to them.
    PAIR_ROWS = "pair_rows.wgsl";
    /// Pairs of things that may touch.
    PAIRS = "pairs.wgsl";
    /// Paper with a thickness.
    THICK = "thick.wgsl";
    /// Paper without.
    THICK_NONE = "thick_none.wgsl";
    /// The nearest points of two things.
    DISTANCE = "distance.wgsl";
    /// The energy of a gap.
    BARRIER = "barrier.wgsl";
    /// What pairs do to a node, summed in fixed order.
    PUSHES = "pushes.wgsl";
    /// What nodes are about to do.
    MOVES = "moves.wgsl";
    /// What contact does on the way.
    TOUCH = "touch.wgsl";
    /// Kernel: gaps and forces of pairs.
    PAIR_FORCES = "pair_forces.wgsl";
    /// Kernel: sums the forces on the nodes under contact, for FIRE.
    CONTACT_REDUCE = "contact_reduce.wgsl";
    /// Kernel: the moves that FIRE would make.
    CONTACT_AIM = "contact_aim.wgsl";
    /// Kernel: how much of its move pairs leave to a node.
    PAIR_LIMITS = "pair_limits.wgsl";
    /// Kernel: moves the nodes under contact.
    CONTACT_MOVE = "contact_move.wgsl";
    /// Kernel: keeps count of what contact does.
    CONTACT_CLOCK = "contact_clock.wgsl";
}

/// The paper's five passes over displacements from rest: not the fastest, but the plainest. A kernel is [`CONTROL`],
/// [`MATERIAL_UNIFORM`], [`ANGLE`], [`paper::SHEET`] and one of the passes.
pub mod paper {
    shaders! {
        /// What the passes share.
        SHEET = "paper/sheet.wgsl";
        /// First kernel: normals of the triangles.
        NORMALS = "paper/normals.wgsl";
        /// Second kernel: fold angles.
        FOLD_ANGLES = "paper/fold_angles.wgsl";
        /// Third kernel: coefficients of the creases' forces.
        COEFFICIENTS = "paper/coefficients.wgsl";
        /// Fourth kernel: forces and velocities.
        FORCES = "paper/forces.wgsl";
        /// Fifth kernel: positions.
        POSITIONS = "paper/positions.wgsl";
    }
}

/// Pictures. The sheet and its lines are [`render::SCENE`] and one of the two; [`render::NODE_POSITIONS`] comes after
/// [`CONTROL`] and [`STATE`].
#[cfg(feature = "render")]
pub mod render {
    shaders! {
        /// What the sheet and its lines have in common.
        SCENE = "render/scene.wgsl";
        /// The paper.
        FACES = "render/faces.wgsl";
        /// Lines.
        LINES = "render/lines.wgsl";
        /// Kernel: from light to bytes.
        RESOLVE = "render/resolve.wgsl";
        /// Kernel: positions of a simulation's nodes in f32.
        NODE_POSITIONS = "render/node_positions.wgsl";
        /// Kernel: the nodes that lie farthest in some directions.
        EXTREMES = "render/extremes.wgsl";
    }
}
