//! Relaxation of a sheet that cannot go through itself.
//!
//! The springs are the kernel's. Contact is added after them, and so the nodes are moved here: its forces and masses change
//! from one evaluation to the next, and moves are shortened before they are made.

use std::ops::ControlFlow;

use glam::DVec3;

use super::guard::Guard;
use super::largest::largest;
use super::ramp::Ramp;
use super::relax::{default_ramp, ramp_between};
use super::row_sums::row_sums;
use super::settle::Settling;
use super::surroundings::Surroundings;
use super::threads::{count, share};
use super::touch::{Touch, is_held_up};
use super::{Failed, Folded, Precision, Progress, REPORT, Relax, Solver, State, Stop, unwatched};
use crate::contact::{Contact, Crossings, Layers};
use crate::forces::Forces;
use crate::kernel::{Bounds, Kernel};
use crate::model::{Inventory, Model};
use crate::scene::{Refusal, Scene};
use crate::twins::checkpoint::COPY_EVERY;
use crate::twins::fire_update::{Decision, Fire, HOLD, RENEWAL, Sums, fire_update};
use crate::twins::state_bounds::{FARTHEST, LONGEST_MOVE};

/// Ramps for which it goes on at the final targets while contact holds it up.
const PATIENCE: u64 = 10;

/// [`Relax`] of a sheet whose layers push each other away, and through which nothing goes: a state without crossings stays one.
///
/// The settings of `relax` count, but for these: the sheet is as stiff as its material all the way, is folded once, and no
/// saddle is sought. A sheet that contact keeps from its angles ends [`Stop::Blocked`], which is a result.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct ContactRelax {
    /// Ramp, tolerance, limits, perturbation and threads.
    pub relax: Relax,
    /// How paper keeps away from paper.
    pub contact: Contact,
}

impl Solver for ContactRelax {
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
        self.relax.inventory(model)
    }
}

impl ContactRelax {
    /// As [`Solver::fold`], and what contact did.
    ///
    /// # Errors
    /// As [`Solver::fold`]; [`Failed::Refused`] too where the sheet begins crossed or closed, and for settings that are no
    /// lengths or stiffnesses above 0.
    pub fn fold_touching(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Touch), Failed> {
        share(count(model, self.relax.threads), observe, |threads, observe| {
            self.run((model, scene, start), threads, observe, &mut |_, _| {})
        })
    }

    /// The same on one thread; `look` is shown the positions after every evaluation's move, with its number.
    ///
    /// # Errors
    /// As [`ContactRelax::fold_touching`].
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
        let refused = |refusal| Failed::refused(refusal, start);
        self.relax.check(model, scene).map_err(refused)?;
        check_contact(self.contact, self.relax.precision, scene).map_err(refused)?;
        let targets = scene.targets.of(model).map_err(refused)?;
        let positions = self.relax.first_positions(model, start, scene, &targets);
        let mut run = Run::new(self, (model, scene, start), (positions, targets), threads)?;
        let stop = run.go(observe, look)?;
        Ok(run.into_folded(stop))
    }
}

/// Whether a sheet can be folded so in a scene, in numbers of that precision.
pub(super) fn check_contact(contact: Contact, precision: Precision, scene: &Scene) -> Result<(), Refusal> {
    let Contact { gap, stiffness, thickness } = contact;
    for (what, value) in [("gap", gap), ("stiffness", stiffness)] {
        if !(value.is_finite() && value > 0.0) {
            return Err(Refusal::Contact { what, value });
        }
    }
    if !(thickness.is_finite() && thickness >= 0.0) {
        return Err(Refusal::Contact { what: "thickness", value: thickness });
    }
    if precision != Precision::F64 {
        return Err(Refusal::Unsupported { what: "numbers of mixed precision", backend: "contact", expected: "f64" });
    }
    if scene.forces.is_empty() {
        Ok(())
    } else {
        let expected = "a scene without forces of one's own";
        Err(Refusal::Unsupported { what: "forces", backend: "contact", expected })
    }
}

