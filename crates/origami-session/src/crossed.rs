//! Where paper goes through paper, for a page to show.

use origami_core::Model;
use origami_core::contact::Crossings;
use origami_core::glam::DVec3;

use crate::message::Crossed;

/// Pairs of faces that are told.
const MOST_PAIRS: usize = 200;

impl Crossed {
    /// That of a sheet with its nodes at `positions`, in radii.
    pub(crate) fn of(model: &Model, positions: &[DVec3]) -> Self {
        let crossings = Crossings::of(&model.mesh, positions);
        Self {
            count: crossings.all.len(),
            deepest: crossings.deepest(),
            faces: crossings.faces.iter().take(MOST_PAIRS).map(|pair| pair.map(|face| face.0)).collect(),
        }
    }
}
