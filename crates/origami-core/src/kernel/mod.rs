//! The step on the processor as it is run: the springs of [`crate::forces`] in three passes, several elements side by side.
//!
//! *Edges* turn places into angles and moments, *faces* turn those into forces on their corners, *nodes* sum these and
//! move. The GPU's shaders have the same passes under the same names. Each pass is written once, over a [`lane::Lane`], and
//! compiled for each set of instructions. Places are always f64; the rest is f64 or, where [`Kernel`] is of f32, f32.
//!
//! Nothing depends on how many elements lie side by side: with products and sums rounded once, results have the same bits.

mod angle;
mod bounds;
mod edges;
mod faces;
mod gather;
mod isa;
mod lane;
mod lanes;
mod lookup;
mod loose_beams;
mod moves;
mod nodes;
mod real;
mod share;
mod sheet;
#[cfg(feature = "parallel")]
mod team;
#[cfg(not(feature = "parallel"))]
#[path = "alone.rs"]
mod team;
mod weigh;

#[cfg(test)]
mod tests;

pub(crate) use bounds::Bounds;
pub(crate) use isa::Compute;
pub(crate) use moves::Decision;
pub(crate) use weigh::Sums;

use glam::DVec3;

use crate::model::Model;
use edges::Edges;
use faces::{AtRest, Faces};
use isa::Isa;
use loose_beams::LooseBeams;
use moves::Moves;
use nodes::{Euler, Verlet};
use real::{Quad64, Real};
use sheet::Sheet;
use team::Team;
use weigh::{BLOCK, Weigh};

/// A sheet in motion.
#[derive(Clone, Debug)]
pub(crate) struct Kernel<R: Compute> {
    isa: Isa,
    team: Team,
    bounds: Bounds,
    sheet: Sheet<R>,
    places: Vec<Quad64>,
    velocities: Vec<R::Quad>,
    /// By crease.
    angles: Vec<R>,
    targets: Vec<R>,
    moments: Vec<R>,
    /// The forces of faces and loose beams on their nodes.
    slots: Vec<R::Quad>,
    /// By node: forces, or the accelerations of the step before; empty until they are asked for.
    forces: Vec<R::Quad>,
    /// By block of nodes, of a relaxation.
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

    fn with(
        (isa, threads): (Isa, usize),
        model: &Model,
        damped: bool,
        bounds: Bounds,
        positions: &[DVec3],
        velocities: &[DVec3],
        angles: &[f64],
    ) -> Self {
        let mut sheet = Sheet::new(model, R::width(isa), damped);
        let at_rest = sheet.places(&model.rest);
        let Sheet { corners, beams, angles: corner_angles, .. } = &mut sheet;
        R::run(isa, AtRest { corners, places: &at_rest, beams, angles: corner_angles });
        let places = sheet.places(positions);
        let mut velocities: Vec<R::Quad> = velocities.iter().map(|v| R::quad_of(*v)).collect();
        velocities.resize(places.len(), R::Quad::default());
        let creases = sheet.stiffness.len();
        let mut angles: Vec<R> = angles.iter().map(|angle| R::of(*angle)).collect();
        angles.resize(creases, R::default());
        Self {
            isa,
            team: Team::new(threads),
            bounds,
            places,
            velocities,
            angles,
            targets: vec![R::default(); creases],
            moments: vec![R::default(); creases.next_power_of_two()],
            slots: vec![R::Quad::default(); sheet.slot_count()],
            forces: Vec::new(),
            sums: Vec::new(),
            sheet,
        }
    }

    /// Whether the passes are shared out among threads at present.
    pub(crate) fn shared(&self) -> bool {
        self.team.parts() > 1
    }

    /// Asks the creases for `targets`, in radians.
    pub(crate) fn aim(&mut self, targets: &[f64]) {
        for (own, target) in self.targets.iter_mut().zip(targets) {
            *own = R::of(*target);
        }
    }

    /// First pass; the result is the most by which a crease turned since the last, in radians.
    pub(crate) fn edges(&mut self) -> f64 {
        self.team.step();
        if self.sheet.stiffness.is_empty() {
            return 0.0;
        }
        let Self { sheet: Sheet { hinges, stiffness, .. }, places, targets, angles, moments, .. } = self;
        share::run::<R, _>(self.isa, Edges { places, hinges, stiffness, targets, angles, moments }, self.team.parts())
    }

