//! What a page may ask, and what it is told. Angles are in degrees here, as in files; positions are in radii of the sheet.

use std::collections::BTreeMap;

use origami_core::model::Material;
use origami_core::solve::DEFAULT_TOLERANCE;
use serde::{Deserialize, Serialize};

/// What a page asks.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(tag = "do", rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Request {
    /// Which patterns can be generated. Answered by [`Reply::Catalog`].
    Catalog,
    /// Opens the crease pattern in the body, whatever its format. Answered by [`Reply::Opened`].
    Open {
        /// The file's name, which errors begin with and exports are named after.
        name: String,
    },
    /// Opens what a generator makes. Answered by [`Reply::Opened`].
    Generate {
        /// The generator.
        name: String,
        /// Values of its parameters; those that are not named have their defaults.
        #[serde(default)]
        parameters: Vec<(String, f64)>,
    },
    /// Folds all creases that have no angle of their own to so many per cent of the pattern's angles. Negative: the other way.
    Fold {
        /// Any number; a page has -100 to 100.
        percent: f64,
    },
    /// Gives edges of the pattern an angle of their own, frees them, or gives them back to the pattern.
    Crease {
        /// Which, as in the file.
        edges: Vec<u32>,
        /// What becomes of them; null: as the pattern has them.
        own: Option<Own>,
    },
    /// Holds a node where it is.
    Grab {
        /// Which.
        node: u32,
    },
    /// Moves a held node.
    Drag {
        /// Which.
        node: u32,
        /// Where to, in radii.
        to: [f64; 3],
    },
    /// Lets a held node go.
    Release {
        /// Which.
        node: u32,
    },
    /// Takes another material. The sheet keeps its shape and moves on from there.
    Material(Material),
    /// Takes another solver, likewise.
    Solver(SolverWish),
    /// Whether the sheet moves by itself until it has settled.
    Run {
        /// Not: only by [`Request::Step`].
        on: bool,
    },
    /// Takes so many steps, settled or not, and stops.
    Step {
        /// How many; 100 000 at most.
        count: u64,
    },
    /// The sheet as the file has it, and nothing asked of it.
    Reset,
    /// Remembers what is now, to come back by [`Request::Undo`]: before each thing that a hand does. Answered by
    /// [`Reply::Marked`].
    Mark,
    /// Back to the last mark.
    Undo,
    /// Forward again.
    Redo,
    /// The next picture of the sheet, as soon as there is something new in it. Answered by one [`Reply::Frame`].
    Frame {
        /// What colours its nodes.
        #[serde(default)]
        map: MapWish,
    },
    /// Folds from the flat sheet on and keeps each state that settles, to go through them by [`Request::Show`]. Pictures tell how
    /// far it has come ([`FrameHead::recorded`]). Whatever else moves the sheet ends it.
    Record {
        /// Which way it goes.
        way: Way,
        /// Whether paper keeps off paper ([`origami_core::solve::ContactRelax`]).
        #[serde(default)]
        contact: bool,
        /// How many states are kept of each step, or of the way to a percentage; 1 000 at most. More: a smoother film.
        parts: u32,
    },
    /// Shows a recorded state.
    Show {
        /// Its number from 0; between two of them vertices go straight.
        at: f64,
    },
    /// Back from what was recorded to the sheet that moves.
    Live,
    /// What was recorded, as one page that can be turned and needs no program. Answered by [`Reply::File`].
    Film,
    /// A file of the sheet as it is now, or as the recording shows it. Answered by [`Reply::File`].
    Export {
        /// Which.
        format: ExportFormat,
    },
    /// All that it takes to go on some other day. Answered by [`Reply::File`].
    Save,
    /// Goes on from such a file, in the body. Answered by [`Reply::Opened`].
    Restore,
}

impl Request {
    /// Whether it is about the sheet itself, so that nobody looks at a recording any more.
    pub(crate) fn moves_the_sheet(&self) -> bool {
        !matches!(
            self,
            Self::Frame { .. }
                | Self::Catalog
                | Self::Record { .. }
                | Self::Show { .. }
                | Self::Film
                | Self::Export { .. }
                | Self::Save
                | Self::Mark
                | Self::Run { .. }
        )
    }
}

