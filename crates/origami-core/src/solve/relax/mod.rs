//! Relaxation: the folded state, without the motion that leads to it.

mod run;

use std::num::NonZeroUsize;
use std::ops::ControlFlow;

use glam::DVec3;

use super::attempt::{Attempt, steps_of};
use super::crushed::is_crushed;
use super::fire::Minimiser;
use super::perturb::perturb;
use super::ramp::Ramp;
use super::state::is_flat;
use super::stepper::{Mover, Stepper};
use super::threads::{count, share};
use super::{DEFAULT_MAX_STEPS, DEFAULT_TOLERANCE, Failed, Folded, Precision, Progress, Session, Solver, State, Stop};
use crate::kernel::Compute;
use crate::model::{Inventory, Model, Softening};
use crate::scene::{Held, Needs, Refusal, Scene};
use run::Run;

/// The default ramp of a soft sheet of 300 nodes: with half of it more creases fold to the wrong side.
const SOFT_RAMP: f64 = 800.0;
/// The ramp of a sheet as stiff as its material up to 300 nodes, and the shortest of a soft one. Half of all sheets are within
/// 1e-4 radii of the equilibrium 80 evaluations after its end, so that it is most of the cost.
const STIFF_RAMP: f64 = 400.0;
/// The same for an attempt that may take its time.
const LONG_RAMP: f64 = 3000.0;
/// A longer ramp is longer than the one before by this at least.
const LONGER_RAMP: u32 = 3;
/// The shortest ramp that is taken by itself.
const SHORTEST_RAMP: u32 = 100;

/// FIRE on row-sum masses while the target angles rise continuously; the default solver.
///
/// On the way the sheet is softer than its material ([`Relax::softening`]). A state with creases that went astray
/// ([`State::lost_creases`]) is folded once more as stiff as it is, then softly over a longer ramp, and the one of lowest
/// energy is kept. So is one with a triangle crushed to a line, or out of bounds: once without the perturbation, then in a
/// jump; one without a crushed triangle is kept before one with, whatever their energies. Nothing promises that it is the
/// only equilibrium: folding is path dependent.
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
    /// Whether a state that has lost a crease, has a triangle crushed or left all bounds is folded again in other ways. Default
    /// true.
    pub retry: bool,
    /// How far each node is moved at the start, as a share of its shortest beam, so that a symmetric sheet does not stay
    /// on the saddle between two ways to buckle; nothing moves where nothing is to be folded. Larger: saddles are left
    /// sooner; 0: none. Default 1e-2: with 3e-3 one sheet in a hundred is said to have settled on a saddle, with 3e-2 more
    /// end higher.
    pub perturbation: f64,
    /// How much may go into the search for a way down once the sheet has settled: products with the Hessian as a share of
    /// the evaluations so far. Larger: flatter saddles are found; 0: none is sought. Not of sheets without strain, which have
    /// none, nor of more than 10 000 nodes, nor on GPUs. Default 0.1.
    pub saddle_search: f64,
    /// How much softer than its material the sheet of a pattern that is folded flat is while the target angles rise from rest.
    /// A jump and a way that begins elsewhere are not softened, nor is a sheet under loads or forces of one's own. `None`: as
    /// stiff as its material all the way. Default: [`Softening::default`].
    pub softening: Option<Softening>,
    /// Of patterns that are folded flat sides shorter than this share of their mean join their ends to a cluster, which has a
    /// mass of its own for what it does as one; the sheet need not drag along what a short side makes heavy. Larger: more
    /// nodes are in clusters; 0: none. GPUs have none. Default 0.4.
    pub near: f64,
    /// After how many evaluations at the final targets, in default ramps, Newton's method takes over (feature `newton`; not
    /// while a triangle is crushed, nor of more than 20 000 nodes): a sheet that takes longer crawls. Its claim is checked as
    /// any other. Smaller: earlier; `None`: never. GPUs do not hand over. Default 4.
    pub hand_over: Option<u32>,
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
            softening: Some(Softening::default()),
            near: 0.4,
            hand_over: Some(4),
            precision: Precision::F64,
            threads: None,
        }
    }
}

/// The default ramp of a model from rest: 400 evaluations up to 300 nodes, then growing with the square root of the size, since
/// a wave needs that many to cross the sheet. Of patterns that are folded flat, whose sheets are soft on the way, twice as
/// many where that is more than 400.
#[must_use]
pub fn default_ramp(model: &Model) -> u32 {
    let stiff = grown(STIFF_RAMP, model, 1.0);
    if folds_flat(model) { grown(SOFT_RAMP, model, 0.0).max(stiff) } else { stiff }
}

/// Whether most of the creases that fold at all are folded flat at 100 %.
fn folds_flat(model: &Model) -> bool {
    let folds = || model.creases.iter().map(|crease| crease.full_target).filter(|target| *target != 0.0);
    2 * folds().filter(|target| is_flat(*target)).count() > folds().count()
}

