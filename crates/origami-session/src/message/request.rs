//! What a page asks.

use origami_core::model::Material;
use serde::{Deserialize, Serialize};

use super::frame::MapWish;
use super::wishes::{Own, SolverWish};

/// What a page asks.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(tag = "do", rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Request {
    /// Which patterns can be generated. Answered by [`Reply::Catalog`](super::Reply::Catalog).
    Catalog,
    /// Opens the crease pattern in the body, whatever its format. Answered by [`Reply::Opened`](super::Reply::Opened).
    Open {
        /// The file's name, which errors begin with and exports are named after.
        name: String,
    },
    /// Opens what a generator makes. Answered by [`Reply::Opened`](super::Reply::Opened).
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
    /// [`Reply::Marked`](super::Reply::Marked).
    Mark,
    /// Back to the last mark.
    Undo,
    /// Forward again.
    Redo,
    /// The next picture of the sheet, as soon as there is something new in it. Answered by one
    /// [`Reply::Frame`](super::Reply::Frame).
    Frame {
        /// What colours its nodes.
        #[serde(default)]
        map: MapWish,
    },
    /// Folds from the flat sheet on and keeps each state that settles, to go through them by [`Request::Show`]. Pictures tell how
    /// far it has come ([`FrameHead::recorded`](super::FrameHead::recorded)). Whatever else moves the sheet ends it.
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
    /// What was recorded, as one page that can be turned and needs no program. Answered by [`Reply::File`](super::Reply::File).
    Film,
    /// A file of the sheet as it is now, or as the recording shows it. Answered by [`Reply::File`](super::Reply::File).
    Export {
        /// Which.
        format: ExportFormat,
    },
    /// All that it takes to go on some other day. Answered by [`Reply::File`](super::Reply::File).
    Save,
    /// Goes on from such a file, in the body. Answered by [`Reply::Opened`](super::Reply::Opened).
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
