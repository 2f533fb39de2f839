//! Energy of a state, by kind of spring.

use glam::DVec3;

use super::{beams, corner_angles, creases};
use crate::model::Model;

/// Energies in units of force times radius of the sheet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Stretched and compressed beams.
    pub beams: f64,
    /// Creases away from their target angles.
    pub creases: f64,
    /// Sheared triangles.
    pub corner_angles: f64,
}

impl Energy {
    /// That of `positions`, with the creases at `fold_angles` and asked to be at `targets` (radians, by crease).
    #[must_use]
    pub fn of(model: &Model, positions: &[DVec3], fold_angles: &[f64], targets: &[f64]) -> Self {
        Self {
            beams: beams::energy(model, positions),
            creases: creases::energy(model, fold_angles, targets),
            corner_angles: corner_angles::energy(model, positions),
        }
    }

    /// The sum.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.beams + self.creases + self.corner_angles
    }
}
