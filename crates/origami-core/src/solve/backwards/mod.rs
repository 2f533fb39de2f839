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

use std::cell::Cell;
use std::ops::ControlFlow;

use glam::{DVec2, DVec3};

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
/// Orders of the layers that are tried.
const ORDERS: u32 = 8;
/// So many motions are sought with each.
const ENOUGH: usize = 2;
/// No attempt begins after so many evaluations: less than a minute for sheets of a hundred triangles.
const MOST: u64 = 300_000;

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
    /// get on; where it breaks, the best motion that has been found by then is taken.
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
        let stopped = Cell::new(false);
        let observe = &mut |progress: Progress| {
            let flow = observe(progress);
            stopped.set(stopped.get() || flow.is_break());
            flow
        };
        let (mut failed, mut best, mut evaluations): (Option<NotBackwards>, Option<(Way, Stacking)>, u64) =
            (None, None, 0);
        for number in 0..ORDERS {
            let stacking = match Stacking::of(model, &turned(&flat.state.positions, number), &flat.state.fold_angles) {
                Ok(stacking) => stacking,
                Err(why) if number == 0 => return Err(NotBackwards::Order(why)),
                Err(_) => continue,
            };
            // Every second one: which sheets it helps is not known before.
            let mut run = Run::new((self, model), &flat, &stacking, number % 2 == 1);
            run.evaluations = evaluations;
            let mut found = 0_usize;
            for attempt in ATTEMPTS {
                match run.embed(attempt, observe).and_then(|held| run.way(held, stages, observe)) {
                    Ok(way) => {
                        let way = run.thinner(way, stages, observe);
                        best = best.filter(|(best, _)| best.off <= way.off).or_else(|| Some((way, stacking.clone())));
                        found += 1;
                    }
                    Err(NotBackwards::Failed(Failed::Refused { refusal, start })) if !is_crossed(&refusal) => {
                        return Err(Failed::Refused { refusal, start }.into());
                    }
                    Err(why) => failed = Some(nearer(failed, why)),
                }
                if found == ENOUGH || run.is_over(best.as_ref()) || stopped.get() {
                    break;
                }
            }
            evaluations = run.evaluations;
            // Where there is one order only, the second time is the last that differs.
            if run.is_over(best.as_ref()) || stopped.get() || (stacking.free.is_empty() && number > 0) {
                break;
            }
        }
        match best {
            Some((way, stacking)) => Ok(way.into_motion(model, flat, stacking, evaluations)),
            None if stopped.get() => Err(NotBackwards::Stopped),
            None => Err(failed.unwrap_or(NotBackwards::Closed { off: f64::NAN })),
        }
    }
}

impl Run<'_> {
    /// Whether the best way is good enough, or nothing more is tried.
    fn is_over(&self, best: Option<&(Way, Stacking)>) -> bool {
        self.evaluations > MOST || best.is_some_and(|(best, _)| best.off < NEARLY)
    }
}

/// A flat sheet turned in its plane, by so many radians. Which of many orders is found hangs on where what is equal comes first, so
/// that each number finds its own, the same every time.
fn turned(positions: &[DVec3], number: u32) -> Vec<DVec3> {
    let turn = DVec2::from_angle(f64::from(number));
    positions.iter().map(|p| turn.rotate(p.truncate()).extend(p.z)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Crossings;
    use crate::generate::catalog;
    use crate::model::Material;
    use crate::solve::{Stop, unwatched};

    fn model(name: &str, size: &[(String, f64)]) -> Model {
        Model::new(&catalog::generate(name, size).unwrap(), &Material::default()).unwrap()
    }

    fn squared(count: f64) -> [(String, f64); 2] {
        ["columns", "rows"].map(|name| (name.to_owned(), count))
    }

    /// A sheet with more than one order is given several, and each is the same the next time.
    #[test]
    fn another_order_is_tried_and_the_same_every_time() {
        let model = model("waterbomb", &squared(4.0));
        let flat = Reflect { tolerance: CLOSED }.fold_from_rest(&model, 100.0).unwrap().state;
        let order = |number| Stacking::of(&model, &turned(&flat.positions, number), &flat.fold_angles).unwrap();
        let orders: Vec<Stacking> = (0..ORDERS).map(order).collect();
        assert!(orders.iter().any(|other| other.triangles != orders[0].triangles));
        assert!((0..ORDERS).map(order).eq(orders));
    }

    /// How a press ended, blocked or not, is no matter of the motion, which ends exactly flat.
    #[test]
    fn states_of_a_press_are_places_on_the_way() {
        let motion = Backwards::default().fold(&model("miura", &squared(6.0)), 4, &mut unwatched).unwrap();
        let before_last = motion.states.len() - 2;
        assert_eq!(motion.touching, before_last + 1, "it is pressed up to the flat state");
        assert_eq!(motion.states[before_last].stop, Stop::StepsDone);
    }

    #[test]
    fn who_breaks_off_is_told_that_nothing_was_found_yet() {
        let model = model("miura", &squared(5.0));
        let ended = Backwards::default().fold(&model, 2, &mut |_| ControlFlow::Break(()));
        assert!(matches!(ended, Err(NotBackwards::Stopped)), "{ended:?}");
    }

    /// One crossing is left of this sheet in every attempt with its first order, where that does not get stiffer.
    #[test]
    fn a_sheet_is_found_that_the_first_attempts_miss_and_the_same_every_time() {
        let model = model("miura", &squared(5.0));
        let motion = || Backwards::default().fold(&model, 2, &mut unwatched).unwrap();
        let [one, other] = [motion(), motion()];
        assert!(one.off < NEARLY, "{}", one.off.to_degrees());
        assert!(one.states.iter().all(|folded| Crossings::of(&model.mesh, &folded.state.positions).is_empty()));
        // What a state of the way was ended by is no matter of the result.
        assert!(one.states.iter().all(|folded| !matches!(folded.stop, Stop::StepLimit | Stop::Blocked)));
        let positions =
            |motion: Motion| motion.states.into_iter().map(|folded| folded.state.positions).collect::<Vec<_>>();
        assert_eq!(positions(one), positions(other));
    }
}
