//! The paper's motion (2.5): damped springs on nodes of mass 1, integrated explicitly.

use glam::DVec3;

use super::motion::Motion;
use super::ramp::Ramp;
use super::threads::share;
use super::time_step::Safe;
use super::{
    DEFAULT_MAX_STEPS, DEFAULT_TOLERANCE, Failed, Folded, Precision, Progress, REPORT, Solver, State, Stop, TimeStep,
    time_step,
};
use crate::forces::damping;
use crate::kernel::Compute;
use crate::model::{Inventory, Model};

/// Steps between two renewals of [`TimeStep::Safe`]. At 20 a jump of creases 10 000 times stiffer than by default leaves the
/// step behind (`origami study stability`).
pub const RENEWAL: u64 = 10;

/// How [`Dynamics`] steps through time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// `v += dt a(x, v)`, then `x += dt v`: what the paper calls explicit Euler is the semi-implicit one. First order.
    Euler,
    /// Velocity Verlet, with the damping at a velocity extrapolated to the same instant. Second order.
    Verlet,
}

/// The paper's scheme, for fidelity and transients. It converges slowly: its damping hardly touches slow global motion.
/// For the folded state take [`super::Relax`].
#[derive(Clone, Debug, PartialEq)]
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
        }
    }
}

impl Solver for Dynamics {
    fn fold(
        &self,
        model: &Model,
        start: &State,
        percent: f64,
        observe: &mut dyn FnMut(Progress),
    ) -> Result<Folded, Failed> {
        share(model, observe, |threads, observe| match self.precision {
            Precision::F64 => self.run::<f64>(model, start, percent, threads, observe),
            Precision::Mixed => self.run::<f32>(model, start, percent, threads, observe),
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
    fn run<R: Compute>(
        &self,
        model: &Model,
        start: &State,
        percent: f64,
        threads: usize,
        observe: &mut dyn FnMut(Progress),
    ) -> Result<Folded, Failed> {
        let mut ramp = Ramp::new(&start.targets, model.targets(percent), self.ramp);
        let moving = (start.positions.clone(), &start.velocities[..]);
        let damped = model.material.zeta > 0.0;
        let mut motion = Motion::<R>::new(model, start, moving, damped, self.tolerance, threads);
        let mut clock = Clock::new(self, model);
        motion.kernel.set_targets(&ramp.targets);

        let limit = self.steps.unwrap_or(self.max_steps);
        let mut steps = 0;
        let stop = loop {
            if steps >= limit {
                break if self.steps.is_some() { Stop::StepsDone } else { Stop::StepLimit };
            }
            if !ramp.done() {
                ramp.advance();
                motion.kernel.set_targets(&ramp.targets);
            }
            let dt = clock.step(&mut motion, steps);
            motion.kernel.fold_angles();
            // Damping has no part in what tells how far it is to the equilibrium.
            let looks = ramp.done() && motion.settling.looks();
            if looks {
                motion.kernel.triangle_forces(false);
            }
            if ramp.done() && motion.settled() && self.steps.is_none() {
                break Stop::Converged;
            }
            if damped || !looks {
                motion.kernel.triangle_forces(damped);
            }
            steps += 1;
            let holds = match self.integrator {
                Integrator::Euler => motion.kernel.euler(dt),
                Integrator::Verlet => motion.kernel.verlet(dt, clock.previous),
            };
            clock.previous = dt;
            let ahead = if self.integrator == Integrator::Verlet { 0.5 * dt } else { 0.0 };
            motion.check(holds, steps, dt, ahead)?;
            if steps.is_multiple_of(REPORT) {
                observe(Progress { step: steps, ramp: ramp.share(), distance: motion.settling.distance() });
            }
        };

        let arrives = self.integrator == Integrator::Verlet && steps > 0;
        if arrives {
            motion.read_accelerations();
        }
        let end = (percent, stop, steps, clock.dt);
        Ok(motion.into_folded(ramp.into_asked(), end, |state, before, forces| {
            if arrives {
                arrive(model, state, before, forces, clock.previous);
            }
        }))
    }
}

/// Ends the last step of [`Integrator::Verlet`], whose velocity is extrapolated to its end by the accelerations `before`.
/// `forces` are those of the springs alone.
fn arrive(model: &Model, state: &mut State, before: &[DVec3], forces: &mut [DVec3], time_step: f64) {
    damping::add(model, &state.velocities, forces);
    for ((v, force), before) in state.velocities.iter_mut().zip(forces).zip(before) {
        *v += (*force - *before) * (0.5 * time_step);
    }
}

/// The step, and its renewal.
struct Clock {
    /// Of [`TimeStep::Safe`].
    safe: Option<Safe>,
    dt: f64,
    /// The step before; 0 at first.
    previous: f64,
}

impl Clock {
    fn new(solver: &Dynamics, model: &Model) -> Self {
        let safe = (solver.time_step == TimeStep::Safe).then(|| Safe::new(model, solver.integrator));
        let dt = match solver.time_step {
            TimeStep::Paper | TimeStep::Safe => time_step::paper(model),
            TimeStep::Fixed(dt) => dt,
        };
        Self { safe, dt, previous: 0.0 }
    }

    fn step<R: Compute>(&mut self, motion: &mut Motion<'_, R>, steps: u64) -> f64 {
        if let Some(safe) = &mut self.safe
            && steps.is_multiple_of(RENEWAL)
        {
            motion.read_nodes();
            let safe = safe.step(motion.kernel.shared(), motion.model, &motion.state.positions);
            self.dt = time_step::renewed(safe, &motion.state.velocities, (steps > 0).then_some(self.dt));
        }
        self.dt
    }
}
