//! What acts on a sheet besides its springs, as a run holds it: supports, loads, forces of one's own.

use std::sync::Arc;

use glam::DVec3;

use crate::kernel::{Compute, Kernel};
use crate::model::Model;
use crate::scene::{Force, Held, Load, Reaction, Scene};

/// Supports, loads and forces of one's own. Of what a scene does not have nothing is kept.
#[derive(Clone, Debug, Default)]
pub(super) struct Surroundings {
    held: Held,
    loads: Vec<Load>,
    forces: Vec<Arc<dyn Force>>,
    /// By node, for forces of one's own; empty without them.
    positions: Vec<DVec3>,
    velocities: Vec<DVec3>,
    /// By node: the forces from outside; empty where there are none.
    sums: Vec<DVec3>,
}

impl Surroundings {
    pub(super) fn new(model: &Model, scene: &Scene) -> Self {
        Self {
            held: Held::new(model, scene),
            loads: scene.loads.clone(),
            forces: scene.forces.clone(),
            ..Self::default()
        }
    }

    pub(super) fn forces(&self) -> &[Arc<dyn Force>] {
        &self.forces
    }

    pub(super) fn held(&self) -> &Held {
        &self.held
    }

    pub(super) fn loads(&self) -> &[Load] {
        &self.loads
    }

    /// Takes other supports and loads, and makes room for them in the kernel.
    pub(super) fn change<R: Compute>(&mut self, model: &Model, kernel: &mut Kernel<R>, held: Held, loads: Vec<Load>) {
        (self.held, self.loads) = (held, loads);
        self.install(model, kernel);
    }

    /// Makes room in the kernel for what acts from outside. Nodes are halted along the axes that hold them.
    pub(super) fn install<R: Compute>(&mut self, model: &Model, kernel: &mut Kernel<R>) {
        let everywhere = !self.forces.is_empty();
        let loaded = self.loads.iter().map(|load| load.node);
        kernel.set_outside(model, &self.held, everywhere, loaded);
        let none_before = self.sums.is_empty();
        if !self.loads.is_empty() || everywhere || !none_before {
            self.sums.resize(model.node_count(), DVec3::ZERO);
            self.sum_loads();
            kernel.set_loads(&self.sums);
        }
    }

    /// The loads, by node.
    fn sum_loads(&mut self) {
        self.sums.fill(DVec3::ZERO);
        self.loads.iter().for_each(|load| self.sums[load.node.index()] += load.force);
    }

    /// Evaluates forces of one's own at the kernel's positions; `moving`: at its velocities too.
    pub(super) fn evaluate<R: Compute>(&mut self, kernel: &mut Kernel<R>, moving: bool) {
        if self.forces.is_empty() {
            return;
        }
        kernel.read_positions(&mut self.positions);
        if moving {
            kernel.read_velocities(&mut self.velocities);
        } else {
            self.velocities.clear();
            self.velocities.resize(self.positions.len(), DVec3::ZERO);
        }
        self.sum_loads();
        for own in &self.forces {
            own.add_forces(&self.positions, &self.velocities, &mut self.sums);
        }
        kernel.set_loads(&self.sums);
    }

    /// What the supports do to the held nodes, as of the last evaluation, in the order of the nodes.
    pub(super) fn reactions<R: Compute>(&self, kernel: &Kernel<R>) -> Vec<Reaction> {
        let reaction = |(node, axes)| Reaction { node, force: kernel.reaction(node, axes) };
        self.held.iter().map(reaction).collect()
    }
}
