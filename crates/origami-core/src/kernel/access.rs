//! What a kernel holds, read and written from outside the passes.

use glam::DVec3;

use super::real::{Quad64, Real};
use super::{Compute, Kernel, vector};
use crate::ids::NodeId;
use crate::scene::Axes;

impl<R: Compute> Kernel<R> {
    /// Writes the positions of the nodes, in radii.
    pub(crate) fn read_positions(&self, positions: &mut Vec<DVec3>) {
        positions.clear();
        positions.extend(self.positions[..self.layout.nodes].iter().map(|quad| f64::vector(*quad)));
    }

    /// Writes the velocities of the nodes.
    pub(crate) fn read_velocities(&self, velocities: &mut Vec<DVec3>) {
        velocities.clear();
        velocities.extend(self.velocities[..self.layout.nodes].iter().map(|quad| R::vector(*quad)));
    }

    /// Writes the fold angles, in radians; `angles` has one for each crease.
    pub(crate) fn read_angles(&self, angles: &mut [f64]) {
        for (angle, place) in angles.iter_mut().zip(&self.layout.place_of_crease) {
            *angle = self.angles[*place as usize].to_f64();
        }
    }

    /// Where each node is and the force on it, as the second pass has left it; held nodes feel none along the axes that hold
    /// them.
    pub(crate) fn positions_and_forces(&self) -> impl Iterator<Item = [DVec3; 2]> + '_ {
        let sum = |slots: &[u32]| slots.iter().map(|slot| R::vector(self.slots[*slot as usize])).sum::<DVec3>();
        let mut outside = self.outside.nodes.iter().zip(&self.outside.held).peekable();
        let forces = (0_u32..).zip(self.layout.slots.iter()).map(move |(n, slots)| {
            match outside.next_if(|(node, _)| **node == n) {
                Some((_, axes)) => axes.without(sum(slots)),
                None => sum(slots),
            }
        });
        self.positions().iter().zip(forces).map(|(position, force)| [vector(*position), force])
    }

    /// Where the nodes are, where they lie.
    pub(crate) fn positions(&self) -> &[Quad64] {
        &self.positions[..self.layout.nodes]
    }

    /// Puts all nodes elsewhere.
    pub(crate) fn set_positions(&mut self, positions: &[DVec3]) {
        for (own, position) in self.positions.iter_mut().zip(positions) {
            *own = f64::quad_of(*position);
        }
    }

    /// Puts one node elsewhere along some axes.
    pub(crate) fn set_position(&mut self, node: NodeId, axes: Axes, position: DVec3) {
        let own = &mut self.positions[node.index()];
        *own = f64::quad_of(axes.choose(position, vector(*own)));
    }

    /// Takes other velocities.
    pub(crate) fn set_velocities(&mut self, velocities: &[DVec3]) {
        for (own, velocity) in self.velocities.iter_mut().zip(velocities) {
            *own = R::quad_of(*velocity);
        }
    }

    /// The force on a node of a relaxation, as the last [`Kernel::reduce_forces`] has it, and its velocity.
    pub(crate) fn force_and_velocity(&self, node: NodeId) -> [DVec3; 2] {
        [&self.forces, &self.velocities].map(|list| R::vector(list[node.index()]))
    }

    /// Writes the forces on the nodes of a relaxation, as the last [`Kernel::reduce_forces`] has them.
    pub(crate) fn read_forces(&self, forces: &mut [DVec3]) {
        for (force, quad) in forces.iter_mut().zip(&self.forces) {
            *force = R::vector(*quad);
        }
    }

    /// Moves a node, and makes it faster.
    pub(crate) fn shift(&mut self, node: NodeId, moved: DVec3, faster: DVec3) {
        let (position, velocity) = (&mut self.positions[node.index()], &mut self.velocities[node.index()]);
        *position = f64::quad_of(f64::vector(*position) + moved);
        *velocity = R::quad_of(R::vector(*velocity) + faster);
    }

    /// Takes other fold angles.
    pub(crate) fn set_angles(&mut self, angles: &[f64]) {
        self.layout.by_crease(angles.iter().copied(), &mut self.angles);
    }

    /// Takes other accelerations of the last step of [`Kernel::verlet`].
    pub(crate) fn set_accelerations(&mut self, accelerations: &[DVec3]) {
        self.forces.clear();
        self.forces.extend(accelerations.iter().map(|acceleration| R::quad_of(*acceleration)));
    }

    /// Writes the accelerations of the last step of [`Kernel::verlet`].
    pub(crate) fn read_accelerations(&self, accelerations: &mut Vec<DVec3>) {
        accelerations.clear();
        accelerations.extend(self.forces.iter().map(|quad| R::vector(*quad)));
    }
}