/// Which way a recording goes.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Way {
    /// Through the steps of the file, as `origami fold --sequence own`.
    Steps,
    /// To so many per cent of the pattern's angles, as `origami fold --percent`; creases with wishes of their own keep them.
    Percent(f64),
}

/// What becomes of a crease.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Own {
    /// It folds to this angle, whatever the percentage; valleys are positive.
    Angle(f64),
    /// It turns without a spring.
    Free,
}

/// What moves the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct SolverWish {
    /// Which.
    pub name: SolverName,
    /// Distance from the equilibrium at which the sheet has settled, in radii. Smaller: more steps. Default 1e-4.
    pub tolerance: f64,
    /// For dynamics. Default Euler's, the paper's.
    pub integrator: IntegratorName,
    /// The processor's numbers. Default f64.
    pub precision: PrecisionName,
}

impl Default for SolverWish {
    fn default() -> Self {
        Self {
            name: SolverName::Relax,
            tolerance: DEFAULT_TOLERANCE,
            integrator: IntegratorName::Euler,
            precision: PrecisionName::F64,
        }
    }
}

/// A solver that goes by steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SolverName {
    /// Straight to the folded state.
    #[default]
    Relax,
    /// Through the damped motion of the paper.
    Dynamics,
}

/// How dynamics goes from step to step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum IntegratorName {
    /// The paper's.
    #[default]
    Euler,
    /// Verlet's.
    Verlet,
}

/// The numbers that the processor computes in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PrecisionName {
    /// 64 bits.
    #[default]
    F64,
    /// 32 bits where they will do: faster on large sheets.
    Mixed,
}

/// What colours the nodes of a sheet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum MapWish {
    /// Nothing: paper.
    #[default]
    None,
    /// Mean strain of the beams at each node, 0.01 being 1 %.
    Strain,
    /// The largest difference between the angle reached and the angle asked for, of the creases at each node, in degrees.
    AngleError,
    /// Energy of the creases and beams at each node, each spring's shared by its nodes; in the unit of the model.
    Energy,
}

/// A file of a folded sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ExportFormat {
    /// FOLD, as `origami fold` writes it.
    Fold,
    /// Wavefront OBJ.
    Obj,
    /// Binary STL.
    Stl,
    /// Binary glTF.
    Glb,
}

/// All that is asked of a sheet: what marks remember, what is saved, and what a page shows beside the sheet.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Wishes {
    /// Per cent of the pattern's angles.
    pub percent: f64,
    /// Edges with a wish of their own.
    pub creases: BTreeMap<u32, Own>,
    /// Nodes that are held, and where, in radii.
    pub pins: BTreeMap<u32, [f64; 3]>,
    /// What the sheet is made of.
    pub material: Material,
    /// What moves it.
    pub solver: SolverWish,
}

/// What a page is told.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "is", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Reply {
    /// What can be generated.
    Catalog {
        /// All of it.
        entries: Vec<CatalogEntry>,
    },
    /// A pattern was opened; the body has, of four bytes each: x, y, z of each node at rest in radii; three nodes of each
    /// triangle; two nodes of each edge; the fold angle of each edge in degrees, not a number where it has none; the face of each
    /// triangle.
    Opened(Box<Opened>),
    /// What is asked of the sheet, where that has changed by other means than what the page has just asked.
    Wishes {
        /// Now.
        wishes: Wishes,
        /// Whether there is a mark to go back to.
        can_undo: bool,
        /// Whether there is one to go forward to.
        can_redo: bool,
    },
    /// What there is to go back and forward to, once a mark was set.
    Marked {
        /// Whether there is a mark to go back to.
        can_undo: bool,
        /// Whether there is one to go forward to.
        can_redo: bool,
    },
    /// A picture; the body has x, y, z and the map's value of each node as f32.
    Frame(Box<FrameHead>),
    /// A file, in the body.
    File {
        /// Its name.
        name: String,
        /// Its media type.
        media: &'static str,
    },
    /// Something could not be done. The sheet is as it was.
    Error {
        /// The kind, as in reports of the command line; `request` where the page has asked for what there is not.
        code: String,
        /// For a person, as the command line says it.
        text: String,
    },
}

