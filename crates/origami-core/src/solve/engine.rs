//! What a [`super::Simulation`] runs on: the CPU here, a GPU in the crate `origami-gpu`.

use std::sync::Arc;

use glam::DVec3;

use super::relax::{ramp_between, softening_between};
use super::stepper::{Limit, Stepper};
use super::threads::{count, in_pool};
use super::{Dynamics, Failed, Folded, Positions, Precision, Relax, Saved, Solver, State, Stop, unwatched};
use crate::ids::NodeId;
use crate::model::{Model, Softening};
use crate::scene::{Axes, Held, Load, Needs, Reaction, Refusal, Scene, Targets};

/// How far a simulation has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report {
    /// Force evaluations so far: steps, since the simulation began.
    pub steps: u64,
    /// Whether the sheet is within the tolerance of the equilibrium of its scene.
    pub settled: bool,
    /// Estimated distance from the equilibrium in radii; infinite while there is no estimate: at first, while targets rise,
    /// and for some twenty steps after something has changed.
    pub distance: f64,
    /// The share of the way to the target angles at which the springs now pull, 0 to 1.
    pub ramp: f64,
}

/// What moves a sheet: [`Relax`] or [`Dynamics`], on the CPU or on a GPU.
pub trait Method: Solver {
    /// What computes it.
    type Engine: Engine;

    /// A sheet of `model` in the state `start`, in `scene`.
    ///
    /// # Errors
    /// [`Failed::Refused`] where the scene does not fit the model or the method, [`Failed::Backend`] where what computes gives
    /// up.
    fn engine(&self, model: &Arc<Model>, scene: &Scene, start: &State) -> Result<Self::Engine, Failed>;
}

/// A sheet in motion, on whatever computes it. [`super::Simulation`] is its interface for programs.
pub trait Engine {
    /// Takes so many steps, or fewer where it has settled and stops there.
    ///
    /// # Errors
    /// [`Failed::Diverged`] where the state leaves all bounds, [`Failed::Backend`] where what computes gives up.
    fn advance(&mut self, steps: u64, until_settled: bool) -> Result<Report, Failed>;

    /// How far it has come.
    fn report(&self) -> Report;

    /// Asks the creases for other angles, in radians; the way there is as the method's `ramp` says.
    ///
    /// # Errors
    /// [`Failed::Backend`] where what computes gives up.
    fn set_targets(&mut self, targets: Vec<f64>) -> Result<(), Failed>;

    /// Holds other nodes and takes other loads. Nodes stop along the axes that hold them.
    ///
    /// # Errors
    /// [`Failed::Refused`] where it has no loads, [`Failed::Backend`] where what computes gives up.
    fn set_surroundings(&mut self, held: Held, loads: Vec<Load>) -> Result<(), Failed>;

    /// Puts a node to a position along some axes, in radii.
    ///
    /// # Errors
    /// [`Failed::Backend`] where what computes gives up.
    fn place(&mut self, node: NodeId, axes: Axes, position: DVec3) -> Result<(), Failed>;

    /// Where the nodes are.
    ///
    /// # Errors
    /// [`Failed::Backend`] where what computes gives up.
    fn positions(&mut self) -> Result<Positions<'_>, Failed>;

    /// All that moves, with the targets as they are now.
    ///
    /// # Errors
    /// [`Failed::Backend`] where what computes gives up.
    fn state(&mut self) -> Result<State, Failed>;

    /// What the supports do to the held nodes at the last step, in the order of the nodes.
    ///
    /// # Errors
    /// [`Failed::Backend`] where what computes gives up.
    fn reactions(&mut self) -> Result<Vec<Reaction>, Failed>;

    /// All that it takes to go on bit for bit.
    ///
    /// # Errors
    /// [`Failed::Refused`] where the engine cannot be saved, [`Failed::Backend`] where what computes gives up.
    fn save(&mut self) -> Result<Saved, Failed>;

    /// Goes on from there. The engine was made for the same model by the same method.
    ///
    /// # Errors
    /// [`Failed::Refused`] where what was saved does not fit.
    fn restore(&mut self, saved: &Saved) -> Result<(), Failed>;

