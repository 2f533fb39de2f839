//! A sheet that is softer on the way to its angles than where it arrives.

use super::{Beam, Model};

/// How soft a sheet is while its target angles rise. Beams that are stiff against the creases decide how a flat sheet buckles
/// while these pull at it weakly, and many a crease then folds to the wrong side; soft ones let the creases decide. Nothing
/// of this is left when the angles are up: the equilibrium is that of the material.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct Softening {
    /// The most axial rigidity that a beam has, over [`Model::stiffest_crease`]. Lower: fewer creases on the wrong side, more
    /// strain on the way and more evaluations after it. Above 0. Default 0.85.
    pub beams: f64,
    /// Stiffness of the corner angles, as a share of the material's. Lower: as for beams. At least 0; 1 changes nothing.
    /// Default 0.3.
    pub corner_angles: f64,
    /// What pulls a crease towards flat that is folded to the other side than its target, beyond its own spring and in units
    /// of its stiffness. Higher: it turns back sooner. At least 0; 0 changes nothing. Default 10.
    pub wrong_side: f64,
}

impl Default for Softening {
    fn default() -> Self {
        Self { beams: 0.85, corner_angles: 0.3, wrong_side: 10.0 }
    }
}

impl Softening {
    /// The stiffness of a beam on the way.
    #[must_use]
    pub fn of_beam(&self, model: &Model, beam: &Beam) -> f64 {
        beam.stiffness.min(self.beams * model.stiffest_crease / beam.rest_length)
    }
}
