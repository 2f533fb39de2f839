//! The equations of equilibrium: the energy's gradient equals the load factor times the loads, row by row.

use glam::DVec3;

use super::rows::Rows;
use super::structure::Structure;
use super::{Configuration, Refused};

/// A structure with what its equations need besides.
#[derive(Clone, Debug)]
pub(super) struct Equations<'s> {
    pub(super) structure: &'s Structure,
    pub(super) rows: Rows,
    /// [`Structure::size`].
    pub(super) size: f64,
    /// What rounding leaves of a residual.
    pub(super) rounding: f64,
    /// By node: how far supports move it per load factor.
    way: Vec<DVec3>,
}

impl Structure {
    /// Forces out of balance at `at` under `load_factor` times the loads, by node: what the members pull less what acts. Along
    /// axes that are held these are the supports' reactions; along others 0 in equilibrium.
    ///
    /// # Errors
    /// [`Refused`] where the structure is wrong, or `at` is of another one.
    pub fn unbalanced(&self, at: &Configuration, load_factor: f64) -> Result<Vec<DVec3>, Refused> {
        self.check_configuration(at)?;
        Ok(Equations::new(self)?.unbalanced(&mut at.clone(), load_factor))
    }
}

impl<'s> Equations<'s> {
    pub(super) fn new(structure: &'s Structure) -> Result<Self, Refused> {
        structure.check()?;
        let mut way = vec![DVec3::ZERO; structure.nodes.len()];
        for (dof, length) in &structure.supports.moved {
            way[dof.node.index()][dof.axis.index()] = *length;
        }
        let mut at_node = vec![0.0_f64; structure.nodes.len()];
        for bar in &structure.bars {
            bar.nodes.iter().for_each(|n| at_node[n.index()] += bar.rigidity);
        }
        let rounding = 4.0 * f64::EPSILON * at_node.into_iter().fold(0.0, f64::max);
        Ok(Self { structure, rows: Rows::new(structure), size: structure.size(), rounding, way })
    }

    /// By node: how far supports move it per load factor.
    pub(super) fn way(&self) -> &[DVec3] {
        &self.way
    }

    /// Puts what is held where it is drawn, and what is moved where it is at a load factor.
    pub(super) fn place(&self, at: &mut Configuration, load_factor: f64) {
        for dof in &self.structure.supports.fixed {
            at.positions[dof.node.index()][dof.axis.index()] = dof.of(&self.structure.nodes);
        }
        for (dof, length) in &self.structure.supports.moved {
            let drawn = dof.of(&self.structure.nodes);
            at.positions[dof.node.index()][dof.axis.index()] = drawn + load_factor * length;
        }
    }

    /// Forces that are out of balance, by node: gradient of the energy minus loads. On held nodes those of the supports.
    pub(super) fn unbalanced(&self, at: &mut Configuration, load_factor: f64) -> Vec<DVec3> {
        let mut forces = vec![DVec3::ZERO; self.structure.nodes.len()];
        self.structure.loads.add_forces(&at.positions, &mut forces);
        forces.iter_mut().for_each(|f| *f *= -load_factor);
        self.structure.add_gradient(self.size, at, &mut forces);
        forces
    }

    /// How fast the residual falls with the load factor, by row: loads, and what moved supports do.
    pub(super) fn load(&self, at: &Configuration) -> Vec<f64> {
        let mut forces = vec![DVec3::ZERO; self.structure.nodes.len()];
        self.structure.loads.add_forces(&at.positions, &mut forces);
        if !self.structure.supports.moved.is_empty() {
            let pulled = self.stiffness_times(at, &self.way);
            forces.iter_mut().zip(pulled).for_each(|(f, p)| *f -= p);
        }
        self.rows.gather(&forces)
    }

    /// Second derivatives of the energy times a list by node, held nodes included.
    pub(super) fn stiffness_times(&self, at: &Configuration, of_nodes: &[DVec3]) -> Vec<DVec3> {
        let mut product = vec![DVec3::ZERO; of_nodes.len()];
        self.structure.blocks(self.size, at, &mut |i, j, block| {
            product[i] += block * of_nodes[j];
            if i != j {
                product[j] += block.transpose() * of_nodes[i];
            }
        });
        product
    }
}
