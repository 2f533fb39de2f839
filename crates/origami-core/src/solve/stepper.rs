//! A sheet in motion: one evaluation after the other, by whatever moves its nodes. The solvers and [`super::Simulation`] are
//! drivers of this.

use std::ops::ControlFlow;

use glam::DVec3;

use super::clock::Clock;
use super::crushed::is_crushed;
use super::fire::Minimiser;
use super::guard::{Diverged, Guard};
use super::largest::largest;
use super::ramp::Ramp;
use super::settle::Settling;
use super::state::lost_creases;
use super::surroundings::Surroundings;
use super::{Folded, Integrator, Progress, REPORT, State, Stop};
use crate::forces::{Forces, damping};
use crate::kernel::{Bounds, Compute, Kernel};
use crate::model::{Model, Softening};
use crate::scene::{Held, Scene, Targets};
use crate::twins::checkpoint::COPY_EVERY;
use crate::twins::fire_update::HOLD;
use crate::twins::state_bounds::{FARTHEST, LONGEST_MOVE};

/// What moves the nodes.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Mover {
    /// FIRE, towards the equilibrium.
    Relax(Minimiser),
    /// The paper's motion through time.
    Dynamics { clock: Clock, integrator: Integrator, damped: bool },
}

impl Mover {
    /// Whether it is of a sheet of so many nodes.
    pub(super) fn fits(&self, nodes: usize) -> bool {
        match self {
            Self::Relax(minimiser) => minimiser.fits(nodes),
            Self::Dynamics { .. } => true,
        }
    }
}

/// A sheet in motion.
#[derive(Clone, Debug)]
pub(super) struct Stepper<R: Compute> {
    pub(super) kernel: Kernel<R>,
    pub(super) surroundings: Surroundings,
    pub(super) ramp: Ramp,
    pub(super) mover: Mover,
    pub(super) settling: Settling,
    /// What was last read; it has no targets.
    pub(super) state: State,
    guard: Guard,
    /// Where velocities are extrapolated by them.
    pub(super) accelerations: Vec<DVec3>,
    /// The most by which a crease turned in the last evaluation of a relaxation, in radians.
    pub(super) turned: f64,
    /// Evaluations so far.
    pub(super) steps: u64,
}

/// The model, and the state in which the run began: it is handed back where the sheet diverges at once.
pub(super) type Origin<'a> = (&'a Model, &'a State);

/// How long a run goes on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limit {
    /// Evaluations in all.
    pub(super) steps: u64,
    /// Whether all of them are wanted, settled or not.
    pub(super) all: bool,
    /// By how many more evaluations at the final targets, with a triangle crushed than without, it gives up; `None`: it does
    /// not.
    pub(super) crushed: Option<u64>,
    /// For how many evaluations at the final targets it goes on with a crease lost; `None`: as long as it takes.
    pub(super) lost: Option<u64>,
    /// For how many evaluations at the final targets it goes on with no triangle crushed; `None`: as long as it takes.
    pub(super) crawls: Option<u64>,
}

impl<R: Compute> Stepper<R> {
    /// The sheet of `start` with its nodes at `positions` and moving at `velocities`; all at rest where there are none.
    /// `threads` of this thread's pool share the passes.
    pub(super) fn new(
        (model, start): Origin<'_>,
        scene: &Scene,
        (mut positions, velocities): (Vec<DVec3>, &[DVec3]),
        (mover, ramp): (Mover, Ramp),
        tolerance: f64,
        threads: usize,
    ) -> Self {
        scene.place_supports(&mut positions);
        let bounds = Bounds { farthest: FARTHEST, longest_move: LONGEST_MOVE };
        let damped = matches!(mover, Mover::Dynamics { damped: true, .. });
        let mut kernel = Kernel::new(model, damped, bounds, &positions, velocities, &start.fold_angles, threads);
        let mut surroundings = Surroundings::new(model, scene);
        surroundings.install(model, &mut kernel);
        kernel.set_targets(ramp.targets());
        Self {
            kernel,
            surroundings,
            ramp,
            mover,
            settling: Settling::new(model, tolerance),
            state: State { positions, ..State::default() },
            guard: Guard::default(),
            accelerations: Vec::new(),
            turned: 0.0,
            steps: 0,
        }
    }

