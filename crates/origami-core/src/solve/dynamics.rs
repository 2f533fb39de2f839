//! The paper's motion (2.5): damped springs on nodes of mass 1, integrated explicitly.

use std::num::NonZeroUsize;
use std::ops::ControlFlow;

use super::clock::Clock;
use super::integrator::Integrator;
use super::ramp::Ramp;
use super::stepper::{Limit, Mover, Stepper};
use super::threads::{count, share};
use super::{DEFAULT_MAX_STEPS, DEFAULT_TOLERANCE, Failed, Folded, Precision, Progress, Solver, State, TimeStep};
use crate::kernel::Compute;
use crate::model::{Inventory, Model};
use crate::scene::{Needs, Refusal, Scene};

/// The paper's scheme, for fidelity and transients. It converges slowly: its damping hardly touches slow global motion.
/// For the folded state take [`super::Relax`].
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct Dynamics {
    /// Length of a step. Default: the paper's.
    pub time_step: TimeStep,
    /// Default: Euler.
    pub integrator: Integrator,
    /// Steps over which the target angles rise. Default 0: they jump.
    pub ramp: u32,
    /// Distance from the equilibrium at which it stops, in radii of the sheet. Default 1e-4.
    pub tolerance: f64,
    /// Steps after which it gives up. Default 100 000.
    pub max_steps: u64,
    /// Run exactly so many steps instead. Default: until it has converged.
    pub steps: Option<u64>,
    /// The numbers in which the processor computes: [`Precision::Mixed`] for speed, where seven digits will do. GPUs have
    /// numbers of their own. Default f64.
    pub precision: Precision,
    /// Threads that share the steps of a large sheet; more than the pool has gain nothing. Default: as many as the pool
    /// has, and one on a thread of a pool; of small sheets one.
    pub threads: Option<NonZeroUsize>,
}

impl Default for Dynamics {
    fn default() -> Self {
        Self {
            time_step: TimeStep::Paper,
            integrator: Integrator::Euler,
            ramp: 0,
            tolerance: DEFAULT_TOLERANCE,
            max_steps: DEFAULT_MAX_STEPS,
            steps: None,
            precision: Precision::F64,
            threads: None,
        }
    }
}

impl Solver for Dynamics {
    fn fold(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        // So many steps can be taken of a sheet that flies away; it never settles.
        let balanced = || if self.steps.is_none() { scene.check_balance(model) } else { Ok(()) };
        self.check(model, scene).and_then(|()| balanced()).map_err(|refusal| Failed::refused(refusal, start))?;
        let targets = scene.targets.of(model).map_err(|refusal| Failed::refused(refusal, start))?;
        share(count(model, self.threads), observe, |threads, observe| match self.precision {
            Precision::F64 => self.run::<f64>(model, start, (scene, targets), threads, observe),
            Precision::Mixed => self.run::<f32>(model, start, (scene, targets), threads, observe),
        })
    }

    fn inventory(&self, model: &Model) -> Inventory {
        let mut inventory = model.inventory.clone();
        if model.material.zeta > 0.0 {
            inventory.built("damping", model.beams.len());
        } else {
            inventory.without("damping", "zeta is 0");
        }
        inventory
    }
}

impl Dynamics {
    /// Whether this can run the scene.
    pub(super) fn check(&self, model: &Model, scene: &Scene) -> Result<(), Refusal> {
        scene.check(model)?;
        if self.time_step == TimeStep::Safe {
            scene.check_forces(model, &[Needs::RowSums], "the safe time step", "a fixed time step needs none")?;
        }
        Ok(())
    }

    /// A sheet that moves as this says, from `start`.
    pub(super) fn stepper<R: Compute>(
        &self,
        model: &Model,
        start: &State,
        (scene, targets): (&Scene, Vec<f64>),
        threads: usize,
    ) -> Stepper<R> {
        let ramp = Ramp::new(&start.targets, targets, self.ramp);
        let moving = (start.positions.clone(), &start.velocities[..]);
        let damped = model.material.zeta > 0.0;
        let mover = Mover::Dynamics {
            clock: Clock::new(self.time_step, self.integrator, model),
            integrator: self.integrator,
            damped,
        };
        Stepper::new((model, start), scene, moving, (mover, ramp), self.tolerance, threads)
    }

    fn run<R: Compute>(
        &self,
        model: &Model,
        start: &State,
        (scene, targets): (&Scene, Vec<f64>),
        threads: usize,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        let mut stepper = self.stepper::<R>(model, start, (scene, targets), threads);
        let limit = Limit {
            steps: self.steps.unwrap_or(self.max_steps),
            all: self.steps.is_some(),
            crushed: None,
            lost: None,
            crawls: None,
        };
        let stop = stepper.run((model, start), limit, observe)?;
        Ok(stepper.into_folded(model, scene, scene.targets.clone(), stop))
    }
}
