//! Relaxation: the folded state, without the motion that leads to it.

use std::num::NonZeroUsize;
use std::ops::ControlFlow;

use glam::DVec3;

use super::attempt::{Attempt, better, or_crushed, steps_of};
use super::crushed::is_crushed;
use super::fire::Minimiser;
use super::perturb::perturb;
use super::ramp::Ramp;
use super::saddle::leave;
use super::stepper::{Limit, Mover, Stepper};
use super::threads::{count, share};
use super::{DEFAULT_MAX_STEPS, DEFAULT_TOLERANCE, Failed, Folded, Precision, Progress, Session, Solver, State, Stop};
use crate::kernel::Compute;
use crate::model::{Inventory, Model};
use crate::scene::{Held, Needs, Refusal, Scene};

/// The default ramp up to 300 nodes. Half of all sheets are within 1e-4 radii of the equilibrium 80 evaluations after its
/// end, so that it is most of the cost; once tangled sheets are folded again, as many end tangled or higher as with 1000.
const RAMP: f64 = 400.0;
/// The same for a second attempt, which may take its time; the third is a jump, which goes another way altogether.
const SECOND_RAMP: f64 = 3000.0;
/// A second attempt's ramp is longer than the first one's by this at least.
const LONGER_RAMP: u32 = 3;
/// Ramps for which an attempt goes on at the final targets with a triangle crushed: one may open again.
const CRUSHED_RAMPS: u64 = 10;
/// The shortest ramp that is taken by itself.
const SHORTEST_RAMP: u32 = 100;

/// FIRE on row-sum masses while the target angles rise continuously; the default solver.
///
/// A state that ends tangled is folded once more over a longer ramp, then in a jump, and the one of lowest energy is
/// kept. So is one with a triangle crushed to a line, or out of bounds: once without the perturbation, then in a jump; one
/// without a crushed triangle is kept before one with, whatever their energies. Nothing promises that it is the only
/// equilibrium: folding is path dependent.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
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
    /// Whether a state that is tangled, has a triangle crushed or left all bounds is folded again in other ways. Default
    /// true.
    pub retry: bool,
    /// How far each node is moved at the start, as a share of its shortest beam, so that a symmetric sheet does not stay
    /// on the saddle between two ways to buckle; nothing moves where nothing is to be folded. Larger: saddles are left
    /// sooner; 0: none. Default 1e-2: with 3e-3 one sheet in a hundred is said to have settled on a saddle, with 3e-2 more
    /// end higher.
    pub perturbation: f64,
    /// How much may go into the search for a way down once the sheet has settled: products with the Hessian as a share of
    /// the evaluations so far. Larger: flatter saddles are found; 0: none is sought. GPUs seek none. Default 0.1.
    pub saddle_search: f64,
    /// The numbers in which the processor computes: [`Precision::Mixed`] for speed, where a tolerance of 1e-6 or more will
    /// do. GPUs have numbers of their own. Default f64.
    pub precision: Precision,
    /// Threads that share the steps of a large sheet; more than the pool has gain nothing. Default: as many as the pool
    /// has, and one on a thread of a pool; of small sheets one.
    pub threads: Option<NonZeroUsize>,
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
            saddle_search: 0.1,
            precision: Precision::F64,
            threads: None,
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

/// The default ramp between two lists of targets: from those on the way, its share of the whole, but not so short that it is
/// a jump.
pub(super) fn ramp_between(model: &Model, from: impl Iterator<Item = f64> + Clone, to: &[f64]) -> u32 {
    let whole = default_ramp(model);
    if model.creases.iter().zip(from.clone()).all(|(crease, target)| crease.rest_angle == target) {
        return whole;
    }
    let steps = to.iter().zip(from).map(|(to, from)| (to - from).abs());
    let full_targets = model.creases.iter().map(|c| c.full_target.abs());
    let share = steps.fold(0.0, f64::max) / full_targets.fold(0.0, f64::max);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of a u32, saturating")]
    let part = (share * f64::from(whole)) as u32;
    part.clamp(SHORTEST_RAMP.min(whole), whole)
}

