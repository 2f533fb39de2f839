//! Moves a sheet by FIRE (the rule is [`crate::twins::fire_update`]) on masses equal to the row sums of its stiffness.

use crate::kernel::{Compute, Kernel};
use crate::model::Model;
use crate::twins::fire_update::{Fire, RENEWAL, fire_update};

use super::State;
use super::clusters::Clusters;
use super::row_sums::{OnTheWay, all_row_sums};
use super::surroundings::Surroundings;

/// The minimiser's own state.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Minimiser {
    /// By node, with their inverses.
    masses: Vec<[f64; 2]>,
    #[cfg_attr(feature = "serde", serde(skip))]
    sums: Vec<f64>,
    #[cfg_attr(feature = "serde", serde(skip))]
    way: OnTheWay,
    /// Of their nodes there are no masses.
    clusters: Clusters,
    fire: Fire,
    evaluations: u64,
}

impl Minimiser {
    /// `near` is [`Relax::near`](super::Relax::near).
    pub(super) fn new(model: &Model, near: f64) -> Self {
        let (masses, sums) = (vec![[0.0; 2]; model.node_count()], vec![0.0; model.node_count()]);
        let clusters = Clusters::new(model, near);
        Self { masses, sums, way: OnTheWay::default(), clusters, fire: Fire::default(), evaluations: 0 }
    }

    /// The present step, in units of each node's own.
    pub(super) fn step(&self) -> f64 {
        self.fire.step
    }

    /// Whether it is of a sheet of so many nodes.
    pub(super) fn fits(&self, nodes: usize) -> bool {
        self.masses.len() == nodes && self.clusters.fits(nodes)
    }

    /// Takes the masses anew at the next evaluation.
    pub(super) fn renew(&mut self) {
        self.evaluations = 0;
    }

    /// Moves the sheet by the forces at its positions, which `state` is told where they are needed; false where a node may be
    /// out of bounds.
    pub(super) fn advance<R: Compute>(
        &mut self,
        model: &Model,
        surroundings: &Surroundings,
        kernel: &mut Kernel<R>,
        state: &mut State,
    ) -> bool {
        if self.evaluations.is_multiple_of(RENEWAL) {
            kernel.read_positions(&mut state.positions);
            self.sums.resize(model.node_count(), 0.0);
            self.way.softening = kernel.softening();
            kernel.read_wrong_sides(&mut self.way.wrong);
            let shared = kernel.shared();
            let sheet = (model, &self.way, surroundings.forces());
            all_row_sums(shared, sheet, &state.positions, &mut self.sums);
            self.masses.clear();
            self.masses.extend(self.sums.iter().map(|mass| [*mass, 1.0 / mass]));
            self.clusters.take(sheet, &state.positions, &mut self.masses);
        }
        self.evaluations += 1;
        let sums = kernel.reduce_forces(&self.masses);
        let sums = self.clusters.add_to(kernel, surroundings.held(), sums);
        let decision = fire_update(&mut self.fire, sums);
        let in_bounds = kernel.fire_move(&self.masses, decision);
        self.clusters.shift(kernel, decision);
        in_bounds
    }
}
