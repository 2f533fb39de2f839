//! The tangent stiffness of a state, factorised: solving, and which directions cost energy.

use glam::DVec3;

use super::eigen::{self, dot};
use super::equations::Equations;
use super::matrix::Matrix;
use super::structure::Structure;
use super::{Configuration, Refused};
use crate::solve::newton::Factor;

/// What counts as an eigenvalue of 0, as a share of the largest entry of the diagonal.
pub(super) const NEUTRAL: f64 = 1e-11;

/// What a solution may leave over, as a share of the right side; where it leaves more it is refined.
const ACCURATE: f64 = 1e-13;

/// How many eigenvalues of a tangent are negative, and how many are 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Inertia {
    /// Independent directions in which the energy falls: 0 where the state is stable under its loads.
    pub negative: usize,
    /// Directions in which it does not change to second order: mechanisms, and the null vectors of critical points.
    pub neutral: usize,
}

/// The tangent stiffness of a structure in one state, over its free degrees of freedom, as factors `L D L^T`.
///
/// By Sylvester's law of inertia the signs of D are those of the eigenvalues. Nothing is pivoted: where that
/// costs accuracy, solutions are refined once with the matrix itself.
#[derive(Debug)]
pub struct Tangent<'s> {
    pub(super) equations: Equations<'s>,
    pub(super) matrix: Matrix,
    pub(super) factor: Factor,
    negative: usize,
    /// Of which state the factors are, where they are.
    state: Option<(Configuration, f64)>,
}

impl Structure {
    /// The tangent at `at` under `load_factor` times the loads.
    ///
    /// # Errors
    /// [`Refused`] where the structure is wrong, too large, or singular there.
    pub fn tangent(&self, at: &Configuration, load_factor: f64) -> Result<Tangent<'_>, Refused> {
        self.check_configuration(at)?;
        let mut tangent = Tangent::new(self)?;
        match tangent.set(at, load_factor) {
            true => Ok(tangent),
            false => Err(Refused::Singular { at: format!("load factor {load_factor}") }),
        }
    }
}

impl<'s> Tangent<'s> {
    /// Finds the order of elimination; [`Tangent::set`] must follow.
    pub(super) fn new(structure: &'s Structure) -> Result<Self, Refused> {
        let equations = Equations::new(structure)?;
        let rows = equations.rows.len();
        if rows == 0 {
            return Err(Refused::at("supports", "they hold every node", "a free degree of freedom"));
        }
        let matrix = Matrix::new(structure, &equations.rows);
        let factor = Factor::new(matrix.structure()).ok_or(Refused::OutOfMemory { rows })?;
        Ok(Self { equations, matrix, factor, negative: 0, state: None })
    }

    /// Assembles and factorises at a state, unless that was the last one; whether there are factors.
    pub(super) fn set(&mut self, at: &Configuration, load_factor: f64) -> bool {
        if self.state.as_ref().is_some_and(|(own, factor)| *factor == load_factor && own == at) {
            return true;
        }
        let Self { equations, matrix, factor, negative, .. } = self;
        matrix.clear();
        let mut add = |i, j, block| matrix.add(&equations.rows, i, j, block);
        equations.structure.blocks(equations.size, at, &mut add);
        equations.structure.loads.blocks(load_factor, &at.positions, &mut add);
        let count = factor.factorise(matrix.as_ref()).or_else(|| {
            // At a critical point a pivot may vanish: no nearer to it than by rounding.
            let ones = vec![1.0; equations.rows.len()];
            let shift = equations.rounding / equations.size;
            factor.factorise(matrix.shifted(shift, &ones))
        });
        *negative = count.unwrap_or_default();
        self.state = count.map(|_| (at.clone(), load_factor));
        count.is_some()
    }

    /// The displacements, by node, that forces by node cause to first order; supports hold.
    #[must_use]
    pub fn solve(&mut self, forces: &[DVec3]) -> Vec<DVec3> {
        let column = self.equations.rows.gather(forces);
        let column = self.solve_rows(&column);
        self.equations.rows.scatter(&column)
    }

    pub(super) fn solve_rows(&mut self, right: &[f64]) -> Vec<f64> {
        let mut x = right.to_vec();
        self.factor.solve(&mut x);
        let mut rest: Vec<f64> = self.matrix.times(&x).iter().zip(right).map(|(p, r)| r - p).collect();
        if dot(&rest, &rest) > ACCURATE * ACCURATE * dot(right, right) {
            self.factor.solve(&mut rest);
            x.iter_mut().zip(rest).for_each(|(x, r)| *x += r);
        }
        x
    }

    /// Eigenvalues below 0.
    pub(super) fn negative(&self) -> usize {
        self.negative
    }

    /// Which directions cost energy. Two factorisations more; those of the tangent itself are made anew.
    #[must_use]
    pub fn inertia(&mut self) -> Inertia {
        let threshold = NEUTRAL * self.matrix.largest_diagonal();
        let below = |count: Option<usize>| count.unwrap_or(0);
        let negative = below(self.below(-threshold));
        let at_most = below(self.below(threshold));
        Inertia { negative, neutral: at_most.saturating_sub(negative) }
    }

    /// How many eigenvalues lie below `value`; `None` where it is one.
    pub(super) fn below(&mut self, value: f64) -> Option<usize> {
        let ones = vec![1.0; self.equations.rows.len()];
        let count = self.factor.factorise(self.matrix.shifted(-value, &ones));
        self.factor.factorise(self.matrix.as_ref());
        // At a critical point these may be none.
        self.state = None;
        count
    }

    /// The eigenvalues nearest to 0, by size, with their unit vectors by row: to some six digits, or after a few rounds. `space`
    /// is where they are sought first, empty where nothing is known, and then where they were found.
    pub(super) fn nearest_to_zero(&mut self, count: usize, space: &mut Vec<Vec<f64>>) -> Vec<eigen::Pair> {
        let nothing = NEUTRAL * self.matrix.largest_diagonal();
        let patience = eigen::Patience { tolerance: 1e-6, nothing, rounds: 12 };
        let Self { equations, matrix, factor, .. } = self;
        let solve = |right: &[f64]| {
            let mut x = right.to_vec();
            factor.solve(&mut x);
            x
        };
        eigen::nearest_to_zero(equations.rows.len(), count, patience, space, |x| matrix.times(x), solve)
    }

    /// Solves `[K b; c^T d] [x; y] = [f; g]` by mixed block elimination, which is accurate though K be almost singular:
    /// W. Govaerts, Stable solvers and block elimination for bordered systems, SIAM J. Matrix Anal. Appl. 12 (1991).
    pub(super) fn solve_bordered(&mut self, b: &[f64], (c, d): (&[f64], f64), f: &[f64], g: f64) -> (Vec<f64>, f64) {
        let left = self.solve_rows(c);
        let first = (g - dot(&left, f)) / (d - dot(&left, b));
        let right = self.solve_rows(b);
        let f: Vec<f64> = f.iter().zip(b).map(|(f, b)| f - b * first).collect();
        let w = self.solve_rows(&f);
        let second = (g - d * first - dot(c, &w)) / (d - dot(c, &right));
        (w.iter().zip(&right).map(|(w, v)| w - v * second).collect(), first + second)
    }
}
