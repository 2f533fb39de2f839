//! Where a state goes through itself.

use origami::contact::Crossings;
use serde::{Deserialize, Serialize};

use crate::numbers::{count, short};

/// How many pairs of faces are listed.
const LISTED: usize = 1000;

/// What the exact test found.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct CrossingFacts {
    /// Sides that go through a triangle.
    pub(crate) count: usize,
    /// The depth of the deepest, in radii of the sheet.
    pub(crate) deepest: f64,
    /// Pairs of faces that cross.
    pub(crate) pairs: usize,
    /// The first of these.
    pub(crate) faces: Vec<[u32; 2]>,
}

impl CrossingFacts {
    /// Those of crossings in a unit of length of which the sheet's radius has so many.
    pub(crate) fn new(crossings: &Crossings, radius: f64) -> Self {
        Self {
            count: crossings.all.len(),
            deepest: crossings.deepest() / radius,
            pairs: crossings.faces.len(),
            faces: crossings.faces.iter().take(LISTED).map(|pair| pair.map(|face| face.0)).collect(),
        }
    }
}

/// Such as `257 crossings of 34 pairs of faces (0 with 7, 0 with 9 and others), the deepest 0.021 of the radius`.
impl std::fmt::Display for CrossingFacts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        const NAMED: usize = 3;
        if self.count == 0 {
            return f.write_str("no crossing");
        }
        let named: Vec<String> = self.faces.iter().take(NAMED).map(|[a, b]| format!("{a} with {b}")).collect();
        write!(
            f,
            "{} of {} ({}{}), the deepest {} of the radius",
            count(self.count, "crossing", "crossings"),
            count(self.pairs, "pair of faces", "pairs of faces"),
            named.join(", "),
            if self.pairs > NAMED { " and others" } else { "" },
            short(self.deepest)
        )
    }
}