/// The layers of a sheet that begins at `positions`, measured there; `shared` as for [`Layers::new`]. Refused where it begins
/// crossed or closed.
pub(super) fn first_layers(
    model: &Model,
    positions: &[DVec3],
    contact: Contact,
    shared: bool,
) -> Result<Layers, Refusal> {
    let crossings = Crossings::of(&model.mesh, positions);
    if let Some([one, other]) = crossings.faces.first() {
        return Err(Refusal::Crossed { faces: [*one, *other] });
    }
    let mut layers = Layers::new(&model.mesh, &model.rest, contact, shared);
    layers.measure(positions);
    if layers.least_gap() <= 0.0 {
        return Err(Refusal::Closed { gap: layers.least_gap() });
    }
    Ok(layers)
}

/// One fold.
struct Run<'a> {
    solver: &'a ContactRelax,
    model: &'a Model,
    scene: &'a Scene,
    start: &'a State,
    kernel: Kernel<f64>,
    surroundings: Surroundings,
    ramp: Ramp,
    settling: Settling,
    guard: Guard,
    layers: Layers,
    fire: Fire,
    positions: Vec<DVec3>,
    velocities: Vec<DVec3>,
    /// By node, of springs and contact.
    forces: Vec<DVec3>,
    moves: Vec<DVec3>,
    /// By node: row sums of the springs, and of the contact too.
    springs: Vec<f64>,
    masses: Vec<f64>,
    steps: u64,
    /// The evaluation at which the ramp was done.
    arrived: u64,
    last_limited: u64,
    touch: Touch,
}

