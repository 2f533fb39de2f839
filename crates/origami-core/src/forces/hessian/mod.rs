//! Second derivatives of the energy: what Newton's method needs beyond the forces. Exact, the change of the springs'
//! directions included, so that a compressed beam pushes sideways and a frustrated crease may have negative curvature.
//!
//! One kind of spring a file, as blocks of 3 by 3: `d2E / dp_i dp_j` for the nodes i and j of each spring.

mod areas;
pub mod beams;
pub mod corner_angles;
pub mod creases;

use glam::{DMat3, DVec3};

use crate::forces::areas::acting;
use crate::model::Model;

/// Hands `add(i, j, block)` the blocks of all springs at `positions`, where the creases have the angles `fold_angles` and
/// are asked for `targets` (radians, by crease). Of the two blocks of a pair of nodes only one is given, the other is its
/// transpose; the blocks of a pair, or of a node with itself, from several springs add up. Fixed nodes have theirs too.
pub fn blocks(
    model: &Model,
    positions: &[DVec3],
    targets: &[f64],
    fold_angles: &[f64],
    add: &mut impl FnMut(usize, usize, DMat3),
) {
    for beam in &model.beams {
        let [i, j] = beam.nodes.map(|n| n.index());
        let block = beams::block(beam, positions[i], positions[j]);
        add(i, i, block);
        add(j, j, block);
        add(i, j, -block);
    }
    for ((crease, target), angle) in model.creases.iter().zip(targets).zip(fold_angles) {
        let nodes = crease.nodes.map(|n| n.index());
        let Some(hinge) = creases::hinge(nodes.map(|n| positions[n])) else { continue };
        let (stiffness, moment) = (crease.stiffness, crease.stiffness * (angle - target));
        add_pairs(&nodes, add, |i, j| {
            outer(hinge.gradient[i], hinge.gradient[j]) * stiffness + hinge.second[i][j] * moment
        });
    }
    for corners in &model.corner_angles {
        let nodes = corners.nodes.map(|n| n.index());
        let Some(second) = corner_angles::blocks(corners, nodes.map(|n| positions[n])) else { continue };
        add_pairs(&nodes, add, |i, j| second[i][j] * model.material.k_face);
    }
    for (_, nodes, triangle, area) in acting(model, positions) {
        let nodes = nodes.map(|n| n.index());
        let second = areas::blocks(&area, &triangle, nodes.map(|n| positions[n]));
        add_pairs(&nodes, add, |i, j| second[i][j]);
    }
}

/// Each pair of a spring's nodes once.
pub(crate) fn add_pairs(
    nodes: &[usize],
    add: &mut impl FnMut(usize, usize, DMat3),
    block: impl Fn(usize, usize) -> DMat3,
) {
    for (i, a) in nodes.iter().enumerate() {
        for (j, b) in nodes.iter().enumerate().take(i + 1) {
            add(*a, *b, block(i, j));
        }
    }
}

/// `a b^T`.
pub(crate) fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

/// `a b^T + b a^T`.
fn both(a: DVec3, b: DVec3) -> DMat3 {
    outer(a, b) + outer(b, a)
}
