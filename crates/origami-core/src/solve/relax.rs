//! Relaxation: the folded state, without the motion that leads to it.

use glam::DVec3;

use super::fire::Fire;
use super::motion::Motion;
use super::perturb::perturb;
use super::ramp::Ramp;
use super::threads::share;
use super::{DEFAULT_MAX_STEPS, DEFAULT_TOLERANCE, Failed, Folded, Precision, Progress, REPORT, Solver, State, Stop};
use crate::kernel::Compute;
use crate::model::{Inventory, Model};

/// The ramp stops while a crease turns by more than this in one evaluation, in radians.
pub const HOLD: f64 = 0.1;
/// The default ramp up to 300 nodes. Half of all sheets are within 1e-4 radii of the equilibrium 80 evaluations after its
/// end, so that it is most of the cost; once tangled sheets are folded again, as many end tangled or higher as with 1000.
const RAMP: f64 = 400.0;
/// The same for a second attempt, which may take its time; the third is a jump, which goes another way altogether.
const SECOND_RAMP: f64 = 3000.0;
/// A second attempt's ramp is longer than the first one's by this at least.
const LONGER_RAMP: u32 = 3;
/// The shortest ramp that is taken by itself.
const SHORTEST_RAMP: u32 = 100;

/// FIRE on row-sum masses while the target angles rise continuously; the default solver.
///
/// A state that ends tangled is folded once more over a longer ramp, then in a jump, and the one of lowest energy is
/// kept. Nothing promises that it is the only equilibrium: folding is path dependent.
#[derive(Clone, Debug, PartialEq)]
pub struct Relax {
    /// Distance from the equilibrium at which it stops, in radii of the sheet. Smaller: more evaluations.
    /// Default 1e-4.
    pub tolerance: f64,
    /// Evaluations over which the target angles rise; 0 is a jump. Longer: fewer tangled states, more evaluations.
    /// Default: [`default_ramp`] from the sheet at rest, its share of that from a state on the way.
    pub ramp: Option<u32>,
    /// Evaluations after which it gives up, all attempts together. Default 100 000.
    pub max_steps: u64,
    /// Run exactly so many evaluations instead, in one attempt. Default: until it has converged.
    pub steps: Option<u64>,
    /// Whether a tangled state is folded again, over a longer ramp and then in a jump. Default true.
    pub retry: bool,
    /// How far each node is moved at the start, as a share of its shortest beam, so that a symmetric sheet does not stay
    /// on the saddle between two ways to buckle; nothing moves where nothing is to be folded. Larger: saddles are left
    /// sooner; 0: none. Default 1e-2: with 3e-3 one sheet in a hundred is said to have settled on a saddle, with 3e-2 more
    /// end higher.
    pub perturbation: f64,
    /// The numbers in which the processor computes: [`Precision::Mixed`] for speed, where a tolerance of 1e-6 or more will
    /// do. GPUs have numbers of their own. Default f64.
    pub precision: Precision,
}

impl Default for Relax {
    fn default() -> Self {
        Self {
            tolerance: DEFAULT_TOLERANCE,
            ramp: None,
            max_steps: DEFAULT_MAX_STEPS,
            steps: None,
            retry: true,
            perturbation: 1e-2,
            precision: Precision::F64,
        }
    }
}

/// The default ramp of a model: 400 evaluations up to 300 nodes, then growing with the square root of the size, since
/// a wave needs that many to cross the sheet.
#[must_use]
pub fn default_ramp(model: &Model) -> u32 {
    grown(RAMP, model)
}

/// The length of a ramp that is `length` up to 300 nodes.
fn grown(length: f64, model: &Model) -> u32 {
    let share = model.node_count() as f64 / 300.0;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 3000 * sqrt(2^32 / 300)")]
    let ramp = (length * share.max(1.0).sqrt()) as u32;
    ramp
}

/// The default ramp from `start`: from a state on the way, its share of the whole, but not so short that it is a jump.
fn ramp_from(model: &Model, start: &State, percent: f64) -> u32 {
    let whole = default_ramp(model);
    if model.creases.iter().zip(&start.targets).all(|(crease, target)| crease.rest_angle == *target) {
        return whole;
    }
    let steps = model.creases.iter().zip(&start.targets).map(|(c, target)| (c.goal * percent / 100.0 - target).abs());
    let goals = model.creases.iter().map(|c| c.goal.abs());
    let share = steps.fold(0.0, f64::max) / goals.fold(0.0, f64::max);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of a u32, saturating")]
    let part = (share * f64::from(whole)) as u32;
    part.clamp(SHORTEST_RAMP.min(whole), whole)
}

/// One way to a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Attempt {
    /// 1 for the first.
    pub number: u32,
    /// Evaluations over which the target angles rise; 0 is a jump.
    pub ramp: u32,
    /// Evaluations after which it ends.
    pub limit: u64,
}

/// The state of lower energy of two that are asked for the same, with the steps of both; `other` came of attempt `number`.
#[must_use]
pub fn lower(model: &Model, kept: Folded, other: Folded, number: u32) -> Folded {
    let steps = kept.steps + other.steps;
    let other_is_lower = other.state.energy(model).total() < kept.state.energy(model).total();
    Folded { steps, attempts: number, ..if other_is_lower { other } else { kept } }
}