/// A ramp that is `length` for 300 nodes, of sheets that have so many or `least` of them at least.
fn grown(length: f64, model: &Model, least: f64) -> u32 {
    let share = model.node_count() as f64 / 300.0;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 3000 * sqrt(2^32 / 300)")]
    let ramp = (length * share.max(least).sqrt()) as u32;
    ramp
}

/// The default ramp between two lists of targets: from those on the way, its share of the whole, but not so short that it is
/// a jump.
pub(super) fn ramp_between(model: &Model, from: impl Iterator<Item = f64> + Clone, to: &[f64]) -> u32 {
    if is_rest(model, from.clone()) {
        return default_ramp(model);
    }
    let whole = grown(STIFF_RAMP, model, 1.0);
    let steps = to.iter().zip(from).map(|(to, from)| (to - from).abs());
    let full_targets = model.creases.iter().map(|c| c.full_target.abs());
    let share = steps.fold(0.0, f64::max) / full_targets.fold(0.0, f64::max);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of a u32, saturating")]
    let part = (share * f64::from(whole)) as u32;
    part.clamp(SHORTEST_RAMP.min(whole), whole)
}

/// How soft a sheet is on its way from these targets to those of a scene. A load that the sheet bears may tear a soft one, and
/// where creases shall not lie flat soft beams lead to higher states as often as to lower ones.
pub(super) fn softening_between(
    softening: Option<Softening>,
    (model, scene): (&Model, &Scene),
    from: impl Iterator<Item = f64>,
) -> Option<Softening> {
    softening.filter(|_| {
        scene.has_springs_only() && model.stiffest_crease > 0.0 && folds_flat(model) && is_rest(model, from)
    })
}

/// Whether these targets are the angles at rest.
fn is_rest(model: &Model, targets: impl Iterator<Item = f64>) -> bool {
    model.creases.iter().zip(targets).all(|(crease, target)| crease.rest_angle == target)
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
    pub fn first_attempt(&self, (model, scene): (&Model, &Scene), start: &State, targets: &[f64]) -> Attempt {
        let from = start.targets.iter().copied();
        let softening = softening_between(self.softening, (model, scene), from.clone());
        let ramp = self.ramp.unwrap_or_else(|| ramp_between(model, from, targets));
        Attempt { number: 1, ramp, limit: self.steps.unwrap_or(self.max_steps), perturbed: true, softening }
    }

    /// The way to be tried after `last`, where the best state so far, `kept`, has lost creases: without softening, then softly
    /// over a longer ramp; of a sheet that is not softened a longer ramp, then a jump. Where it has a triangle crushed or there
    /// is none, since the sheet left all bounds: without the perturbation, then a jump.
    #[doc(hidden)]
    #[must_use]
    pub fn next_attempt(
        &self,
        (model, scene): (&Model, &Scene),
        start: &State,
        last: Attempt,
        kept: &Result<Folded, Failed>,
    ) -> Option<Attempt> {
        let limit = self.steps.unwrap_or(self.max_steps).saturating_sub(steps_of(kept));
        if !self.retries() || limit == 0 || last.number > 2 {
            return None;
        }
        let lost = match kept {
            Ok(kept) if kept.stop == Stop::Cancelled => return None,
            Ok(kept) if kept.state.lost_creases() > 0 => true,
            Ok(kept) if is_crushed(model, &kept.state.positions) => false,
            Err(Failed::Diverged(_)) => false,
            _ => return None,
        };
        let began_so = if lost { start.lost_creases() > 0 } else { is_crushed(model, &start.positions) };
        if began_so {
            return None;
        }
        let softening = softening_between(self.softening, (model, scene), start.targets.iter().copied());
        let softened = softening.is_some() && last.ramp > 0;
        let longer = || last.ramp.saturating_mul(LONGER_RAMP).max(grown(LONG_RAMP, model, 1.0));
        let next = Attempt { number: last.number + 1, limit, ..last };
        Some(match last.number {
            1 if lost && softened => {
                let ramp = last.ramp.min(grown(STIFF_RAMP, model, 1.0));
                Attempt { ramp, softening: None, ..next }
            }
            2 if lost && last.perturbed && softened => Attempt { ramp: longer(), softening, ..next },
            1 if lost || self.perturbation == 0.0 => Attempt { ramp: longer(), ..next },
            1 => Attempt { perturbed: false, ..next },
            _ => Attempt { ramp: 0, perturbed: true, ..next },
        })
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
        (scene, targets, ramp, softening): (&Scene, Vec<f64>, u32, Option<Softening>),
        threads: usize,
    ) -> Stepper<R> {
        let ramp = Ramp::new(&start.targets, targets, ramp);
        let softening = softening.filter(|_| !ramp.done());
        // Chains of short sides along curved creases move as one onto saddles.
        let near = if folds_flat(model) { self.near } else { 0.0 };
        let mover = Mover::Relax(Minimiser::new(model, near));
        let mut stepper = Stepper::new((model, start), scene, (positions, &[]), (mover, ramp), self.tolerance, threads);
        stepper.soften(model, softening);
        stepper
    }
}