    /// The state that it came to, measured.
    ///
    /// # Errors
    /// [`Failed::Backend`] where what computes gives up.
    fn finish(self, targets: Targets) -> Result<Folded, Failed>
    where
        Self: Sized;
}

/// An engine on the CPU.
#[derive(Clone, Debug)]
pub struct CpuEngine {
    model: Arc<Model>,
    scene: Scene,
    start: State,
    threads: usize,
    way: Way,
    stepper: Precise,
}

/// How new targets are reached.
#[derive(Clone, Copy, Debug)]
struct Way {
    /// Steps of the ramp; `None`: in proportion to the way.
    ramp: Option<u32>,
    /// How far nodes will be moved before they are first folded; 0 once that is done.
    perturbation: f64,
    /// How soft the sheet is on its way from rest.
    softening: Option<Softening>,
}

#[derive(Clone, Debug)]
enum Precise {
    F64(Box<Stepper<f64>>),
    Mixed(Box<Stepper<f32>>),
}

/// The same for either precision.
macro_rules! either {
    ($engine:expr, $stepper:ident => $do:expr) => {
        match $engine {
            Precise::F64($stepper) => $do,
            Precise::Mixed($stepper) => $do,
        }
    };
}

impl Method for Relax {
    type Engine = CpuEngine;

    fn engine(&self, model: &Arc<Model>, scene: &Scene, start: &State) -> Result<CpuEngine, Failed> {
        let needs = "`Dynamics` with the paper's or a fixed time step does without";
        let checked = scene.check(model).and_then(|()| scene.check_forces(model, &[Needs::RowSums], "relax", needs));
        checked.map_err(|refusal| Failed::refused(refusal, start))?;
        let targets = scene.targets.of(model).map_err(|refusal| Failed::refused(refusal, start))?;
        let threads = count(model, self.threads);
        let attempt = self.first_attempt((model, scene), start, &targets);
        let (ramp, softening) = (attempt.ramp, attempt.softening);
        let begins = targets != start.targets || !scene.has_springs_only();
        let positions = self.first_positions(model, start, scene, &targets);
        let stepper = match self.precision {
            Precision::F64 => Precise::F64(Box::new(self.stepper(
                (model, start),
                positions,
                (scene, targets, ramp, softening),
                threads,
            ))),
            Precision::Mixed => Precise::Mixed(Box::new(self.stepper(
                (model, start),
                positions,
                (scene, targets, ramp, softening),
                threads,
            ))),
        };
        let way = Way {
            ramp: self.ramp,
            perturbation: if begins { 0.0 } else { self.perturbation },
            softening: self.softening,
        };
        Ok(CpuEngine { model: Arc::clone(model), scene: scene.clone(), start: start.clone(), threads, way, stepper })
    }
}

impl Method for Dynamics {
    type Engine = CpuEngine;

    fn engine(&self, model: &Arc<Model>, scene: &Scene, start: &State) -> Result<CpuEngine, Failed> {
        self.check(model, scene).map_err(|refusal| Failed::refused(refusal, start))?;
        let targets = scene.targets.of(model).map_err(|refusal| Failed::refused(refusal, start))?;
        let threads = count(model, self.threads);
        let stepper = match self.precision {
            Precision::F64 => Precise::F64(Box::new(self.stepper(model, start, (scene, targets), threads))),
            Precision::Mixed => Precise::Mixed(Box::new(self.stepper(model, start, (scene, targets), threads))),
        };
        let way = Way { ramp: Some(self.ramp), perturbation: 0.0, softening: None };
        Ok(CpuEngine { model: Arc::clone(model), scene: scene.clone(), start: start.clone(), threads, way, stepper })
    }
}

impl CpuEngine {
    /// Moves the nodes off every symmetry, once.
    fn perturb(&mut self) {
        let share = std::mem::take(&mut self.way.perturbation);
        if share == 0.0 {
            return;
        }
        let model = &self.model;
        either!(&mut self.stepper, stepper => {
            stepper.kernel.read_positions(&mut stepper.state.positions);
            super::perturb::perturb(model, stepper.surroundings.held(), &mut stepper.state.positions, share, 0);
            stepper.kernel.set_positions(&stepper.state.positions);
        });
    }

