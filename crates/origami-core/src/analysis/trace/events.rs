//! What happens between two points of a path: where something passes 0, and where the inertia changes.

use super::point::Event;
use super::settings::{Path, Until};
use super::walker::{Measure, Stand, Walker};
use crate::analysis::eigen::dot;

/// How sharply a place is found, as a share of the step that it lies in.
const SHARP: f64 = 1e-9;
/// The same for a change of inertia, which only halving finds.
const HALVED: f64 = 1e-8;
/// Changes so near to each other, as a share of the step, are one: symmetry makes several eigenvalues vanish at once, and
/// rounding parts them.
const TOGETHER: f64 = 1e-4;
/// A null vector on which the load does so small a share of the work that it might is one of a bifurcation.
const IDLE: f64 = 1e-4;
/// How far before and after a limit point stability is looked at, as a share of the step.
const BESIDE: f64 = 1e-3;

/// One step of a path: from `from`, `measure` grows by `length` to `to`.
pub(super) struct Step<'a> {
    pub(super) from: &'a Stand,
    pub(super) to: &'a Stand,
    pub(super) measure: &'a Measure,
    pub(super) length: f64,
}

/// A change of inertia: how far into the step, the state, and the number of negative eigenvalues before and after.
struct Change {
    length: f64,
    stand: Stand,
    before: usize,
    after: usize,
}

impl Step<'_> {
    /// The states of note within the step, in order, and its end; nothing after the path's.
    pub(super) fn events(&self, walker: &mut Walker<'_>, path: &Path) -> Vec<(Stand, Event)> {
        let mut found = Vec::new();
        if let Some((length, stand)) = self.zero_of(walker, |_, stand| stand.direction.load_factor) {
            let mut beside = |side: f64| {
                let length = (length + side * BESIDE * self.length).clamp(0.0, self.length);
                self.at(walker, length).map_or(stand.negative, |stand| stand.negative)
            };
            let event = Event::LimitPoint { before: beside(-1.0), after: beside(1.0) };
            found.push((length, stand, event));
        }
        for mut change in self.changes(walker) {
            if let Some(modes) = null_vectors(walker, &change) {
                let modes = modes.iter().map(|v| walker.tangent.equations.rows.scatter(v)).collect();
                let event = Event::Bifurcation { before: change.before, after: change.after, modes };
                // Its own tangent is not unique.
                change.stand.direction = self.from.direction.clone();
                found.push((change.length, change.stand, event));
            }
        }
        if let Some((length, stand)) = self.at_load(walker, 0.0) {
            found.push((length, stand, Event::ZeroLoad));
        }
        for until in &path.until {
            let end = match *until {
                Until::LoadFactor(value) => self.at_load(walker, value),
                Until::Displacement(dof, value) => {
                    self.zero_of(walker, |walker, stand| walker.displacement(dof, stand) - value)
                }
            };
            found.extend(end.map(|(length, stand)| (length, stand, Event::End)));
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let end = found.iter().position(|(_, _, event)| *event == Event::End);
        found.truncate(end.map_or(found.len(), |end| end + 1));
        // What happens exactly where a step ends stands for its end.
        let at_end = found.last().is_some_and(|(length, _, _)| *length == self.length);
        let mut events: Vec<(Stand, Event)> = found.into_iter().map(|(_, stand, event)| (stand, event)).collect();
        if end.is_none() && !at_end {
            events.push((self.to.clone(), Event::Step));
        }
        events
    }

    /// Where the load factor passes `value`: exactly there.
    fn at_load(&self, walker: &mut Walker<'_>, value: f64) -> Option<(f64, Stand)> {
        let (length, near) = self.zero_of(walker, |_, stand| stand.load_factor - value)?;
        let by_load = walker.by_load();
        let rest = by_load.grown(value - near.load_factor);
        let exact = walker.correct(&near, &by_load, rest, (near.at.clone(), value));
        Some((length, exact.map_or(near.clone(), |exact| Stand { direction: near.direction, ..exact })))
    }

    /// The state at a part of the step.
    fn at(&self, walker: &mut Walker<'_>, length: f64) -> Option<Stand> {
        let guess = Walker::between(self.from, self.to, length / self.length);
        walker.correct(self.from, self.measure, length, guess)
    }

    /// Where `value` passes 0 within the step, if it has different signs at its ends, or is 0 at its end: by the Illinois
    /// method, a false position that does not stick to one end.
    fn zero_of(&self, walker: &mut Walker<'_>, value: impl Fn(&Walker<'_>, &Stand) -> f64) -> Option<(f64, Stand)> {
        let (mut a, mut b) = ((0.0, value(walker, self.from)), (self.length, value(walker, self.to)));
        if b.1 == 0.0 && a.1 != 0.0 {
            return Some((self.length, self.to.clone()));
        }
        let passes = a.1 * b.1 < 0.0;
        if !passes {
            return None;
        }
        let mut found = None;
        for _ in 0..60 {
            let length = (a.0 * b.1 - b.0 * a.1) / (b.1 - a.1);
            let stand = self.at(walker, length)?;
            let own = value(walker, &stand);
            let moved = (length - b.0).abs();
            if own * b.1 < 0.0 {
                a = b;
            } else {
                a.1 *= 0.5;
            }
            b = (length, own);
            found = Some((length, stand));
            if own == 0.0 || moved <= SHARP * self.length || (b.0 - a.0).abs() <= SHARP * self.length {
                break;
            }
        }
        found
    }

    /// Where the inertia changes, in order.
    fn changes(&self, walker: &mut Walker<'_>) -> Vec<Change> {
        let mut changes = Vec::new();
        self.changes_between(walker, (0.0, self.from), (self.length, self.to), &mut changes);
        changes.dedup_by(|next, own| {
            let one = next.length - own.length <= TOGETHER * self.length;
            if one {
                own.after = next.after;
            }
            one
        });
        changes.retain(|change| change.before != change.after);
        changes
    }

    fn changes_between(&self, walker: &mut Walker<'_>, a: (f64, &Stand), b: (f64, &Stand), changes: &mut Vec<Change>) {
        if a.1.negative == b.1.negative {
            return;
        }
        let middle = 0.5 * (a.0 + b.0);
        // At the bifurcation itself the equations are singular: what cannot be halved any more is near enough.
        match self.at(walker, middle).filter(|_| b.0 - a.0 > HALVED * self.length) {
            Some(stand) => {
                self.changes_between(walker, a, (middle, &stand), changes);
                self.changes_between(walker, (middle, &stand), b, changes);
            }
            None => {
                let (before, after) = (a.1.negative, b.1.negative);
                changes.push(Change { length: a.0, stand: a.1.clone(), before, after });
            }
        }
    }
}

/// The null vectors of a change, by row, if it is a bifurcation: if the load does no work on them, or if there are several.
fn null_vectors(walker: &mut Walker<'_>, change: &Change) -> Option<Vec<Vec<f64>>> {
    let load = walker.tangent.equations.load(&change.stand.at);
    if !walker.tangent.set(&change.stand.at, change.stand.load_factor) {
        return None;
    }
    let count = change.before.abs_diff(change.after);
    let pairs = walker.tangent.nearest_to_zero(count, &mut Vec::new());
    let idle = |v: &[f64]| dot(v, &load).abs() <= IDLE * dot(&load, &load).sqrt();
    (count > 1 || pairs.iter().all(|(_, v)| idle(v))).then(|| pairs.into_iter().map(|(_, v)| v).collect())
}
