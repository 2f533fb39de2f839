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

/// A sum of no numbers is -0; with this it is 0.
const NOTHING: f64 = 0.0;

impl Energy {
    /// That of `positions`, with the creases at `fold_angles` and asked to be at `targets` (radians, by crease).
    #[must_use]
    pub fn of(model: &Model, positions: &[DVec3], fold_angles: &[f64], targets: &[f64]) -> Self {
        Self {
            beams: beams::energy(model, positions) + NOTHING,
            creases: creases::energy(model, fold_angles, targets) + NOTHING,
            corner_angles: corner_angles::energy(model, positions) + NOTHING,
            areas: areas::energy(model, positions) + NOTHING,
            ..Self::default()
        }
    }

    /// The same with what the scene adds.
    #[must_use]
    pub fn in_scene(model: &Model, scene: &Scene, positions: &[DVec3], fold_angles: &[f64], targets: &[f64]) -> Self {
        let work = |load: &Load| load.force.dot(positions[load.node.index()] - model.rest[load.node.index()]);
        Self {
            loads: NOTHING - scene.loads.iter().map(work).sum::<f64>(),
            own_forces: scene.forces.iter().filter_map(|own| own.energy(positions)).sum::<f64>() + NOTHING,
            ..Self::of(model, positions, fold_angles, targets)
        }
    }

    /// The sum.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.beams + self.creases + self.corner_angles + self.areas + self.loads + self.own_forces
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate;
    use crate::model::Material;
    use crate::solve::State;

    #[test]
    fn nothing_is_0_and_not_minus_0() {
        let model = Model::new(&generate::miura(2, 2).expect("valid"), &Material::default()).expect("a model");
        let State { positions, fold_angles, targets, .. } = State::at_rest(&model);
        let Energy { beams, creases, corner_angles, areas, loads, own_forces } =
            Energy::in_scene(&model, &Scene::percent(0.0), &positions, &fold_angles, &targets);
        for energy in [beams, creases, corner_angles, areas, loads, own_forces] {
            assert!(energy.is_sign_positive(), "{energy}");
        }
        // Of these there are none.
        assert_eq!([areas, loads, own_forces].map(f64::to_bits), [0; 3]);
    }
}
