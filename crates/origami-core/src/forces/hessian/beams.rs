//! Beams: `k (l - l0)^2 / 2` has the curvature `k` along the beam and `k (l - l0) / l`, its tension over its length,
//! across it.

use glam::{DMat3, DVec3};

use super::outer;
use crate::model::Beam;

/// `d2E / dp_i^2`, which is `d2E / dp_j^2` and minus `d2E / dp_i dp_j`: `k e e^T + k (l - l0)/l (I - e e^T)`.
#[must_use]
pub fn block(beam: &Beam, from: DVec3, to: DVec3) -> DMat3 {
    let along = to - from;
    let length = along.length();
    // A beam of no length has no direction, and so no force.
    if length <= 0.0 {
        return DMat3::ZERO;
    }
    let e = along / length;
    let across = beam.stiffness * (length - beam.rest_length) / length;
    DMat3::from_diagonal(DVec3::splat(across)) + outer(e, e) * (beam.stiffness - across)
}
