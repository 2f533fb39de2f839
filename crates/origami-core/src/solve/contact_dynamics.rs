//! The paper's motion of a sheet that cannot go through itself.
//!
//! Nodes have mass 1 and are moved by springs, damping and contact. Contact is far stiffer than the springs once layers press,
//! and begins at once where they meet, so that steps become as short as it asks for, all of the sheet's.

use std::ops::ControlFlow;

use glam::DVec3;

use super::contact_begin::{check_contact, first_layers};
use super::contact_end::{End, farthest, folded, is_held_up};
use super::guard::Guard;
use super::ramp::Ramp;
use super::row_sums::row_sums;
use super::settle::Settling;
use super::surroundings::Surroundings;
use super::threads::{count, share};
use super::{
    Dynamics, Failed, Folded, Integrator, Progress, REPORT, Solver, State, Stop, TimeStep, Touch, Touching, time_step,
    unwatched,
};
use crate::contact::{Contact, Layers};
use crate::forces::damping;
use crate::kernel::{Bounds, Kernel};
use crate::model::{Inventory, Model};
use crate::scene::Scene;
use crate::twins::checkpoint::COPY_EVERY;
use crate::twins::safe_time_step::RENEWAL;
use crate::twins::state_bounds::{FARTHEST, LONGEST_MOVE};

/// Steps are at most so many times the time in which the stiffest node that is pressed swings by one radian. With 1/4, and a tenth
/// of a gap, energy drifts by up to 2 % in ten thousand steps of bounces; so by 0.1 %.
const OF_A_SWING: f64 = 0.06;
/// The share of a gap that layers may lose or gain in one step.
const OF_A_GAP: f64 = 0.025;
/// Of a sheet that is damped, and loses energy anyway, steps are so many times as long.
const DAMPED: f64 = 4.0;

/// [`Dynamics`] of a sheet whose layers push each other away, and through which nothing goes: a state without crossings stays
/// one.
///
/// The settings of `dynamics` count; a step is as long as its rule says where nothing touches, and where layers press or come
/// near to each other so short that energy is kept. A sheet that comes to rest while contact keeps it from its angles ends
/// [`Stop::Blocked`].
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct ContactDynamics {
    /// Time step, integrator, ramp, tolerance, limits and threads.
    pub dynamics: Dynamics,
    /// How paper keeps away from paper.
    pub contact: Contact,
}

impl Solver for ContactDynamics {
    fn fold(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        self.fold_touching(model, start, scene, observe).map(|(folded, _)| folded)
    }

    fn inventory(&self, model: &Model) -> Inventory {
        self.dynamics.inventory(model)
    }
}

/// [`Touch::limited`] counts the steps in which something was stopped that met other layers too hard for contact to brake it:
/// energy is lost in them, and in no others.
impl Touching for ContactDynamics {
    fn fold_touching(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Touch), Failed> {
        share(count(model, self.dynamics.threads), observe, |threads, observe| {
            self.run((model, scene, start), threads, observe, &mut |_, _| {})
        })
    }
}

impl ContactDynamics {
    /// As [`Touching::fold_touching`] on one thread; `look` is shown the positions after every step, with its number.
    ///
    /// # Errors
    /// As that.
    #[doc(hidden)]
    pub fn fold_looking(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        look: &mut dyn FnMut(u64, &[DVec3]),
    ) -> Result<(Folded, Touch), Failed> {
        self.run((model, scene, start), 1, &mut unwatched, look)
    }

    fn run(
        &self,
        (model, scene, start): (&Model, &Scene, &State),
        threads: usize,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
        look: &mut dyn FnMut(u64, &[DVec3]),
    ) -> Result<(Folded, Touch), Failed> {
        let dynamics = &self.dynamics;
        let refused = |refusal| Failed::refused(refusal, start);
        let balanced = || if dynamics.steps.is_none() { scene.check_balance(model) } else { Ok(()) };
        let checked = dynamics.check(model, scene).and_then(|()| balanced());
        checked.and_then(|()| check_contact(self.contact, dynamics.precision, scene)).map_err(refused)?;
        let targets = scene.targets.of(model).map_err(refused)?;
        let mut run = Run::new(self, (model, scene, start), targets, threads)?;
        let stop = run.go(observe, look)?;
        Ok(run.into_folded(stop))
    }
}

