//! The step on the processor as it is run: the springs of [`crate::forces`], several elements side by side.
//!
//! [`fold_angles`] turns positions into fold angles and moments, [`triangle_forces`] turns those into forces on the nodes:
//! [`springs`] does both for one block of the sheet after the other. [`integrate`] sums what the blocks do to a node and moves
//! it, or, in a relaxation, [`reduce_forces`] and [`fire_move`]. The GPU's shaders have the same passes under the same names.
//! Each is written once, over a [`lane::Lane`], and compiled for each set of instructions. Positions are always f64; the rest
//! is f64 or, where [`Kernel`] is of f32, f32.
//!
//! Nothing depends on how many elements lie side by side: with products and sums rounded once, results have the same bits.

mod access;
mod angle;
mod areas;
mod blocks;
mod bounds;
mod fire_move;
mod fold_angles;
mod gather;
mod integrate;
mod isa;
mod lane;
mod lanes;
mod layout;
mod lookup;
mod loose_beams;
mod near;
mod of_triangles;
mod outside;
#[cfg(feature = "parallel")]
mod parallelism;
#[cfg(not(feature = "parallel"))]
#[path = "alone.rs"]
mod parallelism;
mod real;
mod reduce_forces;
mod scratch;
mod share;
mod springs;
mod triangle_forces;

#[cfg(test)]
mod tests;

pub(crate) use bounds::Bounds;
pub(crate) use isa::{Compute, Isa};
pub(crate) use real::Quad64;

use glam::DVec3;

use crate::ids::{CreaseId, NodeId};
use crate::model::{Model, Softening};
use crate::scene::{Axes, Held, Scene};
use crate::twins::fire_update::{Decision, Sums};
use blocks::NODES;
use fire_move::FireMove;
use integrate::{Euler, Verlet};
use layout::Layout;
use outside::{Apply, Outside};
use parallelism::Parallelism;
use real::Real;
use reduce_forces::{BLOCK, ReduceForces, total_of};
use scratch::Scratch;
use springs::Springs;
use triangle_forces::AtRest;

/// A sheet in motion.
#[derive(Clone, Debug)]
pub(crate) struct Kernel<R: Compute> {
    isa: Isa,
    parallelism: Parallelism,
    bounds: Bounds,
    layout: Layout<R>,
    positions: Vec<Quad64>,
    velocities: Vec<R::Quad>,
    /// By crease of each block.
    angles: Vec<R>,
    targets: Vec<R>,
    outside: Outside<R>,
    /// The forces of springs on the nodes of each block, then those from outside.
    slots: Vec<R::Quad>,
    /// One for each task.
    scratch: Vec<Scratch<R>>,
    /// By node: forces of a relaxation, or Verlet's accelerations of the step before; empty until a pass needs them.
    forces: Vec<R::Quad>,
    /// By block of nodes: FIRE's sums of a relaxation.
    sums: Vec<Sums>,
}

impl<R: Compute> Kernel<R> {
    /// `model` with its nodes at `positions`, moving at `velocities`, its creases at `angles`; only where it is `damped` can
    /// damping be asked for. `threads` of this thread's pool share the passes, as long as that is faster.
    pub(crate) fn new(
        model: &Model,
        damped: bool,
        bounds: Bounds,
        positions: &[DVec3],
        velocities: &[DVec3],
        angles: &[f64],
        threads: usize,
    ) -> Self {
        Self::with((Isa::best(), threads), model, damped, bounds, positions, velocities, angles)
    }

