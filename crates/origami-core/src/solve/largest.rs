//! The largest force on a node.

use glam::DVec3;

/// The largest force, in the model's unit of force.
pub(super) fn largest(forces: &[DVec3]) -> f64 {
    forces.iter().map(|f| f.length()).fold(0.0, f64::max)
}
