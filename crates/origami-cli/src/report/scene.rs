//! What a model holds.

use origami::Warning;
use origami::model::{Inventory, Model};
use origami::pattern::CreasePattern;
use serde::Serialize;

use super::Note;

/// The sheet and its springs.
#[derive(Debug, Serialize)]
pub(crate) struct SceneFacts {
    /// Vertices that are part of the sheet.
    pub(crate) vertices: usize,
    /// Bars.
    pub(crate) beams: usize,
    /// Hinges with a spring.
    pub(crate) creases: usize,
    /// Faces of the pattern.
    pub(crate) faces: usize,
    /// Its pieces and its area.
    pub(crate) paper: PaperFacts,
    /// Triangles that the faces were cut into.
    pub(crate) triangles: usize,
    /// What is simulated.
    pub(crate) built: Vec<Built>,
    /// What is not, and why.
    pub(crate) left_out: Vec<LeftOut>,
    /// What was odd in the file.
    pub(crate) warnings: Vec<Note>,
}

/// How much paper there is.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct PaperFacts {
    /// In how many pieces.
    pub(crate) pieces: usize,
    /// In the square of the file's unit.
    pub(crate) area: f64,
    /// Spanned by lines and not by faces.
    pub(crate) lost: f64,
}

impl PaperFacts {
    /// That of a pattern.
    pub(crate) fn of(pattern: &CreasePattern) -> Self {
        let paper = pattern.paper();
        Self { pieces: paper.pieces, area: paper.area, lost: paper.lost }
    }
}

/// A group of elements.
#[derive(Debug, Serialize)]
pub(crate) struct Built {
    pub(crate) what: &'static str,
    pub(crate) count: usize,
}

/// A group that is not there.
#[derive(Debug, Serialize)]
pub(crate) struct LeftOut {
    pub(crate) what: &'static str,
    pub(crate) count: usize,
    pub(crate) why: &'static str,
}

impl From<&origami::model::LeftOut> for LeftOut {
    fn from(left_out: &origami::model::LeftOut) -> Self {
        Self { what: left_out.what, count: left_out.count, why: left_out.why }
    }
}

impl SceneFacts {
    /// That of a model, whose `inventory` may have what a solver adds.
    pub(crate) fn new(pattern: &CreasePattern, model: &Model, inventory: &Inventory, warnings: &[Warning]) -> Self {
        let built = inventory.built.iter().map(|b| Built { what: b.what, count: b.count });
        Self {
            vertices: model.node_count(),
            beams: model.beams.len(),
            creases: model.creases.len(),
            faces: pattern.faces.len(),
            paper: PaperFacts::of(pattern),
            triangles: model.mesh.triangles.len(),
            built: built.collect(),
            left_out: inventory.left_out.iter().map(LeftOut::from).collect(),
            warnings: warnings.iter().map(Note::from).collect(),
        }
    }
}
