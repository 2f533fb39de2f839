//! Damping along beams (paper 2.5): `F_i = c (v_j - v_i)` with `c = 2 zeta sqrt(k min(m_i, m_j))`, masses 1.
//!
//! It acts on the whole relative velocity, not only on its part along the beam: it keeps linear momentum but not angular
//! momentum, and it hardly touches slow global motion.

use glam::DVec3;

use crate::model::Model;

/// The coefficient c of each beam, a force per velocity.
#[must_use]
pub fn coefficients(model: &Model) -> Vec<f64> {
    model.beams.iter().map(|beam| 2.0 * model.material.zeta * beam.stiffness.sqrt()).collect()
}

/// Adds the damping forces of all beams; fixed nodes feel none.
pub(crate) fn add_forces(model: &Model, coefficients: &[f64], velocities: &[DVec3], forces: &mut [DVec3]) {
    for (beam, c) in model.beams.iter().zip(coefficients) {
        let [i, j] = beam.nodes.map(|n| n.index());
        let force = (velocities[j] - velocities[i]) * *c;
        forces[i] += force;
        forces[j] -= force;
    }
    for node in &model.fixed {
        forces[node.index()] = DVec3::ZERO;
    }
}

/// Adds the damping of nodes that move at `velocities` to `forces`; fixed nodes feel none, nor any other force.
pub fn add(model: &Model, velocities: &[DVec3], forces: &mut [DVec3]) {
    add_forces(model, &coefficients(model), velocities, forces);
}

/// The damping force on each node moving at `velocities`.
#[must_use]
pub fn forces(model: &Model, velocities: &[DVec3]) -> Vec<DVec3> {
    let mut forces = vec![DVec3::ZERO; velocities.len()];
    add_forces(model, &coefficients(model), velocities, &mut forces);
    forces
}
