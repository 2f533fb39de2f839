//! Fold angles reached, and how far they are from their targets.

use glam::DVec3;

use crate::forces::creases::hinge;
use crate::model::Model;
use crate::pattern::CreasePattern;
use crate::solve::State;

/// Difference between fold angles and their targets, over all creases with a spring, in degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct AngleError {
    /// Mean of the absolute differences.
    pub mean: f64,
    /// The largest.
    pub max: f64,
}

/// The difference between the angles of `state` and its targets.
#[must_use]
pub fn angle_error(state: &State) -> AngleError {
    let differences = state.fold_angles.iter().zip(&state.targets).map(|(reached, asked)| reached - asked);
    let summary = super::Summary::of(differences.map(f64::to_degrees));
    AngleError { mean: summary.mean, max: summary.max }
}

/// The fold angle of each of the pattern's edges, in radians: with all its turns where a spring keeps count, within half a
/// turn elsewhere; `None` where fewer than two faces meet or one of them is too thin to tell.
#[must_use]
pub fn edge_fold_angles(model: &Model, pattern: &CreasePattern, state: &State) -> Vec<Option<f64>> {
    let mut of_side: Vec<Option<f64>> = model.mesh.sides.iter().map(|side| measured(side, state)).collect();
    for (crease, angle) in model.creases.iter().zip(&state.fold_angles) {
        of_side[crease.side.index()] = Some(*angle);
    }
    (0..pattern.edges.len()).map(|e| model.mesh.side_of_edge[e].and_then(|s| of_side[s.index()])).collect()
}

fn measured(side: &crate::mesh::Side, state: &State) -> Option<f64> {
    let [one, two] = [side.apexes[0]?, side.apexes[1]?];
    let points: [DVec3; 4] = [one, two, side.nodes[0], side.nodes[1]].map(|n| state.positions[n.index()]);
    hinge(points).map(|hinge| hinge.angle())
}