    /// The same by the instructions of `isa`.
    pub(crate) fn with(
        (isa, threads): (Isa, usize),
        model: &Model,
        damped: bool,
        bounds: Bounds,
        positions: &[DVec3],
        velocities: &[DVec3],
        angles: &[f64],
    ) -> Self {
        let mut layout = Layout::new(model, R::width(isa), damped);
        let mut scratch = Scratch::new();
        let at_rest: Vec<Quad64> = model.rest.iter().map(|p| f64::quad_of(*p)).collect();
        let Layout { blocks, block_nodes, corners, beams, angles: corner_angles, .. } = &mut layout;
        let near = &mut scratch.near;
        let pass = AtRest { blocks, block_nodes, corners, positions: &at_rest, near, beams, angles: corner_angles };
        R::run(isa, pass);
        let creases = layout.stiffness.len();
        let mut kernel = Self {
            isa,
            parallelism: Parallelism::new(threads),
            bounds,
            positions: positions.iter().map(|p| f64::quad_of(*p)).collect(),
            velocities: velocities.iter().map(|v| R::quad_of(*v)).collect(),
            angles: vec![R::default(); creases],
            targets: vec![R::default(); creases],
            slots: vec![R::Quad::default(); layout.slot_count()],
            scratch: vec![scratch],
            forces: Vec::new(),
            sums: Vec::new(),
            outside: Outside::none(),
            layout,
        };
        kernel.velocities.resize(kernel.layout.nodes, R::Quad::default());
        kernel.set_angles(angles);
        kernel.set_outside(model, &Held::new(model, &Scene::default()), false, std::iter::empty());
        kernel
    }

    /// Says where something acts from outside: at nodes that are held or loaded, or `everywhere`. What is held stops along
    /// the axes that hold it.
    pub(crate) fn set_outside(
        &mut self,
        model: &Model,
        held: &Held,
        everywhere: bool,
        loaded: impl Iterator<Item = NodeId>,
    ) {
        let mut nodes: Vec<u32> = match everywhere {
            true => model.rest.iter().zip(0..).map(|(_, n)| n).collect(),
            false => held.iter().map(|(node, _)| node).chain(loaded).map(|node| node.0).collect(),
        };
        nodes.sort_unstable();
        nodes.dedup();
        let mut axes = held.iter().peekable();
        let axes_of = |n: &u32| axes.next_if(|(node, _)| node.0 == *n).map_or(Axes::default(), |(_, axes)| axes);
        let own: Vec<Axes> = nodes.iter().map(axes_of).collect();
        if nodes != self.outside.nodes {
            self.layout.set_slots(&nodes);
            self.slots.resize(self.layout.slot_count() + nodes.len(), R::Quad::default());
            self.outside.loads = vec![R::Quad::default(); nodes.len()];
        }
        (self.outside.nodes, self.outside.held) = (nodes, own);
        for (node, axes) in held.iter() {
            for list in [&mut self.velocities, &mut self.forces] {
                if let Some(own) = list.get_mut(node.index()) {
                    *own = R::quad_of(axes.without(R::vector(*own)));
                }
            }
        }
    }

    /// Takes the forces from outside, by node.
    pub(crate) fn set_loads(&mut self, forces: &[DVec3]) {
        for (load, node) in self.outside.loads.iter_mut().zip(&self.outside.nodes) {
            *load = R::quad_of(forces[*node as usize]);
        }
    }

    /// What holds a node along some axes does to it, as of the last second pass.
    pub(crate) fn reaction(&self, node: NodeId, axes: Axes) -> DVec3 {
        let Ok(i) = self.outside.nodes.binary_search(&node.0) else { return DVec3::ZERO };
        let last = self.slots[self.layout.slot_count() + i];
        axes.of(R::vector(last) - R::vector(self.outside.loads[i]))
    }

    /// Whether the passes are shared out among threads at present.
    pub(crate) fn shared(&self) -> bool {
        self.parallelism.tasks() > 1
    }

    /// Sets the target angle of each crease, in radians.
    pub(crate) fn set_targets(&mut self, targets: impl Iterator<Item = f64>) {
        self.layout.by_crease(targets, &mut self.targets);
    }

    /// Makes the springs so soft; they are exactly the model's without.
    pub(crate) fn soften(&mut self, model: &Model, softening: Option<Softening>) {
        if softening != self.layout.softening {
            self.layout.soften(model, R::width(self.isa), softening);
        }
    }

    /// How soft they are.
    pub(crate) fn softening(&self) -> Option<Softening> {
        self.layout.softening
    }

    /// Writes the creases that softening turns back to flat: those folded to the other side than their targets.
    pub(crate) fn read_wrong_sides(&self, wrong: &mut Vec<CreaseId>) {
        wrong.clear();
        if self.layout.wrong_side == 0.0 {
            return;
        }
        let is_wrong = |place: u32| {
            let [angle, target] = [&self.angles, &self.targets].map(|list| list[place as usize].to_f64());
            angle * target < 0.0
        };
        let creases = self.layout.place_of_crease.iter().enumerate();
        wrong.extend(creases.filter(|(_, place)| is_wrong(**place)).map(|(crease, _)| CreaseId::new(crease)));
    }