    /// Runs until it has settled, has made so many evaluations, has a triangle that stays crushed, or `observe` breaks it
    /// off.
    pub(super) fn run(
        &mut self,
        origin: Origin<'_>,
        limit: Limit,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Stop, Diverged> {
        let (mut crushed_for, mut lost_for, mut arrived_for) = (0_u64, 0, 0);
        loop {
            if self.steps >= limit.steps {
                return Ok(if limit.all { Stop::StepsDone } else { Stop::StepLimit });
            }
            if self.step(origin, !limit.all)? {
                return Ok(Stop::Converged);
            }
            // Where the state has just been read.
            if self.ramp.done() && self.steps.is_multiple_of(COPY_EVERY) {
                arrived_for += COPY_EVERY;
                if let Some(patience) = limit.crushed {
                    // It swings about the line, and is thicker than that now and then.
                    let crushed = is_crushed(origin.0, &self.state.positions);
                    crushed_for =
                        if crushed { crushed_for + COPY_EVERY } else { crushed_for.saturating_sub(COPY_EVERY) };
                    if crushed_for >= patience {
                        return Ok(Stop::Crushed);
                    }
                }
                if let Some(patience) = limit.lost {
                    let lost = lost_creases(&self.state.fold_angles, self.ramp.asked()) > 0;
                    lost_for = if lost { lost_for + COPY_EVERY } else { 0 };
                    if lost_for >= patience {
                        return Ok(Stop::StepLimit);
                    }
                }
            }
            if limit.crawls.is_some_and(|patience| arrived_for >= patience && crushed_for == 0) {
                return Ok(Stop::StepLimit);
            }
            if self.steps.is_multiple_of(REPORT) && observe(self.progress()).is_break() {
                return Ok(Stop::Cancelled);
            }
        }
    }

    /// How far it has come.
    pub(super) fn progress(&self) -> Progress {
        Progress { step: self.steps, ramp: self.ramp.share(), distance: self.settling.distance() }
    }

    /// One evaluation, and one move; true where it has settled and so does not move, if it `stops` then.
    pub(super) fn step(&mut self, origin: Origin<'_>, stops: bool) -> Result<bool, Diverged> {
        if !self.ramp.done() && self.turned <= HOLD {
            self.ramp.advance();
            self.kernel.set_targets(self.ramp.targets());
            if self.ramp.done() {
                self.soften(origin.0, None);
            }
        }
        match self.mover {
            Mover::Relax(_) => self.relax(origin, stops),
            Mover::Dynamics { .. } => self.advance_in_time(origin, stops),
        }
    }

    /// Makes the sheet so soft from now on, or as stiff as its material; its motion goes on.
    pub(super) fn soften(&mut self, model: &Model, softening: Option<Softening>) {
        if softening == self.kernel.softening() {
            return;
        }
        self.kernel.soften(model, softening);
        if let Mover::Relax(minimiser) = &mut self.mover {
            minimiser.renew();
        }
    }

    fn relax(&mut self, origin: Origin<'_>, stops: bool) -> Result<bool, Diverged> {
        self.turned = self.forces(false, false);
        self.steps += 1;
        if self.ramp.done() && self.settled() && stops {
            return Ok(true);
        }
        let Self { mover, kernel, state, surroundings, .. } = self;
        let Mover::Relax(minimiser) = mover else { return Ok(false) };
        let in_bounds = minimiser.advance(origin.0, surroundings, kernel, state);
        let step = minimiser.step();
        self.check(origin, in_bounds, step, 0.0)?;
        Ok(false)
    }

    fn advance_in_time(&mut self, origin: Origin<'_>, stops: bool) -> Result<bool, Diverged> {
        let Self { mover, kernel, state, surroundings, .. } = self;
        let Mover::Dynamics { clock, integrator, damped } = mover else { return Ok(false) };
        let dt = clock.step((origin.0, surroundings.forces()), kernel, state, self.steps);
        let (verlet, damped, previous) = (*integrator == Integrator::Verlet, *damped, clock.previous);
        clock.previous = dt;
        // Damping has no part in what tells how far it is to the equilibrium.
        let looks = self.ramp.done() && self.settling.window_ends();
        if looks {
            self.forces(false, false);
        }
        if self.ramp.done() && self.settled() && stops {
            self.set_previous(previous);
            return Ok(true);
        }
        if damped || !looks || !self.surroundings.forces().is_empty() {
            self.forces(damped, true);
        }
        self.steps += 1;
        let in_bounds = if verlet { self.kernel.verlet(dt, previous) } else { self.kernel.euler(dt) };
        self.check(origin, in_bounds, dt, if verlet { 0.5 * dt } else { 0.0 })?;
        Ok(false)
    }

    /// Takes a step back that was not made.
    fn set_previous(&mut self, previous: f64) {
        if let Mover::Dynamics { clock, .. } = &mut self.mover {
            clock.previous = previous;
        }
    }

    /// Forces on all nodes: of the springs, of the damping if `damped`, and from outside; forces of one's own are told the
    /// velocities if the sheet is `moving`, and none where its equilibrium is sought. The result is the most by which a crease
    /// turned, in radians.
    fn forces(&mut self, damped: bool, moving: bool) -> f64 {
        self.surroundings.evaluate(&mut self.kernel, moving);
        self.kernel.springs(damped)
    }

    /// Takes note of an evaluation without damping; true when the state has settled.
    fn settled(&mut self) -> bool {
        self.settling.observe(self.kernel.positions_and_forces())
    }

    /// After a step, which moved every node by about `time_step` times its velocity: an error where the state is out of
    /// bounds, which `in_bounds` says that it surely is not; now and then a copy of the state. Velocities that are
    /// extrapolated (Verlet's) are taken back by the time `ahead` to those that moved the nodes.
    fn check(&mut self, origin: Origin<'_>, in_bounds: bool, time_step: f64, ahead: f64) -> Result<(), Diverged> {
        if in_bounds && !self.steps.is_multiple_of(COPY_EVERY) {
            return Ok(());
        }
        self.read(origin.0);
        if ahead > 0.0 {
            self.kernel.read_accelerations(&mut self.accelerations);
            for (velocity, acceleration) in self.state.velocities.iter_mut().zip(&self.accelerations) {
                *velocity -= *acceleration * ahead;
            }
        }
        self.guard.check(origin, self.steps, &self.state, time_step)
    }

    /// Reads the nodes and creases into `state`.
    pub(super) fn read(&mut self, model: &Model) {
        self.kernel.read_positions(&mut self.state.positions);
        self.kernel.read_velocities(&mut self.state.velocities);
        self.state.fold_angles.resize(model.creases.len(), 0.0);
        self.kernel.read_angles(&mut self.state.fold_angles);
    }

    /// Asks for other angles, over a ramp of so many evaluations, from where the targets are now. The sheet is so soft on the
    /// way, or as soft as it is where it has not arrived yet.
    pub(super) fn set_targets(
        &mut self,
        (model, softening): (&Model, Option<Softening>),
        targets: Vec<f64>,
        length: u32,
    ) {
        let softening = softening.or(self.kernel.softening());
        let now: Vec<f64> = self.ramp.targets().collect();
        self.ramp = Ramp::new(&now, targets, length);
        self.kernel.set_targets(self.ramp.targets());
        self.soften(model, softening.filter(|_| !self.ramp.done()));
        self.settling.disturb();
    }

    /// The time step now, or the step in units of each node's own.
    fn time_step(&self) -> f64 {
        match &self.mover {
            Mover::Relax(minimiser) => minimiser.step(),
            Mover::Dynamics { clock, .. } => clock.dt,
        }
    }

    /// The state that it has come to, measured by the plain forces.
    pub(super) fn into_folded(mut self, model: &Model, scene: &Scene, targets: Targets, stop: Stop) -> Folded {
        // Verlet's velocities are extrapolated by the last step; 0 where there is nothing to take back.
        let half_a_step = match &self.mover {
            Mover::Dynamics { clock, integrator: Integrator::Verlet, .. } if self.steps > 0 => 0.5 * clock.previous,
            _ => 0.0,
        };
        if half_a_step > 0.0 {
            self.kernel.read_accelerations(&mut self.accelerations);
        }
        self.read(model);
        let (steps, time_step, distance) = (self.steps, self.time_step(), self.settling.distance());
        let relaxed = matches!(self.mover, Mover::Relax(_));
        let Self { kernel, surroundings, ramp, mover, settling, state, guard, accelerations, .. } = self;
        let held = surroundings.held().clone();
        // A large sheet's forces need the memory.
        drop((kernel, surroundings, mover, settling, guard));
        let mut state = State { targets: ramp.into_asked(), ..state };
        let mut forces = Forces::holding(model, scene, held.clone());
        let values = forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles);
        let residual = largest(values);
        if relaxed {
            state.velocities.fill(DVec3::ZERO);
        } else if half_a_step > 0.0 {
            arrive(model, &held, &mut state, (&accelerations, values), half_a_step);
        }
        let reactions = forces.reactions().to_vec();
        Folded {
            state,
            targets,
            stop,
            steps,
            time_step,
            residual,
            distance,
            attempts: 1,
            saddles: 0,
            factorisations: 0,
            reactions,
        }
    }
}

/// Ends the last step of [`Integrator::Verlet`], whose velocity is extrapolated to its end by the accelerations `before`.
/// The forces `now` are those without damping.
fn arrive(model: &Model, held: &Held, state: &mut State, (before, now): (&[DVec3], &mut [DVec3]), half_a_step: f64) {
    damping::add(model, &state.velocities, now);
    held.clear(now);
    for ((v, force), before) in state.velocities.iter_mut().zip(now.iter()).zip(before) {
        *v += (*force - *before) * half_a_step;
    }
}
