//! Energy of a state, by what it is stored in.

use glam::DVec3;

use super::{areas, beams, corner_angles, creases};
use crate::model::Model;
use crate::scene::{Load, Scene};

/// Energies in units of force times radius of the sheet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Stretched and compressed beams.
    pub beams: f64,
    /// Creases away from their target angles.
    pub creases: f64,
    /// Sheared triangles.
    pub corner_angles: f64,
    /// Triangles kept from collapse; 0 unless one has lost four fifths of its area.
    pub areas: f64,
    /// Dead loads: the negative of their work from the sheet at rest.
    pub loads: f64,
    /// Forces of the embedder's own, of those that have an energy.
    pub own_forces: f64,
}

impl Energy {
    /// That of `positions`, with the creases at `fold_angles` and asked to be at `targets` (radians, by crease).
    #[must_use]
    pub fn of(model: &Model, positions: &[DVec3], fold_angles: &[f64], targets: &[f64]) -> Self {
        Self {
            beams: beams::energy(model, positions),
            creases: creases::energy(model, fold_angles, targets),
            corner_angles: corner_angles::energy(model, positions),
            areas: areas::energy(model, positions),
            ..Self::default()
        }
    }

    /// The same with what the scene adds.
    #[must_use]
    pub fn in_scene(model: &Model, scene: &Scene, positions: &[DVec3], fold_angles: &[f64], targets: &[f64]) -> Self {
        let work = |load: &Load| load.force.dot(positions[load.node.index()] - model.rest[load.node.index()]);
        Self {
            loads: -scene.loads.iter().map(work).sum::<f64>(),
            own_forces: scene.forces.iter().filter_map(|own| own.energy(positions)).sum(),
            ..Self::of(model, positions, fold_angles, targets)
        }
    }

    /// The sum.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.beams + self.creases + self.corner_angles + self.areas + self.loads + self.own_forces
    }
}
