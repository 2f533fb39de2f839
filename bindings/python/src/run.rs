//! How a sheet was folded: what its report says besides the state.

use origami::ids::FaceId;
use origami::measure::attitude::Hold;
use origami::{CreasePattern, Scene};
use serde::{Deserialize, Serialize};

use crate::adapter::Adapter;
use crate::backend::Computer;
use crate::model::Sheet;

/// How a sheet was folded.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Run {
    pub(crate) solver: String,
    /// Where it began: `rest`, or another `state`.
    pub(crate) from: String,
    pub(crate) precision: String,
    pub(crate) tolerance: f64,
    pub(crate) adapter: Option<Adapter>,
    hold: Held,
    pub(crate) built: Vec<(String, usize)>,
    pub(crate) left_out: Vec<(String, usize, String)>,
    pub(crate) seconds: f64,
}

/// What keeps its place.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
enum Held {
    Sheet,
    Face(u32),
    Nothing,
}

impl From<Hold> for Held {
    fn from(hold: Hold) -> Self {
        match hold {
            Hold::Sheet => Self::Sheet,
            Hold::Face(face) => Self::Face(face.0),
            Hold::Nothing => Self::Nothing,
        }
    }
}

impl From<Held> for Hold {
    fn from(held: Held) -> Self {
        match held {
            Held::Sheet => Self::Sheet,
            Held::Face(face) => Self::Face(FaceId(face)),
            Held::Nothing => Self::Nothing,
        }
    }
}

impl Run {
    pub(crate) fn new(computer: &Computer<'_>, sheet: &Sheet, scene: &Scene, hold: Hold, seconds: f64) -> Self {
        let inventory = computer.solver().inventory(&sheet.model);
        let mut built: Vec<_> = inventory.built.iter().map(|line| (line.what.to_owned(), line.count)).collect();
        let acting = [("supports", scene.supports.len()), ("loads", scene.loads.len())];
        built.extend(acting.iter().filter(|(_, count)| *count > 0).map(|(what, count)| ((*what).to_owned(), *count)));
        let left_out = inventory.left_out.iter();
        Self {
            from: "rest".to_owned(),
            solver: computer.method.name().to_owned(),
            precision: if computer.adapter.is_some() { "f32" } else { computer.method.precision() }.to_owned(),
            tolerance: computer.method.tolerance(),
            adapter: computer.adapter.clone(),
            hold: hold.into(),
            built,
            left_out: left_out.map(|line| (line.what.to_owned(), line.count, line.why.to_owned())).collect(),
            seconds,
        }
    }

    /// What keeps its place.
    pub(crate) fn hold(&self) -> Hold {
        self.hold.into()
    }

    /// The same in words.
    pub(crate) fn attitude(&self, pattern: &CreasePattern) -> String {
        match self.hold {
            Held::Sheet if !pattern.fixed.is_empty() => "fixed vertices".to_owned(),
            Held::Sheet => "sheet".to_owned(),
            Held::Face(face) => format!("face {face}"),
            Held::Nothing => "none".to_owned(),
        }
    }
}
