//! What moves the sheet: the processor here, a GPU elsewhere.

use std::sync::Arc;

use origami_core::Model;
use origami_core::glam::DVec3;
use origami_core::ids::NodeId;
use origami_core::scene::{Scene, Targets};
use origami_core::solve::{
    Dynamics, Failed, Integrator, Method, Precision, Relax, Report, Simulation, State, TimeStep,
};

use crate::message::{IntegratorName, PrecisionName, SolverName, SolverWish};

/// A [`Simulation`], whatever it runs on.
pub trait Mover {
    /// Asks the creases for other angles.
    ///
    /// # Errors
    /// As [`Simulation::set_targets`].
    fn set_targets(&mut self, targets: Targets) -> Result<(), Failed>;

    /// Holds a node where it is.
    ///
    /// # Errors
    /// As [`Simulation::pin`].
    fn hold(&mut self, node: NodeId) -> Result<(), Failed>;

    /// Puts a held node to a place, in radii.
    ///
    /// # Errors
    /// As [`Simulation::move_pin`].
    fn place(&mut self, node: NodeId, position: DVec3) -> Result<(), Failed>;

    /// Lets a held node go.
    ///
    /// # Errors
    /// As [`Simulation::unpin`].
    fn release(&mut self, node: NodeId) -> Result<(), Failed>;

    /// Takes steps: all of them, or until the sheet has settled.
    ///
    /// # Errors
    /// As [`Simulation::step`].
    fn advance(&mut self, steps: u64, until_settled: bool) -> Result<Report, Failed>;

    /// How far it has come.
    fn report(&self) -> Report;

    /// A copy of all that moves.
    ///
    /// # Errors
    /// As [`Simulation::state`].
    fn state(&mut self) -> Result<State, Failed>;
}

impl<M: Method> Mover for Simulation<M> {
    fn set_targets(&mut self, targets: Targets) -> Result<(), Failed> {
        Self::set_targets(self, targets)
    }

    fn hold(&mut self, node: NodeId) -> Result<(), Failed> {
        self.pin(node).map(|_| ())
    }

    fn place(&mut self, node: NodeId, position: DVec3) -> Result<(), Failed> {
        let pin = self.pin(node)?;
        self.move_pin(pin, position)
    }

    fn release(&mut self, node: NodeId) -> Result<(), Failed> {
        let pin = self.pin(node)?;
        self.unpin(pin)
    }

    fn advance(&mut self, steps: u64, until_settled: bool) -> Result<Report, Failed> {
        if until_settled { self.settle(steps) } else { self.step(steps) }
    }

    fn report(&self) -> Report {
        Self::report(self)
    }

    fn state(&mut self) -> Result<State, Failed> {
        Self::state(self)
    }
}

/// What makes a [`Mover`] of a model.
pub trait Computer {
    /// A sheet in the state `start`, in `scene`.
    ///
    /// # Errors
    /// As [`Simulation::in_scene`].
    fn mover(
        &self,
        wish: &SolverWish,
        model: Arc<Model>,
        scene: &Scene,
        start: State,
    ) -> Result<Box<dyn Mover>, Failed>;

    /// For a person.
    fn name(&self) -> String;
}

/// The processor.
#[derive(Clone, Copy, Debug, Default)]
pub struct Processor;

impl Computer for Processor {
    fn mover(
        &self,
        wish: &SolverWish,
        model: Arc<Model>,
        scene: &Scene,
        start: State,
    ) -> Result<Box<dyn Mover>, Failed> {
        Ok(match wish.name {
            SolverName::Relax => {
                Box::new(Simulation::in_scene(Arc::clone(&model), relax(wish, &model, &start), scene, start)?)
            }
            SolverName::Dynamics => Box::new(Simulation::in_scene(model, dynamics(wish), scene, start)?),
        })
    }

    fn name(&self) -> String {
        "processor".to_owned()
    }
}

fn precision(wish: &SolverWish) -> Precision {
    match wish.precision {
        PrecisionName::F64 => Precision::F64,
        PrecisionName::Mixed => Precision::Mixed,
    }
}

/// The relaxation that is wished for. A sheet that is on its way already is not moved off its symmetries again.
#[must_use]
pub fn relax(wish: &SolverWish, model: &Model, start: &State) -> Relax {
    let relax = Relax { tolerance: wish.tolerance, precision: precision(wish), ..Relax::default() };
    let perturbation = if start.positions == model.rest { relax.perturbation } else { 0.0 };
    Relax { perturbation, ..relax }
}

/// The dynamics that is wished for: at the safe time step, since a hand pulls harder than the paper's has room for.
#[must_use]
pub fn dynamics(wish: &SolverWish) -> Dynamics {
    let integrator = match wish.integrator {
        IntegratorName::Euler => Integrator::Euler,
        IntegratorName::Verlet => Integrator::Verlet,
    };
    let time_step = TimeStep::Safe;
    Dynamics { tolerance: wish.tolerance, integrator, time_step, precision: precision(wish), ..Dynamics::default() }
}
