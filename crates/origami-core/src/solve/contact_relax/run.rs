//! One fold under contact, from its first evaluation to the state that it hands back.

use std::ops::ControlFlow;

use glam::DVec3;

use super::super::contact_begin::first_layers;
use super::super::contact_end::{End, Touch, contact_patience, folded};
use super::super::guard::Guard;
use super::super::held_up::is_held_up;
use super::super::ramp::Ramp;
use super::super::relax::ramp_between;
use super::super::settle::Settling;
use super::super::surroundings::Surroundings;
use super::super::{Failed, Folded, Progress, REPORT, State, Stop};
use super::ContactRelax;
use super::masses::Masses;
use crate::contact::Layers;
use crate::kernel::{Bounds, Kernel};
use crate::model::Model;
use crate::scene::Scene;
use crate::twins::checkpoint::COPY_EVERY;
use crate::twins::fire_update::{Fire, HOLD};
use crate::twins::state_bounds::{FARTHEST, LONGEST_MOVE};

/// One fold.
pub(super) struct Run<'a> {
    solver: &'a ContactRelax,
    pub(super) model: &'a Model,
    scene: &'a Scene,
    start: &'a State,
    pub(super) kernel: Kernel<f64>,
    pub(super) surroundings: Surroundings,
    pub(super) ramp: Ramp,
    pub(super) settling: Settling,
    guard: Guard,
    pub(super) layers: Layers,
    pub(super) fire: Fire,
    pub(super) positions: Vec<DVec3>,
    pub(super) velocities: Vec<DVec3>,
    /// By node, of springs and contact.
    pub(super) forces: Vec<DVec3>,
    pub(super) moves: Vec<DVec3>,
    /// By node: row sums of the springs, with their inverses.
    pub(super) springs: Vec<[f64; 2]>,
    /// With those of contact; of no use where nothing is felt of it.
    pub(super) masses: Masses,
    pub(super) felt: bool,
    pub(super) steps: u64,
    /// The evaluation at which the ramp was done.
    arrived: u64,
    pub(super) last_limited: u64,
    pub(super) touch: Touch,
}

impl<'a> Run<'a> {
    pub(super) fn new(
        solver: &'a ContactRelax,
        (model, scene, start): (&'a Model, &'a Scene, &'a State),
        (positions, targets): (Vec<DVec3>, Vec<f64>),
        threads: usize,
    ) -> Result<Self, Failed> {
        let length = solver.relax.ramp.unwrap_or_else(|| ramp_between(model, start.targets.iter().copied(), &targets));
        let ramp = Ramp::new(&start.targets, targets, length);
        let bounds = Bounds { farthest: FARTHEST, longest_move: LONGEST_MOVE };
        let mut kernel = Kernel::new(model, false, bounds, &positions, &[], &start.fold_angles, threads);
        let mut surroundings = Surroundings::new(model, scene);
        surroundings.install(model, &mut kernel);
        kernel.set_targets(ramp.targets());
        let layers = first_layers(model, &positions, solver.contact, threads > 1);
        let layers = layers.map_err(|refusal| Failed::refused(refusal, start))?;
        let nodes = model.node_count();
        Ok(Self {
            solver,
            model,
            scene,
            start,
            kernel,
            surroundings,
            ramp,
            settling: Settling::new(model, solver.relax.tolerance),
            guard: Guard::default(),
            layers,
            fire: Fire::default(),
            positions,
            velocities: vec![DVec3::ZERO; nodes],
            forces: vec![DVec3::ZERO; nodes],
            moves: vec![DVec3::ZERO; nodes],
            springs: vec![[0.0; 2]; nodes],
            masses: Masses::default(),
            felt: false,
            steps: 0,
            arrived: 0,
            last_limited: 0,
            touch: Touch::default(),
        })
    }

    pub(super) fn go(
        &mut self,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
        look: &mut dyn FnMut(u64, &[DVec3]),
    ) -> Result<Stop, Failed> {
        let relax = &self.solver.relax;
        let (limit, all) = (relax.steps.unwrap_or(relax.max_steps), relax.steps.is_some());
        let patience = contact_patience(self.model);
        let mut turned = 0.0;
        while self.steps < limit {
            if !self.ramp.done() && turned <= HOLD {
                self.ramp.advance();
                self.kernel.set_targets(self.ramp.targets());
                self.arrived = self.steps;
            }
            turned = self.evaluate();
            self.steps += 1;
            if self.ramp.done() && self.settled() && !all {
                return Ok(if self.is_held_up() { Stop::Blocked } else { Stop::Converged });
            }
            if !all && self.ramp.done() && self.steps - self.arrived > patience && self.was_limited() {
                return Ok(Stop::Blocked);
            }
            self.advance();
            look(self.steps, &self.positions);
            if self.steps.is_multiple_of(COPY_EVERY) {
                let state = self.state();
                self.guard.check((self.model, self.start), self.steps, &state, self.fire.step)?;
            }
            let distance = self.settling.distance();
            let progress = Progress { step: self.steps, ramp: self.ramp.share(), distance };
            if self.steps.is_multiple_of(REPORT) && observe(progress).is_break() {
                return Ok(Stop::Cancelled);
            }
        }
        Ok(match (all, !all && self.ramp.done() && (self.was_limited() || self.is_held_up())) {
            (true, _) => Stop::StepsDone,
            (false, true) => Stop::Blocked,
            (false, false) => Stop::StepLimit,
        })
    }

    /// Whether a move was shortened lately.
    fn was_limited(&self) -> bool {
        self.touch.limited > 0 && self.steps - self.last_limited <= COPY_EVERY
    }

    /// Whether it is contact that keeps it from its angles.
    fn is_held_up(&self) -> bool {
        let state = State { targets: self.ramp.asked().to_vec(), ..self.state() };
        is_held_up((self.model, self.scene), &self.layers, &state)
    }

    /// All that moves, without targets.
    fn state(&self) -> State {
        let mut fold_angles = vec![0.0; self.model.creases.len()];
        self.kernel.read_angles(&mut fold_angles);
        let (positions, velocities) = (self.positions.clone(), self.velocities.clone());
        State { positions, velocities, fold_angles, targets: Vec::new() }
    }

    /// The state that it has come to, measured by the plain forces and those of contact.
    pub(super) fn into_folded(mut self, stop: Stop) -> (Folded, Touch) {
        self.kernel.set_positions(&self.positions);
        self.kernel.springs(false);
        self.layers.measure(&self.positions);
        let mut state = self.state();
        state.targets = self.ramp.into_asked();
        state.velocities.fill(DVec3::ZERO);
        let distance = self.settling.distance();
        let end = End { stop, steps: self.steps, time_step: self.fire.step, distance };
        let (sheet, held) = ((self.model, self.scene), self.surroundings.held());
        folded(sheet, (held, &self.layers), (state, self.touch), end)
    }
}
