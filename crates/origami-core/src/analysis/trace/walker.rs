//! From one equilibrium to the next: predictor along the tangent, corrector by Newton's method on the equations and one more
//! that says how far to go.

use glam::DVec3;

use super::settings::{Control, Path, Until};
use crate::analysis::eigen::{Pair, dot};
use crate::analysis::tangent::Tangent;
use crate::analysis::{Configuration, Dof, Refused, Structure};

/// Iterations after which a point is given up: where all is smooth four are enough, laws without a second derivative and
/// pressures without a potential converge slowly.
pub(super) const MOST: u32 = 40;
/// An iteration that still moves a node as far, in sizes, has gone astray.
const ASTRAY: f64 = 2.0;
/// A move that no longer shrinks is rounding if it is as small, in sizes.
const ROUNDING: f64 = 1e-8;

/// An equilibrium with the direction in which the path goes on.
#[derive(Clone, Debug)]
pub(super) struct Stand {
    pub(super) at: Configuration,
    pub(super) load_factor: f64,
    /// Gradient of the energy, by node: what loads and supports balance.
    pub(super) gradient: Vec<DVec3>,
    pub(super) residual: f64,
    pub(super) iterations: u32,
    pub(super) negative: usize,
    pub(super) direction: Direction,
}

/// The tangent of the path: by row, and of the load factor.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Direction {
    pub(super) rows: Vec<f64>,
    pub(super) load_factor: f64,
}

/// The equation that says how far to go: `row . moves + load_factor * change` is so much.
#[derive(Clone, Debug)]
pub(super) struct Measure {
    row: Vec<f64>,
    load_factor: f64,
}

impl Measure {
    /// How much it grows, if it is that of the load factor, where that changes so much.
    pub(super) fn grown(&self, load_factor: f64) -> f64 {
        self.load_factor * load_factor
    }

    /// How much it grows along a direction.
    pub(super) fn of(&self, direction: &Direction) -> f64 {
        dot(&self.row, &direction.rows) + self.load_factor * direction.load_factor
    }
}

/// Finds equilibria of a structure, one after the other.
#[derive(Debug)]
pub(super) struct Walker<'s> {
    pub(super) tangent: Tangent<'s>,
    control: Control,
    tolerance: f64,
    /// 1, or -1 where it sets out with what is controlled falling.
    side: f64,
    /// What the square of the load factor counts beside squares of moves: those of moved supports.
    weight: f64,
    /// Where the eigenvalue nearest to 0 was found last.
    space: Vec<Vec<f64>>,
}

impl<'s> Walker<'s> {
    pub(super) fn new(structure: &'s Structure, path: &Path) -> Result<Self, Refused> {
        let tangent = Tangent::new(structure)?;
        let weight = tangent.equations.way().iter().map(|w| w.length_squared()).sum();
        let side = if path.backwards { -1.0 } else { 1.0 };
        Ok(Self { tangent, control: path.control, tolerance: path.tolerance, side, weight, space: Vec::new() })
    }

    /// Turns to where the path is to lead, as seen from `stand`.
    pub(super) fn turn(&mut self, path: &Path, mut stand: Stand) -> Stand {
        if let Control::Displacement(dof) = self.control {
            let value = path.until.iter().find_map(|until| match until {
                Until::Displacement(own, value) if *own == dof => Some(*value),
                _ => None,
            });
            self.side = (value.unwrap_or_default() - self.displacement(dof, &stand)).signum();
        }
        if self.measure(&stand.direction).of(&stand.direction) < 0.0 {
            stand.direction.rows.iter_mut().for_each(|x| *x = -*x);
            stand.direction.load_factor = -stand.direction.load_factor;
        }
        stand
    }

