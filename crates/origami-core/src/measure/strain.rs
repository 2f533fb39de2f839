//! Strain (paper 3.1): how much beams are longer or shorter than at rest. A rigidly folded sheet has none.

use glam::DVec3;

use super::Summary;
use crate::forces::beams;
use crate::model::Model;

/// Engineering strain `|l / l0 - 1|`, dimensionless (0.01 is 1 %).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Strain {
    /// Over all beams.
    pub beams: Summary,
    /// Over all nodes, each with the mean of its beams: the mean of these is the reference program's "average vertex error".
    pub nodes: Summary,
}

impl Strain {
    /// The strain of a sheet whose nodes are at `positions`.
    #[must_use]
    pub fn of(model: &Model, positions: &[DVec3]) -> Self {
        Self {
            beams: Summary::of(beams::strains(model, positions)),
            nodes: Summary::of(node_strains(model, positions)),
        }
    }
}

/// The mean of `|l / l0 - 1|` over the beams at each node.
#[must_use]
pub fn node_strains(model: &Model, positions: &[DVec3]) -> Vec<f64> {
    let strains: Vec<f64> = beams::strains(model, positions).map(f64::abs).collect();
    let of_node = |n: usize| {
        let sides = model.mesh.sides_of_node.row(n);
        sides.iter().map(|s| strains[s.index()]).sum::<f64>() / sides.len().max(1) as f64
    };
    (0..model.node_count()).map(of_node).collect()
}