impl Solver for Relax {
    fn fold(
        &self,
        model: &Model,
        start: &State,
        percent: f64,
        observe: &mut dyn FnMut(Progress),
    ) -> Result<Folded, Failed> {
        share(model, observe, |threads, observe| match self.precision {
            Precision::F64 => self.attempts::<f64>(model, start, percent, threads, observe),
            Precision::Mixed => self.attempts::<f32>(model, start, percent, threads, observe),
        })
    }

    fn inventory(&self, model: &Model) -> Inventory {
        let mut inventory = model.inventory.clone();
        inventory.without("damping", "a relaxation seeks the equilibrium, which does not depend on it");
        inventory
    }
}

impl Relax {
    /// From the sheet at rest to `percent` of the pattern's fold angles.
    ///
    /// # Errors
    /// [`Failed::Diverged`] where the state stops being finite or grows beyond any sense.
    pub fn fold_from_rest(&self, model: &Model, percent: f64) -> Result<Folded, Failed> {
        self.fold(model, &State::at_rest(model), percent, &mut |_| {})
    }

    /// The first of up to three ways to a state.
    #[must_use]
    pub fn first_attempt(&self, model: &Model, start: &State, percent: f64) -> Attempt {
        let ramp = self.ramp.unwrap_or_else(|| ramp_from(model, start, percent));
        Attempt { number: 1, ramp, limit: self.steps.unwrap_or(self.max_steps) }
    }

    /// The way to be tried after `last`, where the best state so far, `kept`, is tangled: a longer ramp, then a jump.
    #[must_use]
    pub fn next_attempt(&self, model: &Model, start: &State, last: Attempt, kept: &Folded) -> Option<Attempt> {
        let limit = self.steps.unwrap_or(self.max_steps).saturating_sub(kept.steps);
        let wanted = self.retry && self.steps.is_none() && limit > 0;
        if !wanted || kept.state.tangled_creases() == 0 || start.tangled_creases() > 0 {
            return None;
        }
        let ramp = match last.number {
            1 => last.ramp.saturating_mul(LONGER_RAMP).max(grown(SECOND_RAMP, model)),
            2 => 0,
            _ => return None,
        };
        Some(Attempt { number: last.number + 1, ramp, limit })
    }

    /// Where an attempt begins: at rest, and off every symmetry where there is something to be folded.
    #[must_use]
    pub fn beginning(&self, model: &Model, start: &State, percent: f64) -> State {
        State {
            positions: self.first_positions(model, start, percent),
            velocities: vec![DVec3::ZERO; model.node_count()],
            fold_angles: start.fold_angles.clone(),
            targets: start.targets.clone(),
        }
    }

    fn first_positions(&self, model: &Model, start: &State, percent: f64) -> Vec<DVec3> {
        let mut positions = start.positions.clone();
        if self.perturbation > 0.0 && model.targets(percent) != start.targets {
            perturb(model, &mut positions, self.perturbation, 0);
        }
        positions
    }

    fn attempts<R: Compute>(
        &self,
        model: &Model,
        start: &State,
        percent: f64,
        threads: usize,
        observe: &mut dyn FnMut(Progress),
    ) -> Result<Folded, Failed> {
        let mut attempt = self.first_attempt(model, start, percent);
        let mut kept = self.attempt::<R>(model, start, percent, attempt, threads, observe)?;
        while let Some(next) = self.next_attempt(model, start, attempt, &kept) {
            attempt = next;
            let so_far = kept.steps;
            let mut observe = |progress: Progress| observe(Progress { step: so_far + progress.step, ..progress });
            // The state at hand is finite: another way that diverges does not take it away.
            if let Ok(other) = self.attempt::<R>(model, start, percent, attempt, threads, &mut observe) {
                kept = lower(model, kept, other, attempt.number);
            }
        }
        Ok(kept)
    }

    fn attempt<R: Compute>(
        &self,
        model: &Model,
        start: &State,
        percent: f64,
        Attempt { ramp, limit, .. }: Attempt,
        threads: usize,
        observe: &mut dyn FnMut(Progress),
    ) -> Result<Folded, Failed> {
        let mut ramp = Ramp::new(&start.targets, model.targets(percent), ramp);
        let resting = (self.first_positions(model, start, percent), &[][..]);
        let mut motion = Motion::<R>::new(model, start, resting, false, self.tolerance, threads);
        let mut fire = Fire::new(model);
        motion.kernel.set_targets(&ramp.targets);
        let mut turned = 0.0;

        let mut steps = 0;
        let stop = loop {
            if steps >= limit {
                break if self.steps.is_some() { Stop::StepsDone } else { Stop::StepLimit };
            }
            if !ramp.done() && turned <= HOLD {
                ramp.advance();
                motion.kernel.set_targets(&ramp.targets);
            }
            turned = motion.kernel.fold_angles();
            motion.kernel.triangle_forces(false);
            steps += 1;
            if ramp.done() && motion.settled() && self.steps.is_none() {
                break Stop::Converged;
            }
            let holds = fire.advance(&mut motion);
            motion.check(holds, steps, fire.step(), 0.0)?;
            if steps.is_multiple_of(REPORT) {
                observe(Progress { step: steps, ramp: ramp.share(), distance: motion.settling.distance() });
            }
        };

        let (targets, time_step) = (ramp.into_asked(), fire.step());
        drop(fire);
        Ok(motion.into_folded(targets, (percent, stop, steps, time_step), |state, _, _| {
            state.velocities.fill(DVec3::ZERO);
        }))
    }
}
