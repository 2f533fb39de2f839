//! What a load does to a state to first order.

use glam::DVec3;

use super::eigen::dot;
use super::structure::Structure;
use super::{Configuration, Dof, Refused};

/// The first answer of a structure to its loads, for each unit of the load factor.
#[derive(Clone, Debug, PartialEq)]
pub struct FirstOrder {
    /// Displacements, by node.
    pub displacements: Vec<DVec3>,
    /// Work of the loads on them, twice what is stored: a smaller one is a stiffer structure.
    pub compliance: f64,
    /// What supports do, for each degree of freedom that is held or moved, in order.
    pub reactions: Vec<(Dof, f64)>,
}

impl Structure {
    /// How the structure at `at`, in equilibrium under `load_factor` times its loads, answers to more of them. At the state as
    /// drawn and the load factor 0 this is linear analysis.
    ///
    /// # Errors
    /// [`Refused`] where the structure is wrong, free to move, or singular there.
    pub fn first_order(&self, at: &Configuration, load_factor: f64) -> Result<FirstOrder, Refused> {
        self.check()?;
        match self.free_rigid_motions() {
            0 => {}
            free => return Err(Refused::RigidMotions { free }),
        }
        let mut tangent = self.tangent(at, load_factor)?;
        match tangent.inertia().neutral {
            0 => {}
            count => return Err(Refused::Mechanisms { count }),
        }
        let load = tangent.equations.load(at);
        let moves = tangent.solve_rows(&load);
        let equations = &tangent.equations;
        let mut displacements = equations.way().to_vec();
        equations.rows.add(1.0, &moves, &mut displacements);
        let mut forces = equations.stiffness_times(at, &displacements);
        let mut acting = vec![DVec3::ZERO; self.nodes.len()];
        self.loads.add_forces(&at.positions, &mut acting);
        forces.iter_mut().zip(&acting).for_each(|(f, a)| *f -= *a);
        let reactions = equations.rows.held().map(|dof| (dof, dof.of(&forces))).collect();
        Ok(FirstOrder { compliance: dot(&load, &moves), displacements, reactions })
    }
}