/// A generator.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CatalogEntry {
    /// Its name.
    pub name: &'static str,
    /// What it makes.
    pub summary: &'static str,
    /// Its parameters.
    pub parameters: Vec<CatalogParameter>,
    /// What it makes, seen from above.
    pub picture: Drawing,
}

/// The lines of a pattern.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Drawing {
    /// x and y of each vertex.
    pub points: Vec<f64>,
    /// Two vertices of each edge.
    pub ends: Vec<u32>,
    /// The letter of each edge in FOLD.
    pub letters: String,
}

/// A number that a generator takes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CatalogParameter {
    /// Its name.
    pub name: &'static str,
    /// Its value where none is given.
    pub default: f64,
    /// Meaning, unit and range.
    pub meaning: &'static str,
}

/// What a page needs to know of a pattern.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Opened {
    /// The file's name.
    pub name: String,
    /// The file's format, or that it was generated.
    pub format: String,
    /// The title in the file, where it has one.
    pub title: Option<String>,
    /// Nodes of the sheet.
    pub nodes: usize,
    /// Triangles of the sheet.
    pub triangles: usize,
    /// Edges of the pattern, borders included.
    pub edges: usize,
    /// Creases with a spring, diagonals of faces among them.
    pub creases: usize,
    /// Letters of the edges in FOLD, one for each.
    pub letters: String,
    /// Whether the pattern lies in one plane.
    pub flat: bool,
    /// What computes.
    pub computer: String,
    /// The steps of the sequence in the file; empty where it has none.
    pub steps: Vec<String>,
    /// What is odd about it.
    pub warnings: Vec<Note>,
    /// What is asked of it.
    pub wishes: Wishes,
}

/// Something odd, and where.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Note {
    /// The kind, as in reports of the command line.
    pub code: &'static str,
    /// For a person.
    pub text: String,
    /// Nodes where it is.
    pub nodes: Vec<u32>,
    /// Edges where it is.
    pub edges: Vec<u32>,
}

/// How the sheet is.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct FrameHead {
    /// Counted from 1.
    pub frame: u64,
    /// Steps since the solver began.
    pub steps: u64,
    /// Whether the sheet is within the tolerance of its equilibrium.
    pub settled: bool,
    /// Whether it moves.
    pub running: bool,
    /// Estimated distance from the equilibrium, in radii; null while there is none.
    pub distance: Option<f64>,
    /// The share of the way to the angles asked for at which the springs pull, 0 to 1.
    pub ramp: f64,
    /// The percentage asked for.
    pub percent: f64,
    /// Mean strain of the beams; 0.01 is 1 %.
    pub strain_mean: f64,
    /// Largest strain of a beam.
    pub strain_max: f64,
    /// Elastic energy, in the unit of the model.
    pub energy: f64,
    /// Largest difference between the angle of a crease and the angle asked of it, in degrees.
    pub angle_error_max: f64,
    /// Creases that went astray: more than half a turn from their angle, or through the paper.
    pub lost_creases: usize,
    /// Triangles crushed to a line.
    pub crushed: usize,
    /// Where paper goes through paper: of sheets that stand still, and now and then of small ones that move; else null.
    pub crossings: Option<Crossed>,
    /// What is shown of a recording; null where the sheet itself is seen.
    pub recorded: Option<Recorded>,
    /// What the map shows.
    pub map: MapWish,
    /// Its largest value.
    pub map_max: f64,
    /// Why the sheet stopped where it blew up, as the command line says it.
    pub failed: Option<String>,
}

/// Where paper goes through paper.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Crossed {
    /// Edges of triangles that go through other triangles, each with each.
    pub count: usize,
    /// How deep the deepest goes, in radii.
    pub deepest: f64,
    /// Faces that cross, the first of them in pairs.
    pub faces: Vec<[u32; 2]>,
}

/// What is shown of a recording.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Recorded {
    /// The number of the state that is shown, as in [`Request::Show`].
    pub at: f64,
    /// States that are there.
    pub states: usize,
    /// States that it will have.
    pub of: usize,
    /// What the state is called: its step, or its percentage.
    pub label: String,
    /// Why it ended before its end, for a person.
    pub ended: Option<String>,
}