    /// Second pass: forces of all springs, and of the damping if `damped`.
    pub(crate) fn faces(&mut self, damped: bool) {
        let Self { sheet, places, moments, .. } = self;
        let velocities = if damped && sheet.damped { &self.velocities[..] } else { &[] };
        let (slots, loose) = self.slots.split_at_mut(sheet.corners.len());
        share::run::<R, _>(self.isa, Faces { sheet, places, velocities, moments, first: 0, slots }, self.team.parts());
        if !loose.is_empty() {
            R::run(self.isa, LooseBeams { sheet, places, velocities, slots: loose });
        }
    }

    /// Third pass of dynamics, first order. False where a node may be out of bounds.
    pub(crate) fn euler(&mut self, time_step: f64) -> bool {
        let nodes = self.sheet.nodes;
        let (places, velocities) = (&mut self.places[..nodes], &mut self.velocities[..nodes]);
        let Self { sheet: Sheet { rows, slots, .. }, slots: forces, bounds, .. } = self;
        share::run::<R, _>(
            self.isa,
            Euler { bounds: *bounds, rows, slots, forces, places, velocities, time_step },
            self.team.parts(),
        )
    }

    /// Third pass of dynamics, second order. False where a node may be out of bounds.
    pub(crate) fn verlet(&mut self, time_step: f64, previous_step: f64) -> bool {
        let nodes = self.sheet.nodes;
        self.forces.resize(nodes, R::Quad::default());
        let Self { sheet: Sheet { rows, slots, .. }, slots: forces, forces: accelerations, bounds, .. } = self;
        let (places, velocities) = (&mut self.places[..nodes], &mut self.velocities[..nodes]);
        let bounds = *bounds;
        let pass = Verlet { bounds, rows, slots, forces, places, velocities, accelerations, time_step, previous_step };
        share::run::<R, _>(self.isa, pass, self.team.parts())
    }

    /// Third pass of a relaxation; `masses` are by node, with their inverses.
    pub(crate) fn weigh(&mut self, masses: &[[f64; 2]]) -> Sums {
        let nodes = self.sheet.nodes;
        self.forces.resize(nodes, R::Quad::default());
        self.sums.resize(nodes.div_ceil(BLOCK), Sums::default());
        let Self { sheet: Sheet { rows, slots, .. }, slots: forces, forces: kept, sums, .. } = self;
        let velocities = &self.velocities[..nodes];
        share::run::<R, _>(self.isa, Weigh { rows, slots, forces, velocities, masses, kept, sums }, self.team.parts());
        Sums::of(&self.sums)
    }

    /// Last pass of a relaxation. False where a node may be out of bounds.
    pub(crate) fn moves(&mut self, masses: &[[f64; 2]], decision: Decision) -> bool {
        let nodes = self.sheet.nodes;
        let Self { forces, bounds, .. } = self;
        let (places, velocities) = (&mut self.places[..nodes], &mut self.velocities[..nodes]);
        let pass = Moves { decision, bounds: *bounds, forces, masses, places, velocities };
        share::run::<R, _>(self.isa, pass, self.team.parts())
    }

    /// Where the nodes are.
    pub(crate) fn read_positions(&self, positions: &mut Vec<DVec3>) {
        positions.clear();
        positions.extend(self.places[..self.sheet.nodes].iter().map(|quad| f64::vector(*quad)));
    }

    /// How they move.
    pub(crate) fn read_velocities(&self, velocities: &mut Vec<DVec3>) {
        velocities.clear();
        velocities.extend(self.velocities[..self.sheet.nodes].iter().map(|quad| R::vector(*quad)));
    }

    /// The fold angles; `angles` has one for each crease.
    pub(crate) fn read_angles(&self, angles: &mut [f64]) {
        for (angle, own) in angles.iter_mut().zip(&self.angles) {
            *angle = own.to_f64();
        }
    }

    /// What the second pass did to the nodes.
    pub(crate) fn read_forces(&self, forces: &mut Vec<DVec3>) {
        forces.clear();
        let sum = |slots: &[u32]| slots.iter().map(|slot| R::vector(self.slots[*slot as usize])).sum::<DVec3>();
        forces.extend(gather::rows(&self.sheet.rows, &self.sheet.slots).map(sum));
    }

    /// The accelerations of the last step of [`Kernel::verlet`].
    pub(crate) fn read_accelerations(&self, accelerations: &mut Vec<DVec3>) {
        accelerations.clear();
        accelerations.extend(self.forces.iter().map(|quad| R::vector(*quad)));
    }
}
