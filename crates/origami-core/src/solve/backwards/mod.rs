//! Folding backwards: a motion to the flat-folded state that was found from that state.
//!
//! All creases at once fold few patterns flat without jamming, and nobody says in which order they fold. But the flat-folded state
//! is known ([`Reflect`]), and an order of its layers can be found ([`Stacking`]). So the sheet is opened from there and the
//! motion played forwards. What is flat has no thickness to open from: first its layers are moved apart, as little as can be, by a
//! force that keeps them in their order while the creases open a little. When nothing crosses any more by the exact test, contact
//! keeps it so on the way to the open sheet.

mod order_force;
mod relations;

use std::ops::ControlFlow;

use glam::DVec3;

use super::{ContactRelax, Failed, Folded, Progress, Reflect, Relax, Solver, State, Stop};
use crate::contact::{Contact, Crossings};
use crate::ids::TriangleId;
use crate::layers::{NoOrder, Stacking};
use crate::model::Model;
use crate::scene::{Refusal, Scene, Targets};
use order_force::OrderForce;
use relations::{Beside, Flat, distinct};

/// By how much a sheet may miss itself in the flat-folded state, in radii.
const CLOSED: f64 = 1e-3;
/// What is tried in turn, until nothing crosses and the sheet opens: thin layers first, whose folds are shifted into each other
/// from the start; then thick ones that find their way by opening the creases farther, each from the state before it.
const ATTEMPTS: [Attempt; 10] = [
    Attempt { open: 5.0, gap: 3e-4, margin: 3e-3, beyond: 1.2e-3, shifted: true },
    Attempt { open: 5.0, gap: 1e-3, margin: 3e-3, beyond: 1.2e-3, shifted: true },
    Attempt { open: 5.0, gap: 3e-3, margin: 1e-2, beyond: 4e-3, shifted: true },
    Attempt { open: 5.0, gap: 1e-2, margin: 1e-2, beyond: 4e-3, shifted: true },
    Attempt { open: 5.0, gap: 1e-2, margin: 2e-3, beyond: 1e-2, shifted: false },
    Attempt { open: 5.0, gap: 3e-3, margin: 2e-3, beyond: 1e-2, shifted: false },
    Attempt { open: 10.0, gap: 1e-2, margin: 2e-3, beyond: 1e-2, shifted: false },
    Attempt { open: 10.0, gap: 3e-3, margin: 2e-3, beyond: 1e-2, shifted: false },
    Attempt { open: 20.0, gap: 1e-2, margin: 2e-3, beyond: 1e-2, shifted: false },
    Attempt { open: 20.0, gap: 3e-3, margin: 2e-3, beyond: 1e-2, shifted: false },
];
/// Times that what crosses beside each other is parted in one attempt.
const ROUNDS: usize = 4;
/// Evaluations of a round.
const ROUND: u64 = 1500;
/// From one state to the next on the way to flat the gap and the opening shrink to this share.
const SHRINK: f64 = 0.6;
/// Such states at most.
const MOST_HELD: usize = 8;
/// Places between two states that are tested.
const BETWEEN: u32 = 8;
/// A sheet is open if no crease is farther from its angle than this, in radians.
const OPENED: f64 = 1e-3;
/// Evaluations of a stage under contact at most.
const STAGE: u64 = 6000;

/// How layers are moved apart.
#[derive(Clone, Copy, Debug)]
struct Attempt {
    /// How far creases stay open, in percent.
    open: f64,
    /// Between layers, in radii.
    gap: f64,
    /// Between what lies beside each other, in radii.
    margin: f64,
    /// How far beyond its end a thing still counts where no paper folds around that, in radii.
    beyond: f64,
    /// Whether what lies in a fold is kept from its crease, and folds back to back from each other.
    shifted: bool,
}

