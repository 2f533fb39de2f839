//! Forces and energies of the springs (paper sections 2.2 to 2.5), one kind a file: the plain forms, which every faster
//! kernel is compared with. Units: lengths in radii of the sheet, masses 1, so a force is a stiffness times a length.
//!
//! Each kind adds its forces to the nodes in a fixed order: the same input gives the same bits.

mod angle;
pub mod areas;
pub mod beams;
pub mod corner_angles;
pub mod creases;
pub mod damping;
mod energy;
pub mod hessian;

pub use angle::unwrapped;
pub use energy::Energy;

use std::sync::Arc;

use glam::DVec3;

use crate::ids::NodeId;
use crate::model::Model;
use crate::scene::{Axes, Force, Held, Load, Reaction, Scene};

/// Computes the forces on a sheet: those of its springs, and those of its scene. Keeps the memory that this needs from one
/// evaluation to the next.
#[derive(Clone, Debug)]
pub struct Forces<'m> {
    model: &'m Model,
    loads: Vec<Load>,
    own: Vec<Arc<dyn Force>>,
    held: Held,
    anchors: Vec<angle::Anchor>,
    values: Vec<DVec3>,
    /// 0: what forces of one's own are told where the equilibrium is sought.
    no_velocities: Vec<DVec3>,
    reactions: Vec<Reaction>,
}

impl<'m> Forces<'m> {
    /// The springs of `model`; the vertices that its pattern fixes are held.
    #[must_use]
    pub fn new(model: &'m Model) -> Self {
        Self::in_scene(model, &Scene::default())
    }

    /// The springs of `model`, loads, forces of one's own and supports of `scene`.
    #[must_use]
    pub fn in_scene(model: &'m Model, scene: &Scene) -> Self {
        Self::holding(model, scene, Held::new(model, scene))
    }

    /// The same with other nodes held than those that the scene supports.
    #[must_use]
    pub fn holding(model: &'m Model, scene: &Scene, held: Held) -> Self {
        let own = !scene.forces.is_empty();
        Self {
            model,
            loads: scene.loads.clone(),
            own: scene.forces.clone(),
            held,
            anchors: vec![angle::Anchor::default(); model.creases.len()],
            values: vec![DVec3::ZERO; model.node_count()],
            no_velocities: if own { vec![DVec3::ZERO; model.node_count()] } else { Vec::new() },
            reactions: Vec::new(),
        }
    }

    /// Forces of beams, creases, corner angles and areas, loads and forces of one's own at `positions`, by node; held nodes feel
    /// none along the axes that hold them.
    ///
    /// `targets` are the angles asked of the creases; `fold_angles` holds the angles of the evaluation before, from
    /// which the new ones are told apart by whole turns, and receives the new ones. Both in radians, by crease.
    pub fn evaluate(&mut self, positions: &[DVec3], targets: &[f64], fold_angles: &mut [f64]) -> &mut [DVec3] {
        self.values.fill(DVec3::ZERO);
        beams::add_forces(self.model, positions, &mut self.values);
        creases::add_forces(self.model, positions, targets, fold_angles, &mut self.anchors, &mut self.values);
        corner_angles::add_forces(self.model, positions, &mut self.values);
        areas::add_forces(self.model, positions, &mut self.values);
        self.loads.iter().for_each(|load| self.values[load.node.index()] += load.force);
        self.own.iter().for_each(|own| own.add_forces(positions, &self.no_velocities, &mut self.values));
        let reaction = |(node, axes): (NodeId, Axes)| Reaction { node, force: -axes.of(self.values[node.index()]) };
        self.reactions.clear();
        self.reactions.extend(self.held.iter().map(reaction));
        self.held.clear(&mut self.values);
        &mut self.values
    }

    /// What the supports did to the held nodes in the last evaluation, in the order of the nodes.
    #[must_use]
    pub fn reactions(&self) -> &[Reaction] {
        &self.reactions
    }

    /// The held nodes.
    #[must_use]
    pub fn held(&self) -> &Held {
        &self.held
    }
}
