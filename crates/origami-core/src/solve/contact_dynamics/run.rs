//! One motion under contact.

use std::ops::ControlFlow;

use glam::DVec3;

use super::ContactDynamics;
use crate::contact::Layers;
use crate::forces::damping;
use crate::kernel::{Bounds, Kernel};
use crate::model::Model;
use crate::scene::Scene;
use crate::solve::contact_begin::first_layers;
use crate::solve::contact_end::{End, Touch, folded};
use crate::solve::guard::Guard;
use crate::solve::held_up::is_held_up;
use crate::solve::ramp::Ramp;
use crate::solve::row_sums::row_sums;
use crate::solve::settle::Settling;
use crate::solve::surroundings::Surroundings;
use crate::solve::{Dynamics, Failed, Folded, Integrator, Progress, REPORT, State, Stop, TimeStep, time_step};
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

/// The share of a gap's width that is never used up; more than in relaxation, since steps are as short as layers are pressed hard.
const FLOOR: f64 = 1e-3;

/// One motion.
pub(super) struct Run<'a> {
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
    pub(super) fn new(
        solver: &'a ContactDynamics,
        (model, scene, start): (&'a Model, &'a Scene, &'a State),
        targets: Vec<f64>,
        threads: usize,
    ) -> Result<Self, Failed> {
        let dynamics = &solver.dynamics;
        let mut positions = start.positions.clone();
        scene.place_supports(&mut positions);
        let layers = first_layers(model, &positions, solver.contact, threads > 1);
        let mut layers = layers.map_err(|refusal| Failed::refused(refusal, start))?;
        layers.floor = FLOOR;
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

    pub(super) fn go(
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

    /// Whether it is contact that keeps it from its angles.
    fn is_held_up(&self) -> bool {
        let state = State { targets: self.ramp.asked().to_vec(), ..self.state() };
        is_held_up((self.model, self.scene), &self.layers, &state)
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
    pub(super) fn into_folded(mut self, stop: Stop) -> (Folded, Touch) {
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
