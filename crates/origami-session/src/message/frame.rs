//! What a page is told beside each picture of the sheet.

use serde::{Deserialize, Serialize};

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
    /// The number of the state that is shown, as in [`Request::Show`](super::Request::Show).
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
