//! Forces of the embedder's own.

use std::fmt::Debug;

use glam::{DMat3, DVec3};

use crate::ids::NodeId;
use crate::model::Built;

/// A force that is added to a sheet's own springs: wind, springs to the ground, contact with a tool.
///
/// Lengths are in radii of the sheet, forces in the model's unit ([`Material::ea`](crate::Material::ea) is one), nodes have
/// mass 1. Only [`Force::add_forces`] must be given. What else a solver needs it asks for, and refuses the scene where it is
/// missing ([`Failed::Refused`](crate::solve::Failed::Refused)):
///
/// | solver | needs |
/// |---|---|
/// | `Dynamics` with `TimeStep::Paper` or `Fixed` | nothing more |
/// | `Dynamics` with `TimeStep::Safe`, `Relax` | [`Force::add_row_sums`] |
/// | `Relax` with `retry` | [`Force::energy`] too, once a sheet ends tangled |
/// | `Newton` | [`Force::energy`] and [`Force::add_hessian`] |
pub trait Force: Debug + Send + Sync {
    /// Its line in the inventory: what it is, and how many elements it has.
    fn inventory(&self) -> Built;

    /// Adds its forces to `forces`. All three lists are by node; `velocities` are 0 where a solver seeks the equilibrium.
    fn add_forces(&self, positions: &[DVec3], velocities: &[DVec3], forces: &mut [DVec3]);

    /// Its energy, of which [`Force::add_forces`] adds the negative gradient. `None`: it has none (friction, wind).
    fn energy(&self, positions: &[DVec3]) -> Option<f64> {
        let _ = positions;
        None
    }

    /// Adds to `sums`, by node, a bound on the row sums of its stiffness: of a spring of stiffness k to the ground k, of one
    /// between two nodes 2k at each. False, and nothing added: it has no bound. A force that does not depend on the
    /// positions has 0.
    ///
    /// Too small a bound makes a sheet diverge, too large a one makes it slow.
    fn add_row_sums(&self, positions: &[DVec3], sums: &mut [f64]) -> bool {
        let _ = (positions, sums);
        false
    }

    /// Tells the blocks of its Hessian, the second derivative of its energy, to `add`: of each pair of different nodes that
    /// act on each other one block (rows: first node), and one of each node with itself. False, and nothing told: it has
    /// none.
    fn add_hessian(&self, positions: &[DVec3], add: &mut dyn FnMut(NodeId, NodeId, DMat3)) -> bool {
        let _ = (positions, add);
        false
    }

    /// Pairs of different nodes for which [`Force::add_hessian`] may ever tell a block.
    fn pairs(&self) -> Vec<[NodeId; 2]> {
        Vec::new()
    }
}

/// What a solver needs of a [`Force`] that the force may lack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Needs {
    /// [`Force::energy`].
    Energy,
    /// [`Force::add_row_sums`].
    RowSums,
    /// [`Force::add_hessian`].
    Hessian,
}
