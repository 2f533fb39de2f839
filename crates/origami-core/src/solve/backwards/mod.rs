//! Folding backwards: a motion to the flat-folded state that was found from that state.
//!
//! All creases at once fold few patterns flat without jamming, and nobody says in which order they fold. But the flat-folded state
//! is known ([`Reflect`]), and an order of its layers can be found ([`Stacking`]). So the sheet is opened from there and the
//! motion played forwards. What is flat has no thickness to open from: first its layers are moved apart, as little as can be, by a
//! force that keeps them in their order while the creases open a little. When nothing crosses any more by the exact test, contact
//! keeps it so on the way to the open sheet.

mod attempts;
mod beside;
mod flat;
mod not_backwards;
mod order_force;
mod relations;
mod way;

use std::ops::ControlFlow;

use super::{Failed, Folded, Progress, Reflect, Relax, Solver};
use crate::contact::Contact;
use crate::layers::Stacking;
use crate::model::Model;
use attempts::{ATTEMPTS, Run};
pub use not_backwards::NotBackwards;
use not_backwards::{is_crossed, nearer};
use way::{NEARLY, Way};

/// By how much a sheet may miss itself in the flat-folded state, in radii.
const CLOSED: f64 = 1e-3;
/// Of so many motions that are found the one is taken that comes nearest to the flat-folded state.
const ENOUGH: usize = 3;

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
    /// How far apart layers are kept in the last state but one, in radii.
    pub gap: f64,
    /// The farthest that a crease is from flat there, in radians.
    pub off: f64,
    /// Force evaluations, of all attempts.
    pub evaluations: u64,
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
        let (mut failed, mut best, mut found): (Option<NotBackwards>, Option<Way>, usize) = (None, None, 0);
        for attempt in ATTEMPTS {
            match run.embed(attempt, observe).and_then(|held| run.way(held, stages, observe)) {
                Ok(way) => {
                    let way = run.thinner(way, stages, observe);
                    best = best.filter(|best| best.off <= way.off).or(Some(way));
                    found += 1;
                }
                Err(NotBackwards::Failed(Failed::Refused { refusal, start })) if !is_crossed(&refusal) => {
                    return Err(Failed::Refused { refusal, start }.into());
                }
                Err(why) => failed = Some(nearer(failed, why)),
            }
            if found == ENOUGH || best.as_ref().is_some_and(|best| best.off < NEARLY) {
                break;
            }
        }
        match best {
            Some(way) => Ok(run.into_motion(way, stacking)),
            None => Err(failed.unwrap_or(NotBackwards::Closed { off: f64::NAN })),
        }
    }
}