    fn refused(&self, refusal: Refusal) -> Failed {
        Failed::refused(refusal, &self.start)
    }
}

impl Engine for CpuEngine {
    fn advance(&mut self, steps: u64, until_settled: bool) -> Result<Report, Failed> {
        let Self { model, start, threads, stepper, .. } = self;
        let origin = (&**model, &*start);
        either!(stepper, stepper => {
            let limit = Limit { steps: stepper.steps + steps, all: !until_settled, crushed: None, lost: None, crawls: None };
            in_pool(*threads, || stepper.run(origin, limit, &mut unwatched))?;
        });
        Ok(self.report())
    }

    fn report(&self) -> Report {
        let (progress, settled) =
            either!(&self.stepper, stepper => (stepper.progress(), stepper.settling.has_settled()));
        Report { steps: progress.step, settled, distance: progress.distance, ramp: progress.ramp }
    }

    fn set_targets(&mut self, targets: Vec<f64>) -> Result<(), Failed> {
        if either!(&self.stepper, stepper => stepper.ramp.asked() == targets) {
            return Ok(());
        }
        self.perturb();
        let Self { model, scene, way, stepper, .. } = self;
        either!(stepper, stepper => {
            let now: Vec<f64> = stepper.ramp.targets().collect();
            let ramp = way.ramp.unwrap_or_else(|| ramp_between(model, now.iter().copied(), &targets));
            let softening = softening_between(way.softening, (model, scene), now.iter().copied());
            stepper.set_targets((model, softening), targets, ramp);
        });
        Ok(())
    }

    fn set_surroundings(&mut self, held: Held, loads: Vec<Load>) -> Result<(), Failed> {
        let model = &self.model;
        either!(&mut self.stepper, stepper => {
            let Stepper { kernel, surroundings, settling, .. } = &mut **stepper;
            surroundings.change(model, kernel, held, loads);
            settling.disturb();
        });
        Ok(())
    }

    fn place(&mut self, node: NodeId, axes: Axes, position: DVec3) -> Result<(), Failed> {
        either!(&mut self.stepper, stepper => {
            stepper.kernel.set_position(node, axes, position);
            stepper.settling.disturb();
        });
        Ok(())
    }

    fn positions(&mut self) -> Result<Positions<'_>, Failed> {
        let quads = either!(&self.stepper, stepper => stepper.kernel.positions());
        Ok(Positions::of_quads(quads, &self.model.normalisation))
    }

    fn state(&mut self) -> Result<State, Failed> {
        let model = &self.model;
        Ok(either!(&mut self.stepper, stepper => {
            stepper.read(model);
            State { targets: stepper.ramp.targets().collect(), ..stepper.state.clone() }
        }))
    }

    fn reactions(&mut self) -> Result<Vec<Reaction>, Failed> {
        Ok(either!(&self.stepper, stepper => stepper.surroundings.reactions(&stepper.kernel)))
    }

    fn save(&mut self) -> Result<Saved, Failed> {
        let (model, perturbation) = (&self.model, self.way.perturbation);
        Ok(either!(&mut self.stepper, stepper => Saved::of(stepper, model, perturbation)))
    }

    fn restore(&mut self, saved: &Saved) -> Result<(), Failed> {
        let model = Arc::clone(&self.model);
        saved.check(&model).map_err(|refusal| self.refused(refusal))?;
        self.way.perturbation = saved.perturbation();
        either!(&mut self.stepper, stepper => saved.put_into(stepper, &model));
        Ok(())
    }

    fn finish(self, targets: Targets) -> Result<Folded, Failed> {
        let settled = self.report().settled;
        let stop = if settled { Stop::Converged } else { Stop::StepsDone };
        let Self { model, mut scene, stepper, .. } = self;
        Ok(either!(stepper, stepper => {
            scene.loads = stepper.surroundings.loads().to_vec();
            stepper.into_folded(&model, &scene, targets, stop)
        }))
    }
}