/// Finds a motion that folds a sheet flat without paper going through paper, by opening it from its flat-folded state.
///
/// For patterns that [`Reflect`] folds. There may be many orders of layers; one is taken. Research: it embeds many patterns of
/// some dozens of creases, not all, and says so where it does not.
///
/// ```
/// use origami_core::contact::Crossings;
/// use origami_core::generate::SquareTwist;
/// use origami_core::solve::{Backwards, unwatched};
/// use origami_core::{Material, Model};
///
/// let model = Model::new(&SquareTwist::default().pattern()?, &Material::default())?;
/// let motion = Backwards::default().fold(&model, 4, &mut unwatched)?;
/// assert!(motion.states.iter().all(|folded| Crossings::of(&model.mesh, &folded.state.positions).is_empty()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Backwards {
    /// Tolerance and threads of the stages under contact; ramp, limits, perturbation and retries are its own.
    pub relax: Relax,
    /// How paper keeps away from paper on the way to the open sheet.
    pub contact: Contact,
}

/// A motion from the open sheet to the flat-folded one.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Motion {
    /// From the sheet at rest to the exact flat-folded one, none of which crosses itself. Neighbours under contact are joined by a
    /// way without crossings; between those that the order of layers holds eight places in line were tested. The last step
    /// alone, to the flat state, was not.
    pub states: Vec<Folded>,
    /// How many of them, from the first, contact leads from one to the next.
    pub touching: usize,
    /// Which layer lies on which in the last.
    pub stacking: Stacking,
    /// How far apart layers are wanted in the last state but one, in radii.
    pub gap: f64,
    /// The farthest that a crease is from flat there, in radians.
    pub off: f64,
    /// Force evaluations, of all attempts.
    pub evaluations: u64,
}

/// Why there is no motion.
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum NotBackwards {
    /// A solver has no result; of the flat-folded state too.
    #[error(transparent)]
    Failed(#[from] Failed),
    /// The layers of the flat-folded state have no order.
    #[error("{}", match .0 {
        NoOrder::Contradiction => "no order of the layers lets the sheet lie flat without paper going through paper",
        _ => "no order of the layers was found in the time that it may take",
    })]
    Order(NoOrder),
    /// The flat-folded state could not be embedded.
    #[error("the flat state could not be embedded: {} left, {}", count(.crossings), faces(.crossings))]
    Embedded {
        /// Those of the best attempt.
        crossings: Crossings,
    },
    /// It was embedded, and the sheet did not open from there.
    #[error("the flat state was embedded, but did not open: a crease is {:.1} degrees from flat at the end", .off.to_degrees())]
    Closed {
        /// The farthest that a crease is from its angle in the open sheet, in radians.
        off: f64,
    },
}

fn count(crossings: &Crossings) -> String {
    match crossings.all.len() {
        1 => "1 crossing".to_owned(),
        n => format!("{n} crossings"),
    }
}

fn faces(crossings: &Crossings) -> String {
    const NAMED: usize = 3;
    let named: Vec<String> = crossings.faces.iter().take(NAMED).map(|[a, b]| format!("{} and {}", a.0, b.0)).collect();
    let more = crossings.faces.len().saturating_sub(NAMED);
    let more = if more > 0 { format!(" and {more} more pairs") } else { String::new() };
    format!("faces {}{more}", named.join(", "))
}

