//! The state of a sheet in motion.

use std::f64::consts::PI;

use glam::DVec3;

use super::TANGLED_DEGREES;
use super::perturb::perturb;
use crate::forces::{Energy, Forces, creases};
use crate::model::Model;
use crate::scene::{Held, Scene};

/// Targets from here on ask a crease to lie flat, in degrees.
const FLAT_DEGREES: f64 = 170.0;

/// Whether a crease is asked to lie flat.
pub(super) fn is_flat(target: f64) -> bool {
    target.abs() >= FLAT_DEGREES.to_radians()
}

/// [`State::lost_creases`] of angles and targets by crease.
pub(super) fn lost_creases(angles: &[f64], targets: &[f64]) -> usize {
    let past = (TANGLED_DEGREES - 180.0).to_radians();
    let lost = |(angle, target): &(&f64, &f64)| {
        let flat = is_flat(**target) && angle.abs() > target.abs().max(PI) + past;
        flat || (*angle - *target).abs() > PI
    };
    angles.iter().zip(targets).filter(lost).count()
}

/// Everything that a solver carries from step to step. Fold angles are a part of it: positions alone do not tell how
/// often a crease has turned.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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

    /// The sheet at rest, each free node moved by up to `share` of its shortest beam in each direction; every `seed` has
    /// directions of its own. The fold angles stay those of the sheet at rest, until a solver takes them.
    ///
    /// [`super::Relax`] begins in the same way with its own `perturbation` and seed 0; with a perturbation of 0 it takes
    /// what it is given. Unlike that, this moves the nodes whether or not there is something to be folded.
    #[must_use]
    pub fn perturbed(model: &Model, share: f64, seed: u64) -> Self {
        let mut state = Self::at_rest(model);
        if share != 0.0 {
            perturb(model, &Held::new(model, &Scene::default()), &mut state.positions, share, seed);
        }
        state
    }

    /// The same with its nodes at other `positions` (in radii, by node); fold angles follow without a jump of whole turns.
    ///
    /// # Panics
    /// If there are not as many positions as nodes.
    #[must_use]
    pub fn moved_to(&self, model: &Model, positions: Vec<DVec3>) -> Self {
        assert_eq!(positions.len(), model.node_count(), "one position for each node");
        Self { fold_angles: creases::fold_angles(model, &positions, &self.fold_angles), positions, ..self.clone() }
    }

    /// Energy by kind of spring.
    #[must_use]
    pub fn energy(&self, model: &Model) -> Energy {
        Energy::of(model, &self.positions, &self.fold_angles, &self.targets)
    }

    /// The same with that of the scene's loads and forces.
    #[must_use]
    pub fn energy_in(&self, model: &Model, scene: &Scene) -> Energy {
        Energy::in_scene(model, scene, &self.positions, &self.fold_angles, &self.targets)
    }

    /// Every first derivative of the energy by a position, dE/dx by node: what pulls at each node, with the other sign.
    /// Held nodes have theirs along the axes that are free.
    #[must_use]
    pub fn gradient(&self, model: &Model, scene: &Scene) -> Vec<DVec3> {
        let mut forces = Forces::in_scene(model, scene);
        let forces = forces.evaluate(&self.positions, &self.targets, &mut self.fold_angles.clone());
        forces.iter().map(|force| -*force).collect()
    }

    /// How many creases went astray: more than half a turn from their targets, or 20 degrees past theirs where they are
    /// asked to lie flat. Below that a crease past [`super::TANGLED_DEGREES`] is no sign of a better state elsewhere.
    #[must_use]
    pub fn lost_creases(&self) -> usize {
        lost_creases(&self.fold_angles, &self.targets)
    }

    /// How many creases are folded past [`super::TANGLED_DEGREES`].
    #[must_use]
    pub fn tangled_creases(&self) -> usize {
        let limit = TANGLED_DEGREES.to_radians();
        self.fold_angles.iter().filter(|angle| angle.abs() > limit).count()
    }
}
