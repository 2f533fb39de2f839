//! The paper's motion (2.5): damped springs on nodes of mass 1, integrated explicitly.

use glam::DVec3;

use super::guard::Guard;
use super::ramp::Ramp;
use super::settle::Settling;
use super::{
    DEFAULT_MAX_STEPS, DEFAULT_TOLERANCE, Failed, Folded, Progress, REPORT, Solver, State, Stop, TimeStep, largest,
    time_step,
};
use crate::forces::{Forces, damping};
use crate::model::{Inventory, Model};

/// Steps between two renewals of [`TimeStep::Safe`].
pub const RENEWAL: u64 = 20;

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
        let mut state = start.clone();
        let mut ramp = Ramp::new(&start.targets, model.targets(percent), self.ramp);
        let mut forces = Forces::new(model);
        let damping = if model.material.zeta > 0.0 { damping::coefficients(model) } else { Vec::new() };
        let mut clock = Clock::new(self, model);
        let verlet_nodes = if self.integrator == Integrator::Verlet { model.node_count() } else { 0 };
        let mut accelerations = vec![DVec3::ZERO; verlet_nodes];
        let mut guard = Guard::new(model, start);
        let mut settling = Settling::new(model, self.tolerance);

        let limit = self.steps.unwrap_or(self.max_steps);
        let mut steps = 0;
        let stop = loop {
            if steps >= limit {
                break if self.steps.is_some() { Stop::StepsDone } else { Stop::StepLimit };
            }
            ramp.advance();
            let dt = clock.step(model, &state, steps);
            let values = forces.evaluate(&state.positions, &ramp.targets, &mut state.fold_angles);
            if ramp.done() && settling.observe(&state.positions, values) && self.steps.is_none() {
                break Stop::Converged;
            }
            steps += 1;
            let holds = match self.integrator {
                Integrator::Euler => {
                    damping::add_forces(model, &damping, &state.velocities, values);
                    euler(&mut state, values, dt)
                }
                Integrator::Verlet => {
                    verlet_arrive(model, &mut state, values, &damping, &mut accelerations, 0.5 * clock.previous);
                    verlet_depart(&mut state, &accelerations, dt)
                }
            };
            clock.previous = dt;
            guard.check(holds, steps, &state, dt)?;
            if steps.is_multiple_of(REPORT) {
                observe(Progress { step: steps, ramp: ramp.share(), distance: settling.distance() });
            }
        };

        state.targets = ramp.into_asked();
        let values = forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles);
        let residual = largest(values);
        if self.integrator == Integrator::Verlet && steps > 0 {
            verlet_arrive(model, &mut state, values, &damping, &mut accelerations, 0.5 * clock.previous);
        }
        let (time_step, distance) = (clock.dt, settling.distance());
        Ok(Folded { state, percent, stop, steps, time_step, residual, distance, attempts: 1 })
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

/// `v += dt F`, `x += dt v` with the new v; false where a node went out of bounds.
fn euler(state: &mut State, forces: &[DVec3], dt: f64) -> bool {
    for ((x, v), f) in state.positions.iter_mut().zip(&mut state.velocities).zip(forces) {
        *v += *f * dt;
        *x += *v * dt;
    }
    holds(state, dt)
}

/// Ends the step before: brings the velocity from the middle of it to now, `kick` later. `forces` are those of the
/// springs alone; the damping acts on a velocity extrapolated by the acceleration before, so that its error is of second
/// order too.
fn verlet_arrive(
    model: &Model,
    state: &mut State,
    forces: &mut [DVec3],
    damping: &[f64],
    accelerations: &mut [DVec3],
    kick: f64,
) {
    for (v, a) in state.velocities.iter_mut().zip(accelerations.iter()) {
        *v += *a * kick;
    }
    damping::add_forces(model, damping, &state.velocities, forces);
    for ((v, f), a) in state.velocities.iter_mut().zip(forces).zip(accelerations) {
        *v += (*f - *a) * kick;
        *a = *f;
    }
}

/// Begins a step: on to the velocity in its middle, and to the position at its end.
fn verlet_depart(state: &mut State, accelerations: &[DVec3], dt: f64) -> bool {
    for ((x, v), a) in state.positions.iter_mut().zip(&mut state.velocities).zip(accelerations) {
        *v += *a * (0.5 * dt);
        *x += *v * dt;
    }
    holds(state, dt)
}

/// Whether all nodes are in bounds.
fn holds(state: &State, dt: f64) -> bool {
    state.positions.iter().zip(&state.velocities).all(|(x, v)| Guard::holds(*x, *v * dt))
}

/// The step, and its renewal.
struct Clock {
    rule: TimeStep,
    integrator: Integrator,
    dt: f64,
    /// The step before; 0 at first.
    previous: f64,
}

impl Clock {
    fn new(solver: &Dynamics, model: &Model) -> Self {
        let dt = match solver.time_step {
            TimeStep::Paper | TimeStep::Safe => time_step::paper(model),
            TimeStep::Fixed(dt) => dt,
        };
        Self { rule: solver.time_step, integrator: solver.integrator, dt, previous: 0.0 }
    }

    fn step(&mut self, model: &Model, state: &State, steps: u64) -> f64 {
        if self.rule == TimeStep::Safe && steps.is_multiple_of(RENEWAL) {
            self.dt = time_step::safe(model, &state.positions, self.integrator);
        }
        self.dt
    }
}
