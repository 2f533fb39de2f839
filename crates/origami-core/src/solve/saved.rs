//! A simulation set aside: all that it takes to go on bit for bit.

use glam::DVec3;

use super::State;
use super::ramp::Ramp;
use super::settle::Settling;
use super::stepper::{Mover, Stepper};
use crate::kernel::Compute;
use crate::model::{Model, Softening};
use crate::scene::{Held, Load, Refusal, Targets};

/// All that moves in a simulation, and what its method remembers. With the feature `serde` it can be written and read.
///
/// Not in it: the model, the method's settings, and forces of one's own, which whoever restores it brings along.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Saved {
    state: State,
    accelerations: Vec<DVec3>,
    ramp: Ramp,
    mover: Mover,
    settling: Settling,
    turned: f64,
    steps: u64,
    held: Held,
    loads: Vec<Load>,
    perturbation: f64,
    softening: Option<Softening>,
    asked: Targets,
}

impl Saved {
    pub(super) fn of<R: Compute>(stepper: &mut Stepper<R>, model: &Model, perturbation: f64) -> Self {
        stepper.read(model);
        let verlet = matches!(stepper.mover, Mover::Dynamics { integrator: super::Integrator::Verlet, .. });
        if verlet {
            stepper.kernel.read_accelerations(&mut stepper.accelerations);
        }
        let Stepper { kernel, surroundings, ramp, mover, settling, state, accelerations, turned, steps, .. } = stepper;
        Self {
            state: state.clone(),
            accelerations: if verlet { accelerations.clone() } else { Vec::new() },
            ramp: ramp.clone(),
            mover: mover.clone(),
            settling: settling.clone(),
            turned: *turned,
            steps: *steps,
            held: surroundings.held().clone(),
            loads: surroundings.loads().to_vec(),
            perturbation,
            softening: kernel.softening(),
            asked: Targets::at_rest(),
        }
    }

    pub(super) fn with_targets(self, asked: Targets) -> Self {
        Self { asked, ..self }
    }

    pub(super) fn targets(&self) -> Targets {
        self.asked.clone()
    }

    pub(super) fn loads(&self) -> &[Load] {
        &self.loads
    }

    pub(super) fn perturbation(&self) -> f64 {
        self.perturbation
    }

    /// The nodes that are held.
    pub(super) fn held(&self) -> &Held {
        &self.held
    }

    /// Whether it is of a sheet like `model`'s.
    pub(super) fn check(&self, model: &Model) -> Result<(), Refusal> {
        let (nodes, creases) = (model.node_count(), model.creases.len());
        let fits = |len: usize, wanted: usize| len == wanted || len == 0;
        let sound = self.state.positions.len() == nodes
            && self.state.velocities.len() == nodes
            && self.state.fold_angles.len() == creases
            && self.ramp.asked().len() == creases
            && fits(self.accelerations.len(), nodes)
            && self.settling.fits(nodes)
            && self.mover.fits(nodes)
            && self.held.iter().all(|(node, _)| node.index() < nodes)
            && self.loads.iter().all(|load| load.node.index() < nodes);
        if sound { Ok(()) } else { Err(Refusal::Saved { nodes, creases }) }
    }

    pub(super) fn put_into<R: Compute>(&self, stepper: &mut Stepper<R>, model: &Model) {
        let kernel = &mut stepper.kernel;
        kernel.set_positions(&self.state.positions);
        stepper.surroundings.change(model, kernel, self.held.clone(), self.loads.clone());
        kernel.set_velocities(&self.state.velocities);
        kernel.set_angles(&self.state.fold_angles);
        kernel.set_accelerations(&self.accelerations);
        kernel.set_targets(self.ramp.targets());
        kernel.soften(model, self.softening);
        (stepper.ramp, stepper.mover) = (self.ramp.clone(), self.mover.clone());
        (stepper.settling, stepper.turned, stepper.steps) = (self.settling.clone(), self.turned, self.steps);
        stepper.state.clone_from(&self.state);
    }
}
