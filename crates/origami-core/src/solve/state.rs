//! The state of a sheet in motion.

use glam::DVec3;

use crate::forces::{Energy, creases};
use crate::model::Model;

/// Everything that a solver carries from step to step. Fold angles are a part of it: positions alone do not tell how
/// often a crease has turned.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// By node, in radii of the sheet.
    pub positions: Vec<DVec3>,
    /// By node, in radii per unit of time; zero after a relaxation.
    pub velocities: Vec<DVec3>,
    /// Angles reached, by crease, in radians.
    pub fold_angles: Vec<f64>,
    /// Angles asked for, by crease, in radians.
    pub targets: Vec<f64>,
}

impl State {
    /// The sheet as the file gives it, asked to stay as it is.
    #[must_use]
    pub fn at_rest(model: &Model) -> Self {
        let rest_angles: Vec<f64> = model.creases.iter().map(|c| c.rest_angle).collect();
        Self {
            positions: model.rest.clone(),
            velocities: vec![DVec3::ZERO; model.node_count()],
            fold_angles: rest_angles.clone(),
            targets: rest_angles,
        }
    }

    /// The sheet with its nodes at `positions` (in radii, by node), at rest and asked to stay as it is; fold angles are
    /// taken within half a turn. From here a solver seeks the equilibrium nearby: so one seeds a branch, or a second
    /// stable state.
    ///
    /// # Panics
    /// If there are not as many positions as nodes.
    #[must_use]
    pub fn at(model: &Model, positions: Vec<DVec3>) -> Self {
        assert_eq!(positions.len(), model.node_count(), "one position for each node");
        let fold_angles = creases::fold_angles(model, &positions, &vec![0.0; model.creases.len()]);
        let velocities = vec![DVec3::ZERO; positions.len()];
        Self { positions, velocities, targets: fold_angles.clone(), fold_angles }
    }

    /// Energy by kind of spring.
    #[must_use]
    pub fn energy(&self, model: &Model) -> Energy {
        Energy::of(model, &self.positions, &self.fold_angles, &self.targets)
    }

    /// How many creases are folded past [`super::TANGLED_DEGREES`].
    #[must_use]
    pub fn tangled_creases(&self) -> usize {
        let limit = super::TANGLED_DEGREES.to_radians();
        self.fold_angles.iter().filter(|angle| angle.abs() > limit).count()
    }
}
