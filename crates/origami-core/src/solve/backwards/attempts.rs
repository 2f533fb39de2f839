//! The layers of a flat-folded sheet moved apart in one way after the other, until it opens from there.

use std::ops::ControlFlow;

use super::super::{Failed, Folded, Progress, Relax, Solver, State, Stop};
use super::beside::{Beside, distinct};
use super::flat::Flat;
use super::order_force::OrderForce;
use super::relations::Relation;
use super::{Backwards, NotBackwards};
use crate::contact::Crossings;
use crate::ids::{NodeId, TriangleId};
use crate::layers::Stacking;
use crate::model::Model;
use crate::scene::Scene;

/// What is tried in turn, until nothing crosses and the sheet opens: thin layers first, whose folds are shifted into each other
/// from the start; then thick ones that find their way by opening the creases farther, each from the state before it.
pub(super) const ATTEMPTS: [Attempt; 10] = [
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
/// Times that an attempt relaxes, and in between sees to what still crosses.
const ROUNDS: usize = 8;
/// Where layers cross that have an order, what keeps them in it gets so many times stiffer from one round to the next.
const STIFFER: f64 = 1.5;
/// An attempt ends when in so many rounds no fewer triangles crossed.
const PATIENCE: usize = 3;
/// Evaluations of a round.
const ROUND: u64 = 1500;

/// How layers are moved apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Attempt {
    /// How far creases stay open, in percent.
    pub(super) open: f64,
    /// Between layers, in radii.
    pub(super) gap: f64,
    /// Between what lies beside each other, in radii.
    pub(super) margin: f64,
    /// How far beyond its end a thing still counts where no paper folds around that, in radii.
    pub(super) beyond: f64,
    /// Whether what lies in a fold is kept from its crease, and folds back to back from each other.
    pub(super) shifted: bool,
}

/// A state that the order of its layers holds.
pub(super) struct Held {
    pub(super) folded: Folded,
    pub(super) attempt: Attempt,
}

/// One search for a motion.
pub(super) struct Run<'a> {
    pub(super) backwards: &'a Backwards,
    pub(super) model: &'a Model,
    pub(super) exact: &'a Folded,
    flat: Flat<'a>,
    /// What keeps folds from each other from the start.
    shifts: Vec<Beside>,
    pub(super) force: OrderForce,
    /// Whether crossings make the order stiffer: it embeds more sheets, and ends farther from flat.
    stiffens: bool,
    /// Where the last attempt ended.
    reached: State,
    pub(super) evaluations: u64,
}

impl<'a> Run<'a> {
    pub(super) fn new(
        (backwards, model): (&'a Backwards, &'a Model),
        exact: &'a Folded,
        stacking: &Stacking,
        stiffens: bool,
    ) -> Self {
        let flat = Flat::new(&model.mesh, &exact.state.positions, stacking);
        let relations = flat.relations(stacking);
        let mut shifts = flat.nested(&relations);
        shifts.extend(flat.back_to_back());
        let force = OrderForce { relations, beside: Vec::new(), gap: 0.0, margin: 0.0, beyond: 0.0 };
        let reached = exact.state.clone();
        Self { backwards, model, exact, flat, shifts: distinct(shifts), force, stiffens, reached, evaluations: 0 }
    }

    /// A state near the flat one in which nothing crosses.
    pub(super) fn embed(
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
        self.force.relations.iter_mut().for_each(|relation| relation.stiffer = 1.0);
        let start = self.reached.clone();
        let (folded, crossings) = self.hold(&start, attempt, observe)?;
        self.reached.clone_from(&folded.state);
        if crossings.is_empty() { Ok(Held { folded, attempt }) } else { Err(NotBackwards::Embedded { crossings }) }
    }

    /// Relaxes from a state under the force that keeps the order, again and again while triangles cross.
    pub(super) fn hold(
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
        let (mut from, mut round, mut fewest) = (start.clone(), 1, (usize::MAX, 0));
        loop {
            let scene = Scene::percent(100.0 - open).with_force(self.force.clone());
            let mut folded = relax.fold(self.model, &from, &scene, observe)?;
            self.evaluations += folded.steps;
            folded.stop = Stop::StepsDone;
            let crossings = Crossings::of(&self.model.mesh, &folded.state.positions);
            if crossings.all.len() < fewest.0 {
                fewest = (crossings.all.len(), round);
            }
            let over = round == ROUNDS || round == fewest.1 + PATIENCE;
            if crossings.is_empty() || over || !(self.part(&crossings) | (self.stiffens && self.stiffen(&crossings))) {
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

    /// Makes stiffer what keeps triangles in order that cross all the same; false where there is nothing.
    fn stiffen(&mut self, crossings: &Crossings) -> bool {
        let sides = &self.model.mesh.sides;
        let pairs = crossings.all.iter().flat_map(|crossing| {
            let own = sides[crossing.side.index()].triangles.into_iter().flatten();
            own.map(|t| [t, crossing.triangle].map(|t| self.flat.corners(t)))
        });
        let pairs: Vec<[[NodeId; 3]; 2]> = pairs.collect();
        let crossed = |relation: &&mut Relation| pairs.iter().any(|[one, other]| relation.is_between(*one, *other));
        let mut any = false;
        for relation in self.force.relations.iter_mut().filter(crossed) {
            relation.stiffer *= STIFFER;
            any = true;
        }
        any
    }
}