impl Backwards {
    /// Finds the motion; under contact it has `stages` states after the sheet at rest, at least one. `observe` is shown how the solvers
    /// get on; where it breaks, what is at hand is taken for the result of that solver.
    ///
    /// # Errors
    /// [`NotBackwards`], which tells what is in the way.
    pub fn fold(
        &self,
        model: &Model,
        stages: u32,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Motion, NotBackwards> {
        let flat = Reflect { tolerance: CLOSED }.fold_from_rest(model, 100.0)?;
        let stacking =
            Stacking::of(model, &flat.state.positions, &flat.state.fold_angles).map_err(NotBackwards::Order)?;
        let mut run = Run::new(self, model, flat, &stacking);
        let mut failed: Option<NotBackwards> = None;
        for attempt in ATTEMPTS {
            let tried = run.embed(attempt, observe).and_then(|held| {
                let opened = run.open(&held, stages, observe)?;
                Ok((held, opened))
            });
            match tried {
                Ok((held, opened)) => return run.into_motion(held, opened, stacking, observe),
                Err(NotBackwards::Failed(Failed::Refused { refusal, start })) if !is_crossed(&refusal) => {
                    return Err(Failed::Refused { refusal, start }.into());
                }
                Err(why) => failed = Some(nearer(failed, why)),
            }
        }
        Err(failed.unwrap_or(NotBackwards::Closed { off: f64::NAN }))
    }
}

fn is_crossed(refusal: &Refusal) -> bool {
    matches!(refusal, Refusal::Crossed { .. } | Refusal::Closed { .. })
}

/// Which of two attempts came farther.
fn nearer(before: Option<NotBackwards>, now: NotBackwards) -> NotBackwards {
    match (before, now) {
        (Some(NotBackwards::Closed { off }), NotBackwards::Closed { off: own }) => {
            NotBackwards::Closed { off: off.min(own) }
        }
        (Some(closed @ NotBackwards::Closed { .. }), _) => closed,
        (Some(NotBackwards::Embedded { crossings }), NotBackwards::Embedded { crossings: own })
            if crossings.all.len() < own.all.len() =>
        {
            NotBackwards::Embedded { crossings }
        }
        (Some(before), NotBackwards::Failed(_)) => before,
        (_, now) => now,
    }
}

/// A state that the order of its layers holds.
struct Held {
    folded: Folded,
    attempt: Attempt,
}

struct Run<'a> {
    backwards: &'a Backwards,
    model: &'a Model,
    exact: Folded,
    flat: Flat<'a>,
    /// What keeps folds from each other from the start.
    shifts: Vec<Beside>,
    force: OrderForce,
    /// Where the last attempt ended.
    reached: State,
    evaluations: u64,
}

impl<'a> Run<'a> {
    fn new(backwards: &'a Backwards, model: &'a Model, exact: Folded, stacking: &Stacking) -> Self {
        let flat = Flat::new(&model.mesh, &exact.state.positions, stacking);
        let relations = flat.relations(stacking);
        let mut shifts = flat.nested(&relations);
        shifts.extend(flat.back_to_back());
        let force = OrderForce { relations, beside: Vec::new(), gap: 0.0, margin: 0.0, beyond: 0.0 };
        let reached = exact.state.clone();
        Self { backwards, model, exact, flat, shifts: distinct(shifts), force, reached, evaluations: 0 }
    }