    pub(super) fn structure(&self) -> &'s Structure {
        self.tangent.equations.structure
    }

    /// The eigenvalue nearest to 0 of the tangent that was set last, with its vector.
    pub(super) fn nearest(&mut self) -> Vec<Pair> {
        self.tangent.nearest_to_zero(1, &mut self.space)
    }

    pub(super) fn size(&self) -> f64 {
        self.tangent.equations.size
    }

    /// How far to go from `from` is measured along the path's own direction, or by what is controlled.
    pub(super) fn measure(&self, from: &Direction) -> Measure {
        match self.control {
            Control::Arc => Measure { row: from.rows.clone(), load_factor: self.weight * from.load_factor },
            Control::Load => self.by_load(),
            Control::Displacement(dof) => {
                let mut row = vec![0.0; from.rows.len()];
                if let Some(own) = self.tangent.equations.rows.of(dof.node.index(), dof.axis.index()) {
                    row[own] = self.side;
                }
                Measure { row, load_factor: 0.0 }
            }
        }
    }

    pub(super) fn by_load(&self) -> Measure {
        Measure { row: vec![0.0; self.tangent.equations.rows.len()], load_factor: self.side }
    }

    /// The inner product of two directions.
    pub(super) fn product(&self, a: &Direction, b: &Direction) -> f64 {
        dot(&a.rows, &b.rows) + self.weight * a.load_factor * b.load_factor
    }

    fn normalised(&self, mut direction: Direction) -> Direction {
        let length = self.product(&direction, &direction).sqrt();
        // Where no load acts nothing moves as its factor grows.
        if length == 0.0 {
            return direction;
        }
        direction.rows.iter_mut().for_each(|x| *x /= length);
        direction.load_factor /= length;
        direction
    }

    /// The move of the node that goes farthest along `direction`, moved supports included.
    pub(super) fn farthest(&self, direction: &Direction) -> f64 {
        let mut moves = self.tangent.equations.rows.scatter(&direction.rows);
        moves.iter_mut().zip(self.tangent.equations.way()).for_each(|(m, w)| *m += *w * direction.load_factor);
        moves.iter().map(|m| m.length()).fold(0.0, f64::max)
    }

    /// A state as it is, in equilibrium or not, with the direction in which `measure` grows. `None` where it is singular.
    pub(super) fn stand(
        &mut self,
        mut at: Configuration,
        load_factor: f64,
        measure: &Measure,
        iterations: u32,
    ) -> Option<Stand> {
        let equations = &self.tangent.equations;
        equations.place(&mut at, load_factor);
        let unbalanced = equations.unbalanced(&mut at, load_factor);
        let residual = equations.rows.gather(&unbalanced).iter().fold(0.0, |a: f64, x| a.max(x.abs()));
        let mut gradient = vec![DVec3::ZERO; unbalanced.len()];
        self.structure().loads.add_forces(&at.positions, &mut gradient);
        gradient.iter_mut().zip(&unbalanced).for_each(|(g, u)| *g = *g * load_factor + *u);
        if !residual.is_finite() || !self.tangent.set(&at, load_factor) {
            return None;
        }
        let load: Vec<f64> = self.tangent.equations.load(&at).iter().map(|x| -x).collect();
        let nothing = vec![0.0; load.len()];
        let (rows, change) = self.tangent.solve_bordered(&load, (&measure.row, measure.load_factor), &nothing, 1.0);
        let direction = self.normalised(Direction { rows, load_factor: change });
        let finite = direction.load_factor.is_finite() && direction.rows.iter().all(|x| x.is_finite());
        let negative = self.tangent.negative();
        finite.then_some(Stand { at, load_factor, gradient, residual, iterations, negative, direction })
    }

    /// The equilibrium at which `measure` has grown by `length` from `base`, sought from `guess`. `None` where there is none
    /// nearby.
    pub(super) fn correct(
        &mut self,
        base: &Stand,
        measure: &Measure,
        length: f64,
        guess: (Configuration, f64),
    ) -> Option<Stand> {
        let (mut at, mut load_factor) = guess;
        let size = self.size();
        let mut last = f64::INFINITY;
        for iteration in 1..=MOST {
            let equations = &self.tangent.equations;
            equations.place(&mut at, load_factor);
            let unbalanced = equations.unbalanced(&mut at, load_factor);
            let right: Vec<f64> = equations.rows.gather(&unbalanced).iter().map(|x| -x).collect();
            let residual = right.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
            let load: Vec<f64> = equations.load(&at).iter().map(|x| -x).collect();
            let gone: Vec<DVec3> = at.positions.iter().zip(&base.at.positions).map(|(p, q)| *p - *q).collect();
            let gone = dot(&measure.row, &equations.rows.gather(&gone))
                + measure.load_factor * (load_factor - base.load_factor);
            if !residual.is_finite() || !self.tangent.set(&at, load_factor) {
                return None;
            }
            let border = (measure.row.as_slice(), measure.load_factor);
            let (moves, change) = self.tangent.solve_bordered(&load, border, &right, length - gone);
            let step = self.farthest(&Direction { rows: moves.clone(), load_factor: change }) / size;
            if !(step < ASTRAY && change.is_finite()) {
                return None;
            }
            self.tangent.equations.rows.add(1.0, &moves, &mut at.positions);
            load_factor += change;
            let rounded = step < ROUNDING && (step > 0.5 * last || residual <= self.tangent.equations.rounding);
            if step <= self.tolerance || rounded {
                return self.stand(at, load_factor, measure, iteration);
            }
            last = step;
        }
        None
    }

    /// Part of the way from one stand to another, as a guess.
    pub(super) fn between(from: &Stand, to: &Stand, share: f64) -> (Configuration, f64) {
        let mut at = from.at.clone();
        at.positions.iter_mut().zip(&to.at.positions).for_each(|(p, q)| *p = p.lerp(*q, share));
        (at, from.load_factor + share * (to.load_factor - from.load_factor))
    }

    /// So far along the direction of `from` that `measure` grows by `length`.
    pub(super) fn predict(&self, from: &Stand, measure: &Measure, length: f64) -> (Configuration, f64) {
        let mut at = from.at.clone();
        let share = length / measure.of(&from.direction);
        self.tangent.equations.rows.add(share, &from.direction.rows, &mut at.positions);
        (at, from.load_factor + share * from.direction.load_factor)
    }

    pub(super) fn displacement(&self, dof: Dof, stand: &Stand) -> f64 {
        dof.of(&stand.at.positions) - dof.of(&self.structure().nodes)
    }
}
