//! Beams (paper 2.2): `F_i = k (l - l0) e_ij`, `F_j = -F_i`, with `k = EA / l0` and `e_ij` the unit vector from i to j.

use glam::DVec3;

use crate::model::{Beam, Model};

/// Force on the first end; the second feels the opposite.
#[inline]
pub(crate) fn force(beam: &Beam, from: DVec3, to: DVec3) -> DVec3 {
    let along = to - from;
    let length = along.length();
    // A beam of no length has no direction, and so no force.
    if length > 0.0 { along * (beam.stiffness * (length - beam.rest_length) / length) } else { DVec3::ZERO }
}

/// Adds the forces of all beams.
pub(crate) fn add_forces(model: &Model, positions: &[DVec3], forces: &mut [DVec3]) {
    for beam in &model.beams {
        let [i, j] = beam.nodes.map(|n| n.index());
        let force = force(beam, positions[i], positions[j]);
        forces[i] += force;
        forces[j] -= force;
    }
}

/// Elongation over rest length, by beam (dimensionless).
pub fn strains<'a>(model: &'a Model, positions: &'a [DVec3]) -> impl Iterator<Item = f64> + 'a {
    model.beams.iter().map(|beam| {
        let [i, j] = beam.nodes.map(|n| n.index());
        (positions[i].distance(positions[j]) - beam.rest_length) / beam.rest_length
    })
}

/// Energy of all beams: `k (l - l0)^2 / 2` each, a force times a length.
#[must_use]
pub fn energy(model: &Model, positions: &[DVec3]) -> f64 {
    let beams = model.beams.iter().zip(strains(model, positions));
    beams.map(|(beam, strain)| 0.5 * beam.stiffness * (strain * beam.rest_length).powi(2)).sum()
}