    /// First passes: fold angles, and forces of all springs, of the damping if `damped`, and from outside. The result is the
    /// most by which a crease turned since the last time, in radians.
    pub(crate) fn springs(&mut self, damped: bool) -> f64 {
        self.parallelism.step();
        // No block is shared.
        let tasks = self.parallelism.tasks().min(self.layout.blocks.len() - 1).max(1);
        if self.scratch.len() < tasks {
            self.scratch.resize_with(tasks, Scratch::new);
        }
        let Self { layout, positions, targets, angles, scratch, .. } = self;
        let velocities = if damped && layout.damped { &self.velocities[..] } else { &[] };
        let (springs, last) = self.slots.split_at_mut(layout.slot_count());
        let (slots, _) = springs.as_chunks_mut::<NODES>();
        let (blocks, scratch) = (&layout.blocks[..], &mut scratch[..tasks]);
        let pass = Springs { layout, blocks, positions, velocities, targets, angles, slots, scratch };
        let turned = share::run::<R, _>(self.isa, pass, tasks);
        if !last.is_empty() {
            let (rows, slots) = (layout.slots.starts(), layout.slots.items());
            R::run(self.isa, Apply { outside: &self.outside, rows, slots, springs, last });
        }
        turned
    }

    /// Third pass of dynamics, first order. False where a node may be out of bounds.
    pub(crate) fn euler(&mut self, time_step: f64) -> bool {
        let nodes = self.layout.nodes;
        let (positions, velocities) = (&mut self.positions[..nodes], &mut self.velocities[..nodes]);
        let Self { layout, slots: forces, bounds, .. } = self;
        let (rows, slots) = (layout.slots.starts(), layout.slots.items());
        share::run::<R, _>(
            self.isa,
            Euler { bounds: *bounds, rows, slots, forces, positions, velocities, time_step },
            self.parallelism.tasks(),
        )
    }

    /// Third pass of dynamics, second order. False where a node may be out of bounds.
    pub(crate) fn verlet(&mut self, time_step: f64, previous_step: f64) -> bool {
        let nodes = self.layout.nodes;
        self.forces.resize(nodes, R::Quad::default());
        let Self { layout, slots: forces, forces: accelerations, bounds, .. } = self;
        let (rows, slots) = (layout.slots.starts(), layout.slots.items());
        let (positions, velocities) = (&mut self.positions[..nodes], &mut self.velocities[..nodes]);
        let bounds = *bounds;
        let pass =
            Verlet { bounds, rows, slots, forces, positions, velocities, accelerations, time_step, previous_step };
        share::run::<R, _>(self.isa, pass, self.parallelism.tasks())
    }

    /// Third pass of a relaxation: sums the forces on each node. `masses` are by node, with their inverses.
    pub(crate) fn reduce_forces(&mut self, masses: &[[f64; 2]]) -> Sums {
        let nodes = self.layout.nodes;
        self.forces.resize(nodes, R::Quad::default());
        self.sums.resize(nodes.div_ceil(BLOCK), Sums::default());
        let Self { layout, slots: forces, forces: node_forces, sums, .. } = self;
        let (rows, slots) = (layout.slots.starts(), layout.slots.items());
        let velocities = &self.velocities[..nodes];
        share::run::<R, _>(
            self.isa,
            ReduceForces { rows, slots, forces, velocities, masses, node_forces, sums },
            self.parallelism.tasks(),
        );
        total_of(&self.sums)
    }

    /// Last pass of a relaxation: moves the nodes. False where a node may be out of bounds.
    pub(crate) fn fire_move(&mut self, masses: &[[f64; 2]], decision: Decision) -> bool {
        let nodes = self.layout.nodes;
        let Self { forces, bounds, .. } = self;
        let (positions, velocities) = (&mut self.positions[..nodes], &mut self.velocities[..nodes]);
        let pass = FireMove { decision, bounds: *bounds, forces, masses, positions, velocities };
        share::run::<R, _>(self.isa, pass, self.parallelism.tasks())
    }
}

/// The coordinates of a position.
pub(crate) fn vector(position: Quad64) -> DVec3 {
    f64::vector(position)
}