impl Solver for Relax {
    fn fold(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        self.check(model, scene).map_err(|refusal| Failed::refused(refusal, start))?;
        let run = Run { relax: self, model, start, scene };
        share(count(model, self.threads), observe, |threads, observe| match self.precision {
            Precision::F64 => run.to_a_minimum::<f64>(threads, observe),
            Precision::Mixed => run.to_a_minimum::<f32>(threads, observe),
        })
    }

    fn session<'a>(&'a self, model: &'a Model) -> Box<dyn Session + 'a> {
        Box::new(Once { relax: self.clone(), model })
    }

    fn inventory(&self, model: &Model) -> Inventory {
        let mut inventory = model.inventory.clone();
        inventory.without("damping", "a relaxation seeks the equilibrium, which does not depend on it");
        inventory
    }
}

/// Perturbs the sheet once, not at each fold.
struct Once<'a> {
    relax: Relax,
    model: &'a Model,
}

impl Session for Once<'_> {
    fn fold(
        &mut self,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        let folded = self.relax.fold(self.model, start, scene, observe)?;
        if start.targets != folded.state.targets {
            self.relax.perturbation = 0.0;
        }
        Ok(folded)
    }
}

impl Relax {
    /// Whether this can run the scene.
    pub(super) fn check(&self, model: &Model, scene: &Scene) -> Result<(), Refusal> {
        scene.check(model)?;
        scene.check_balance(model)?;
        scene.check_forces(
            model,
            &[Needs::RowSums],
            "relax",
            "`Dynamics` with the paper's or a fixed time step does without",
        )?;
        if self.retries() {
            let instead = "without `retry` it does without";
            scene.check_forces(model, &[Needs::Energy], "relax, which compares attempts,", instead)?;
        }
        Ok(())
    }

    /// Whether more than one way is tried.
    #[doc(hidden)]
    #[must_use]
    pub fn retries(&self) -> bool {
        self.retry && self.steps.is_none()
    }

    /// The settings with which an attempt begins.
    #[doc(hidden)]
    #[must_use]
    pub fn of_attempt(&self, attempt: Attempt) -> Self {
        Self { perturbation: if attempt.perturbed { self.perturbation } else { 0.0 }, ..self.clone() }
    }

    /// The first of up to three ways to a state.
    #[doc(hidden)]
    #[must_use]
    pub fn first_attempt(&self, model: &Model, start: &State, targets: &[f64]) -> Attempt {
        let ramp = self.ramp.unwrap_or_else(|| ramp_between(model, start.targets.iter().copied(), targets));
        Attempt { number: 1, ramp, limit: self.steps.unwrap_or(self.max_steps), perturbed: true }
    }

    /// The way to be tried after `last`, where the best state so far, `kept`, is tangled: a longer ramp, then a jump. Where it
    /// has a triangle crushed or there is none, since the sheet left all bounds: without the perturbation, then a jump.
    #[doc(hidden)]
    #[must_use]
    pub fn next_attempt(
        &self,
        model: &Model,
        start: &State,
        last: Attempt,
        kept: &Result<Folded, Failed>,
    ) -> Option<Attempt> {
        let limit = self.steps.unwrap_or(self.max_steps).saturating_sub(steps_of(kept));
        if !self.retries() || limit == 0 {
            return None;
        }
        let tangled = match kept {
            Ok(kept) if kept.stop == Stop::Cancelled => return None,
            Ok(kept) if kept.state.tangled_creases() > 0 => true,
            Ok(kept) if is_crushed(model, &kept.state.positions) => false,
            Err(Failed::Diverged(_)) => false,
            _ => return None,
        };
        let began_so = if tangled { start.tangled_creases() > 0 } else { is_crushed(model, &start.positions) };
        if began_so {
            return None;
        }
        let longer = last.ramp.saturating_mul(LONGER_RAMP).max(grown(SECOND_RAMP, model));
        let (ramp, perturbed) = match last.number {
            1 if tangled || self.perturbation == 0.0 => (longer, true),
            1 => (last.ramp, false),
            2 => (0, true),
            _ => return None,
        };
        Some(Attempt { number: last.number + 1, ramp, limit, perturbed })
    }