/// One motion.
struct Run<'a> {
    dynamics: &'a Dynamics,
    model: &'a Model,
    scene: &'a Scene,
    start: &'a State,
    kernel: Kernel<f64>,
    surroundings: Surroundings,
    ramp: Ramp,
    settling: Settling,
    guard: Guard,
    layers: Layers,
    positions: Vec<DVec3>,
    velocities: Vec<DVec3>,
    moves: Vec<DVec3>,
    /// By node, of all that acts.
    forces: Vec<DVec3>,
    /// By node: row sums of the springs, and of contact.
    springs: Vec<f64>,
    pressed: Vec<f64>,
    /// The shares of a step for which a force acts before the nodes are moved by it, and after.
    kicks: [f64; 2],
    /// The step where nothing touches.
    free: f64,
    /// The last step; 0 at first.
    step: f64,
    steps: u64,
    touch: Touch,
}

impl<'a> Run<'a> {
    fn new(
        solver: &'a ContactDynamics,
        (model, scene, start): (&'a Model, &'a Scene, &'a State),
        targets: Vec<f64>,
        threads: usize,
    ) -> Result<Self, Failed> {
        let dynamics = &solver.dynamics;
        let mut positions = start.positions.clone();
        scene.place_supports(&mut positions);
        let layers = first_layers(model, &positions, solver.contact, threads > 1);
        let layers = layers.map_err(|refusal| Failed::refused(refusal, start))?;
        let ramp = Ramp::new(&start.targets, targets, dynamics.ramp);
        let bounds = Bounds { farthest: FARTHEST, longest_move: LONGEST_MOVE };
        let mut kernel = Kernel::new(model, false, bounds, &positions, &[], &start.fold_angles, threads);
        let mut surroundings = Surroundings::new(model, scene);
        surroundings.install(model, &mut kernel);
        kernel.set_targets(ramp.targets());
        let nodes = model.node_count();
        let mut velocities = start.velocities.clone();
        velocities.resize(nodes, DVec3::ZERO);
        surroundings.held().clear(&mut velocities);
        Ok(Self {
            dynamics,
            model,
            scene,
            start,
            kernel,
            surroundings,
            ramp,
            settling: Settling::new(model, dynamics.tolerance),
            guard: Guard::default(),
            layers,
            positions,
            velocities,
            moves: Vec::new(),
            forces: vec![DVec3::ZERO; nodes],
            springs: vec![0.0; nodes],
            pressed: vec![0.0; nodes],
            kicks: match dynamics.integrator {
                Integrator::Euler => [1.0, 0.0],
                Integrator::Verlet => [0.5, 0.5],
            },
            free: match dynamics.time_step {
                TimeStep::Fixed(step) => step,
                TimeStep::Paper | TimeStep::Safe => time_step::paper(model),
            },
            step: 0.0,
            steps: 0,
            touch: Touch::default(),
        })
    }

    fn go(
        &mut self,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
        look: &mut dyn FnMut(u64, &[DVec3]),
    ) -> Result<Stop, Failed> {
        let (limit, all) = (self.dynamics.steps.unwrap_or(self.dynamics.max_steps), self.dynamics.steps.is_some());
        while self.steps < limit {
            if !self.ramp.done() {
                self.ramp.advance();
                self.kernel.set_targets(self.ramp.targets());
            }
            self.evaluate();
            // Damping has no part in what tells how far it is to the equilibrium.
            if self.ramp.done()
                && self.settling.observe(self.positions.iter().zip(&self.forces).map(|(p, f)| [*p, *f]))
                && !all
            {
                return Ok(if self.is_held_up() { Stop::Blocked } else { Stop::Converged });
            }
            self.damp();
            self.kick(self.kicks[1] * self.step);
            self.advance();
            self.steps += 1;
            look(self.steps, &self.positions);
            if self.steps.is_multiple_of(COPY_EVERY) {
                let state = self.state();
                self.guard.check((self.model, self.start), self.steps, &state, self.step)?;
            }
            let distance = self.settling.distance();
            let progress = Progress { step: self.steps, ramp: self.ramp.share(), distance };
            if self.steps.is_multiple_of(REPORT) && observe(progress).is_break() {
                return Ok(Stop::Cancelled);
            }
        }
        Ok(if all { Stop::StepsDone } else { Stop::StepLimit })
    }

    /// Forces at the present positions, but for those of damping.
    fn evaluate(&mut self) {
        self.kernel.set_positions(&self.positions);
        self.kernel.springs(false);
        if self.steps.is_multiple_of(RENEWAL) {
            row_sums(self.model, &self.positions, &mut self.springs);
        }
        self.layers.measure(&self.positions);
        self.touch.most_pairs = self.touch.most_pairs.max(self.layers.listed());
        self.forces.fill(DVec3::ZERO);
        self.pressed.fill(0.0);
        self.layers.add(&self.positions, &mut self.forces, &mut self.pressed);
        self.surroundings.held().clear(&mut self.forces);
        for (force, [_, springs]) in self.forces.iter_mut().zip(self.kernel.positions_and_forces()) {
            *force += springs;
        }
    }

    fn damp(&mut self) {
        if self.model.material.zeta > 0.0 {
            damping::add(self.model, &self.velocities, &mut self.forces);
            self.surroundings.held().clear(&mut self.forces);
        }
    }

    /// Lets the forces act for so long.
    fn kick(&mut self, time: f64) {
        if time != 0.0 {
            self.velocities.iter_mut().zip(&self.forces).for_each(|(v, f)| *v += *f * time);
        }
    }

    /// One step through time, after forces.
    fn advance(&mut self) {
        let (longest, share) = (self.free_step().min(self.longest_swing()), OF_A_GAP * self.coarser());
        let step = self.layers.longest_step((&self.positions, &self.velocities), share, longest);
        // What is short enough for the velocities before the forces act, and after so long a step, is so for all between.
        let [before, _] = self.kicks;
        self.moves.clear();
        self.moves.extend(self.velocities.iter().zip(&self.forces).map(|(v, f)| *v + *f * (before * step.time)));
        let then = self.layers.longest_step((&self.positions, &self.moves), share, step.time);
        self.step = then.time;
        self.kick(before * self.step);
        self.moves.iter_mut().zip(&self.velocities).for_each(|(by, v)| *by = *v * self.step);
        if step.limited || then.limited {
            self.stop_short();
        }
        let mut longest = 0.0_f64;
        for (p, by) in self.positions.iter_mut().zip(&self.moves) {
            *p += *by;
            longest = longest.max(by.length_squared());
        }
        self.layers.moved(longest.sqrt());
    }

    /// Shortens the moves of what meets too hard for contact to brake it, and takes as much of its velocity.
    fn stop_short(&mut self) {
        let shares = self.layers.limit(&self.positions, &self.moves);
        let mut limited = false;
        for ((by, v), share) in self.moves.iter_mut().zip(&mut self.velocities).zip(shares) {
            (*by, *v) = (*by * *share, *v * *share);
            limited |= *share < 1.0;
        }
        if limited {
            self.touch.limited += 1;
            self.touch.first_limited.get_or_insert(self.ramp.share());
        }
    }

    /// The step where nothing touches.
    fn free_step(&mut self) -> f64 {
        if self.dynamics.time_step == TimeStep::Safe && self.steps.is_multiple_of(RENEWAL) {
            let safe = time_step::safe(self.model, &self.positions, self.dynamics.integrator);
            let previous = (self.steps > 0).then_some(self.free);
            self.free = time_step::renewed(safe, &self.velocities, previous);
        }
        self.free
    }

    fn coarser(&self) -> f64 {
        if self.model.material.zeta > 0.0 { DAMPED } else { 1.0 }
    }

    /// The longest step that nodes which are pressed allow; infinite where none is.
    fn longest_swing(&self) -> f64 {
        let both = self.pressed.iter().zip(&self.springs).filter(|(pressed, _)| **pressed > 0.0);
        OF_A_SWING * self.coarser() / both.map(|(pressed, springs)| pressed + springs).fold(0.0, f64::max).sqrt()
    }

    fn is_held_up(&self) -> bool {
        is_held_up(&self.layers, farthest(&self.angles(), self.ramp.asked()))
    }

    fn angles(&self) -> Vec<f64> {
        let mut angles = vec![0.0; self.model.creases.len()];
        self.kernel.read_angles(&mut angles);
        angles
    }

    /// All that moves, without targets.
    fn state(&self) -> State {
        let (positions, velocities) = (self.positions.clone(), self.velocities.clone());
        State { positions, velocities, fold_angles: self.angles(), targets: Vec::new() }
    }

    /// The state that it has come to, its velocities those at its positions.
    fn into_folded(mut self, stop: Stop) -> (Folded, Touch) {
        self.evaluate();
        if !matches!(stop, Stop::Converged | Stop::Blocked) {
            self.damp();
            self.kick(self.kicks[1] * self.step);
        }
        let mut state = self.state();
        state.targets = self.ramp.into_asked();
        let distance = self.settling.distance();
        let end = End { stop, steps: self.steps, time_step: self.step, distance };
        let (sheet, held) = ((self.model, self.scene), self.surroundings.held());
        folded(sheet, (held, &self.layers), (state, self.touch), end)
    }
}
