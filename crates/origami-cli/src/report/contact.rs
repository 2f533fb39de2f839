//! What contact did on the way to a state.

use std::fmt;

use origami::model::Model;
use origami::solve::Touch;
use serde::{Deserialize, Serialize};

use crate::numbers::{plain, short};

/// How many pairs of faces are listed.
const LISTED: usize = 1000;

/// What contact did.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct ContactFacts {
    /// Whether it keeps the sheet from its angles.
    pub(crate) blocked: bool,
    /// The percentage at which something was first in the way of a move.
    pub(crate) first_percent: Option<f64>,
    /// Evaluations in which something was.
    pub(crate) limited: u64,
    /// The least gap of layers that push, in radii.
    pub(crate) least_gap: Option<f64>,
    /// The faces that press on each other, the hardest first.
    pub(crate) pressing: Vec<PressingFacts>,
    /// The crease that is farthest from its angle.
    pub(crate) farthest: Option<FarthestFacts>,
}

/// Two faces that press on each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct PressingFacts {
    faces: [u32; 2],
    force: f64,
    gap: f64,
}

/// A crease and how far it is from its angle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct FarthestFacts {
    vertices: [u32; 2],
    edge: Option<u32>,
    off_deg: f64,
}

impl ContactFacts {
    /// Those of a way between two percentages, or of none.
    pub(crate) fn new(model: &Model, touch: &Touch, blocked: bool, percents: Option<[f64; 2]>) -> Self {
        let pressing = touch.pressing.iter().take(LISTED).map(|pressing| PressingFacts {
            faces: pressing.faces.map(|face| face.0),
            force: pressing.force,
            gap: pressing.gap,
        });
        let first = touch.first_limited.zip(percents);
        let farthest = touch.farthest.map(|(crease, off)| {
            let side = &model.mesh.sides[model.creases[crease.index()].side.index()];
            FarthestFacts {
                vertices: side.nodes.map(|node| model.mesh.vertex_of_node[node.index()].0),
                edge: side.edge.map(|edge| edge.0),
                off_deg: off.to_degrees(),
            }
        });
        Self {
            blocked,
            first_percent: first.map(|(share, [from, to])| from + share * (to - from)),
            limited: touch.limited,
            least_gap: Some(touch.least_gap).filter(|gap| gap.is_finite()),
            pressing: pressing.collect(),
            farthest,
        }
    }
}

/// Such as `faces 0 and 2 press hardest (force 1.2), the crease between vertices 1 and 6 is 32 degrees from its angle, and
/// something was first in the way at 83 %`.
impl fmt::Display for ContactFacts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut told = Vec::new();
        if let Some(PressingFacts { faces: [a, b], force, .. }) = self.pressing.first() {
            told.push(format!("faces {a} and {b} press hardest (force {})", short(*force)));
        }
        if let Some(FarthestFacts { vertices: [a, b], off_deg, .. }) = self.farthest {
            told.push(format!("the crease between vertices {a} and {b} is {} degrees from its angle", short(off_deg)));
        }
        if let Some(percent) = self.first_percent {
            told.push(format!("something was first in the way at {} %", plain(percent.round())));
        }
        f.write_str(&told.join(", "))
    }
}