impl<'a> Run<'a> {
    fn new(
        solver: &'a ContactRelax,
        (model, scene, start): (&'a Model, &'a Scene, &'a State),
        (positions, targets): (Vec<DVec3>, Vec<f64>),
        threads: usize,
    ) -> Result<Self, Failed> {
        let refused = |refusal| Failed::refused(refusal, start);
        let length = solver.relax.ramp.unwrap_or_else(|| ramp_between(model, start.targets.iter().copied(), &targets));
        let ramp = Ramp::new(&start.targets, targets, length);
        let bounds = Bounds { farthest: FARTHEST, longest_move: LONGEST_MOVE };
        let mut kernel = Kernel::new(model, false, bounds, &positions, &[], &start.fold_angles, threads);
        let mut surroundings = Surroundings::new(model, scene);
        surroundings.install(model, &mut kernel);
        kernel.set_targets(ramp.targets());
        let layers = first_layers(model, &positions, solver.contact, threads > 1).map_err(refused)?;
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
            springs: vec![0.0; nodes],
            masses: vec![0.0; nodes],
            steps: 0,
            arrived: 0,
            last_limited: 0,
            touch: Touch::default(),
        })
    }

    fn go(
        &mut self,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
        look: &mut dyn FnMut(u64, &[DVec3]),
    ) -> Result<Stop, Failed> {
        let relax = &self.solver.relax;
        let (limit, all) = (relax.steps.unwrap_or(relax.max_steps), relax.steps.is_some());
        let patience = PATIENCE * u64::from(default_ramp(self.model));
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
        Ok(match (all, self.ramp.done() && (self.was_limited() || self.is_held_up())) {
            (true, _) => Stop::StepsDone,
            (false, true) => Stop::Blocked,
            (false, false) => Stop::StepLimit,
        })
    }

    /// Forces and masses at the present positions; the result is the most by which a crease turned, in radians.
    fn evaluate(&mut self) -> f64 {
        self.kernel.set_positions(&self.positions);
        let turned = self.kernel.springs(false);
        if self.steps.is_multiple_of(RENEWAL) {
            row_sums(self.model, &self.positions, &mut self.springs);
        }
        self.layers.measure(&self.positions);
        self.touch.most_pairs = self.touch.most_pairs.max(self.layers.listed());
        self.masses.copy_from_slice(&self.springs);
        self.forces.fill(DVec3::ZERO);
        self.layers.add(&self.positions, &mut self.forces, &mut self.masses);
        self.surroundings.held().clear(&mut self.forces);
        for (force, [_, springs]) in self.forces.iter_mut().zip(self.kernel.positions_and_forces()) {
            *force += springs;
        }
        turned
    }

    /// Takes note of an evaluation; true when the state has settled. What contact has just held up has not.
    fn settled(&mut self) -> bool {
        if self.touch.limited > 0 && self.last_limited + 1 == self.steps {
            self.settling.disturb();
        }
        self.settling.observe(self.positions.iter().zip(&self.forces).map(|(p, f)| [*p, *f]))
    }

    /// One move by FIRE, shortened where something is in the way.
    fn advance(&mut self) {
        let mut sums = Sums::default();
        for ((force, velocity), mass) in self.forces.iter().zip(&self.velocities).zip(&self.masses) {
            sums.power += force.dot(*velocity);
            sums.speed += mass * velocity.length_squared();
            sums.pull += force.length_squared() / mass;
        }
        let Decision { step, keep, towards_force, back } = fire_update(&mut self.fire, sums);
        let longest = self.layers.longest_move();
        for (((by, velocity), force), mass) in
            self.moves.iter_mut().zip(&mut self.velocities).zip(&self.forces).zip(&self.masses)
        {
            let old = *velocity;
            *velocity = keep * old + (towards_force / mass) * *force;
            *by = step * *velocity + back * old;
            let length = by.length();
            if length > longest {
                *by *= longest / length;
                *velocity *= longest / length;
            }
        }
        let shares = self.layers.limit(&self.positions, &self.moves);
        let (mut largest, mut limited) = (0.0_f64, false);
        for (((p, by), velocity), share) in
            self.positions.iter_mut().zip(&mut self.moves).zip(&mut self.velocities).zip(shares)
        {
            if *share < 1.0 {
                limited = true;
                *by *= *share;
                *velocity *= *share;
            }
            *p += *by;
            largest = largest.max(by.length_squared());
        }
        self.layers.moved(largest.sqrt());
        if limited {
            self.touch.limited += 1;
            self.last_limited = self.steps;
            self.touch.first_limited.get_or_insert(self.ramp.share());
        }
    }

    /// Whether a move was shortened lately.
    fn was_limited(&self) -> bool {
        self.touch.limited > 0 && self.steps - self.last_limited <= COPY_EVERY
    }

    fn is_held_up(&self) -> bool {
        let mut angles = vec![0.0; self.model.creases.len()];
        self.kernel.read_angles(&mut angles);
        is_held_up(&self.layers, &angles, self.ramp.asked())
    }

    /// All that moves, without targets.
    fn state(&self) -> State {
        let mut fold_angles = vec![0.0; self.model.creases.len()];
        self.kernel.read_angles(&mut fold_angles);
        let (positions, velocities) = (self.positions.clone(), self.velocities.clone());
        State { positions, velocities, fold_angles, targets: Vec::new() }
    }

    /// The state that it has come to, measured by the plain forces and those of contact.
    fn into_folded(mut self, stop: Stop) -> (Folded, Touch) {
        self.kernel.set_positions(&self.positions);
        self.kernel.springs(false);
        self.layers.measure(&self.positions);
        let mut state = self.state();
        state.velocities.fill(DVec3::ZERO);
        state.targets = self.ramp.into_asked();
        let touch = self.touch.at_end(self.model, &self.layers, &state);
        let held = self.surroundings.held().clone();
        let mut forces = Forces::holding(self.model, self.scene, held.clone());
        let mut all = forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles).to_vec();
        let mut of_contact = vec![DVec3::ZERO; all.len()];
        self.layers.add(&state.positions, &mut of_contact, &mut self.masses);
        held.clear(&mut of_contact);
        all.iter_mut().zip(&of_contact).for_each(|(all, own)| *all += *own);
        let folded = Folded {
            targets: self.scene.targets.clone(),
            stop,
            steps: self.steps,
            time_step: self.fire.step,
            residual: largest(&all),
            distance: self.settling.distance(),
            attempts: 1,
            factorisations: 0,
            saddles: 0,
            reactions: forces.reactions().to_vec(),
            state,
        };
        (folded, touch)
    }
}
