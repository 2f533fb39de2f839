//! Forces and energies of the springs (paper sections 2.2 to 2.5), one kind a file: the plain forms, which every faster
//! kernel is compared with. Units: lengths in radii of the sheet, masses 1, so a force is a stiffness times a length.
//!
//! Each kind adds its forces to the nodes in a fixed order: the same input gives the same bits.

mod angle;
pub mod beams;
pub mod corner_angles;
pub mod creases;
pub mod damping;
mod energy;
pub mod hessian;

pub use angle::unwrapped;
pub use energy::Energy;

use glam::DVec3;

use crate::model::Model;

/// Computes the forces of a model's springs; keeps the memory that this needs from one evaluation to the next.
#[derive(Clone, Debug)]
pub struct Forces<'m> {
    model: &'m Model,
    anchors: Vec<angle::Anchor>,
    values: Vec<DVec3>,
}

impl<'m> Forces<'m> {
    /// For `model`.
    #[must_use]
    pub fn new(model: &'m Model) -> Self {
        Self {
            model,
            anchors: vec![angle::Anchor::default(); model.creases.len()],
            values: vec![DVec3::ZERO; model.node_count()],
        }
    }

    /// Forces of beams, creases and corner angles at `positions`, by node; fixed nodes feel none.
    ///
    /// `targets` are the angles asked of the creases; `fold_angles` holds the angles of the evaluation before, from
    /// which the new ones are told apart by whole turns, and receives the new ones. Both in radians, by crease.
    pub fn evaluate(&mut self, positions: &[DVec3], targets: &[f64], fold_angles: &mut [f64]) -> &mut [DVec3] {
        self.values.fill(DVec3::ZERO);
        beams::add_forces(self.model, positions, &mut self.values);
        creases::add_forces(self.model, positions, targets, fold_angles, &mut self.anchors, &mut self.values);
        corner_angles::add_forces(self.model, positions, &mut self.values);
        for node in &self.model.fixed {
            self.values[node.index()] = DVec3::ZERO;
        }
        &mut self.values
    }
}