    /// Where an attempt begins: at rest, and off every symmetry where there is something to be folded.
    #[doc(hidden)]
    #[must_use]
    pub fn beginning(&self, model: &Model, start: &State, scene: &Scene, targets: &[f64]) -> State {
        State {
            positions: self.first_positions(model, start, scene, targets),
            velocities: vec![DVec3::ZERO; model.node_count()],
            fold_angles: start.fold_angles.clone(),
            targets: start.targets.clone(),
        }
    }

    /// Where the nodes of an attempt begin.
    pub(super) fn first_positions(&self, model: &Model, start: &State, scene: &Scene, targets: &[f64]) -> Vec<DVec3> {
        let mut positions = start.positions.clone();
        if self.perturbation > 0.0 && (targets != start.targets || !scene.has_springs_only()) {
            perturb(model, &Held::new(model, scene), &mut positions, self.perturbation, 0);
        }
        scene.place_supports(&mut positions);
        positions
    }

    /// A sheet that relaxes as this says, from `start` with its nodes at `positions`.
    pub(super) fn stepper<R: Compute>(
        &self,
        (model, start): (&Model, &State),
        positions: Vec<DVec3>,
        (scene, targets, ramp): (&Scene, Vec<f64>, u32),
        threads: usize,
    ) -> Stepper<R> {
        let ramp = Ramp::new(&start.targets, targets, ramp);
        let mover = Mover::Relax(Minimiser::new(model));
        Stepper::new((model, start), scene, (positions, &[]), (mover, ramp), self.tolerance, threads)
    }
}

/// One fold.
struct Run<'a> {
    relax: &'a Relax,
    model: &'a Model,
    start: &'a State,
    scene: &'a Scene,
}

impl Run<'_> {
    /// Found anew for each attempt: of a large sheet they need much memory.
    fn targets(&self) -> Result<Vec<f64>, Failed> {
        self.scene.targets.of(self.model).map_err(|refusal| Failed::refused(refusal, self.start))
    }

    /// Settles, and leaves the saddles that it settles on.
    fn to_a_minimum<R: Compute>(
        &self,
        threads: usize,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        let Self { relax, model, scene, .. } = *self;
        let folded = self.attempts::<R>(threads, observe)?;
        let share = if relax.steps.is_some() { 0.0 } else { relax.saddle_search };
        let again = &mut |off: &State, limit, so_far| {
            let mut observe = |progress: Progress| observe(Progress { step: so_far + progress.step, ..progress });
            let attempt = Attempt { number: 1, ramp: 0, limit, perturbed: false };
            Run { start: off, ..*self }.attempt::<R>(attempt, threads, &mut observe)
        };
        Ok(leave((model, scene), folded, (share, relax.max_steps), again))
    }

    fn attempts<R: Compute>(
        &self,
        threads: usize,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        let Self { relax, model, start, scene } = *self;
        let mut attempt = relax.first_attempt(model, start, &self.targets()?);
        let mut kept = self.attempt::<R>(attempt, threads, observe);
        while let Some(next) = relax.next_attempt(model, start, attempt, &kept) {
            attempt = next;
            let so_far = steps_of(&kept);
            let mut observe = |progress: Progress| observe(Progress { step: so_far + progress.step, ..progress });
            let other = self.attempt::<R>(attempt, threads, &mut observe);
            let cancelled = other.as_ref().is_ok_and(|other| other.stop == Stop::Cancelled);
            kept = better((model, scene), kept, other, attempt.number);
            if cancelled {
                return kept.map(|kept| Folded { stop: Stop::Cancelled, ..kept });
            }
        }
        if relax.retries() { or_crushed((model, scene), kept, attempt.number) } else { kept }
    }

    fn attempt<R: Compute>(
        &self,
        attempt: Attempt,
        threads: usize,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        let Self { relax, model, start, scene } = *self;
        let targets = self.targets()?;
        let positions = relax.of_attempt(attempt).first_positions(model, start, scene, &targets);
        let mut stepper = relax.stepper::<R>((model, start), positions, (scene, targets, attempt.ramp), threads);
        let crushed = relax.steps.is_none().then(|| CRUSHED_RAMPS * u64::from(default_ramp(model)));
        let limit = Limit { steps: attempt.limit, all: relax.steps.is_some(), crushed };
        let stop = stepper.run((model, start), limit, observe)?;
        Ok(stepper.into_folded(model, scene, scene.targets.clone(), stop))
    }
}