    /// A state near the flat one in which nothing crosses.
    fn embed(
        &mut self,
        attempt: Attempt,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Held, NotBackwards> {
        if attempt.shifted {
            self.force.beside.clone_from(&self.shifts);
            self.reached.clone_from(&self.exact.state);
        } else if self.force.beside.starts_with(&self.shifts) && !self.shifts.is_empty() {
            self.force.beside.clear();
            self.reached.clone_from(&self.exact.state);
        }
        let start = self.reached.clone();
        let (folded, crossings) = self.hold(&start, attempt, observe)?;
        self.reached.clone_from(&folded.state);
        if crossings.is_empty() { Ok(Held { folded, attempt }) } else { Err(NotBackwards::Embedded { crossings }) }
    }

    /// Relaxes from a state under the force that keeps the order, again and again while triangles cross that only touched.
    fn hold(
        &mut self,
        start: &State,
        attempt: Attempt,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Crossings), Failed> {
        let Attempt { open, gap, margin, beyond, .. } = attempt;
        (self.force.gap, self.force.margin, self.force.beyond) = (gap, margin, beyond);
        let relax = Relax {
            tolerance: 2e-5 * open,
            perturbation: 0.0,
            saddle_search: 0.0,
            retry: false,
            softening: None,
            hand_over: None,
            max_steps: ROUND,
            ramp: None,
            steps: None,
            ..self.backwards.relax.clone()
        };
        let (mut from, mut round) = (start.clone(), 1);
        loop {
            let scene = Scene::percent(100.0 - open).with_force(self.force.clone());
            let mut folded = relax.fold(self.model, &from, &scene, observe)?;
            self.evaluations += folded.steps;
            folded.stop = Stop::StepsDone;
            let crossings = Crossings::of(&self.model.mesh, &folded.state.positions);
            if crossings.is_empty() || round == ROUNDS || !self.part(&crossings) {
                return Ok((folded, crossings));
            }
            (from, round) = (folded.state, round + 1);
        }
    }

    /// Parts triangles that cross and have no order, since in the flat state they lie beside each other; false where there are none.
    fn part(&mut self, crossings: &Crossings) -> bool {
        let mesh = &self.model.mesh;
        let pairs = crossings.all.iter().flat_map(|crossing| {
            let own = mesh.sides[crossing.side.index()].triangles.into_iter().flatten();
            own.map(move |t| [t, crossing.triangle])
        });
        let beside: Vec<[TriangleId; 2]> = pairs.filter(|[t, u]| !self.flat.is_ordered(*t, *u)).collect();
        let before = self.force.beside.len();
        let added = beside.iter().flat_map(|[t, u]| self.flat.apart(*t, *u));
        self.force.beside = distinct(self.force.beside.iter().copied().chain(added).collect());
        self.force.beside.len() > before || !beside.is_empty()
    }

    /// Opens the sheet under contact: the states on the way, the open one last.
    fn open(
        &mut self,
        held: &Held,
        stages: u32,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Vec<Folded>, NotBackwards> {
        let relax =
            Relax { perturbation: 0.0, max_steps: STAGE, ramp: None, steps: None, ..self.backwards.relax.clone() };
        let solver = ContactRelax { relax, contact: self.backwards.contact };
        let stages = stages.max(1);
        let mut states: Vec<Folded> = Vec::new();
        for stage in (0..stages).rev() {
            let percent = (100.0 - held.attempt.open) * f64::from(stage) / f64::from(stages);
            let from = states.last().map_or(&held.folded.state, |folded| &folded.state);
            let mut folded = solver.fold(self.model, from, &Scene::percent(percent), observe)?;
            self.evaluations += folded.steps;
            if stage > 0 {
                folded.stop = Stop::StepsDone;
            }
            states.push(folded);
        }
        let open = states.last().map_or(&self.exact.state, |folded| &folded.state);
        let off = open.fold_angles.iter().fold(0.0_f64, |off, angle| off.max(angle.abs()));
        if off < OPENED { Ok(states) } else { Err(NotBackwards::Closed { off }) }
    }

    /// The states that come ever nearer to the flat one, as long as nothing crosses.
    fn close(
        &mut self,
        held: Held,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Vec<Held>, NotBackwards> {
        let mut states = vec![held];
        for _ in 0..MOST_HELD {
            let Some(Held { folded, attempt }) = states.last() else { break };
            let attempt = Attempt { open: SHRINK * attempt.open, gap: SHRINK * attempt.gap, ..*attempt };
            let start = folded.state.clone();
            let (folded, crossings) = self.hold(&start, attempt, observe)?;
            if !crossings.is_empty() || !self.is_free(&start.positions, &folded.state.positions) {
                break;
            }
            states.push(Held { folded, attempt });
        }
        Ok(states)
    }

    /// Whether nothing crosses in line between two states, as far as it is tested.
    fn is_free(&self, from: &[DVec3], to: &[DVec3]) -> bool {
        (1..=BETWEEN).all(|place| {
            let share = f64::from(place) / f64::from(BETWEEN + 1);
            let positions: Vec<DVec3> = from.iter().zip(to).map(|(from, to)| from.lerp(*to, share)).collect();
            Crossings::of(&self.model.mesh, &positions).is_empty()
        })
    }

    fn into_motion(
        mut self,
        held: Held,
        opened: Vec<Folded>,
        stacking: Stacking,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Motion, NotBackwards> {
        let closing = self.close(held, observe)?;
        let Some((last, gap)) = closing.last().map(|held| (&held.folded.state, held.attempt.gap)) else {
            return Err(NotBackwards::Closed { off: f64::NAN });
        };
        let angles = last.fold_angles.iter().zip(&self.exact.state.fold_angles);
        let off = angles.map(|(own, flat)| (own - flat).abs()).fold(0.0, f64::max);
        // The open sheet has been reached but for the tolerance of the solver.
        let rest = Folded {
            state: State::at_rest(self.model),
            targets: Targets::percent(0.0),
            steps: 0,
            residual: 0.0,
            distance: 0.0,
            ..self.exact.clone()
        };
        let mut states = vec![rest];
        states.extend(opened.into_iter().rev().skip(1));
        let touching = states.len() + 1;
        states.extend(closing.into_iter().map(|held| held.folded));
        states.push(self.exact);
        Ok(Motion { states, touching, stacking, gap, off, evaluations: self.evaluations })
    }
}
