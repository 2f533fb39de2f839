//! Sparse factorisations `P A P^T = L D L^T`, on one thread: sums have one order.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::sparse::linalg::cholesky::supernodal::SupernodalLdltRef;
use faer::sparse::linalg::cholesky::{LdltRef, SymbolicCholesky, SymbolicCholeskyRaw, factorize_symbolic_cholesky};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use faer::{Conj, MatMut, Par};

use super::matrix::STORED;

/// The factors of one matrix after another, all with entries in the same places.
#[derive(Debug)]
pub(crate) struct Factor {
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
    memory: Scratch,
}

struct Scratch(MemBuffer);

impl std::fmt::Debug for Scratch {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Scratch")
    }
}

impl Factor {
    /// Finds the order of elimination; `None` where the factors do not fit into memory.
    pub(crate) fn new(structure: &SymbolicSparseColMat<usize>) -> Option<Self> {
        let ordering = Default::default();
        let symbolic = factorize_symbolic_cholesky(structure.as_ref(), STORED, ordering, Default::default()).ok()?;
        let factorise = symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Default::default());
        let solve = symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
        let memory = Scratch(MemBuffer::try_new(factorise.or(solve)).ok()?);
        let mut values = Vec::new();
        values.try_reserve_exact(symbolic.len_val()).ok()?;
        values.resize(symbolic.len_val(), 0.0);
        Some(Self { symbolic, values, memory })
    }

    /// Factorises `matrix` and says how many of its eigenvalues are negative: by Sylvester's law of inertia as many as
    /// there are negative pivots. `None` where a pivot is zero or not a number.
    pub(crate) fn factorise(&mut self, matrix: SparseColMatRef<'_, usize, f64>) -> Option<usize> {
        let stack = MemStack::new(&mut self.memory.0);
        let (regularization, params) = (LdltRegularization::default(), Default::default());
        let factors = self.symbolic.factorize_numeric_ldlt::<f64>(
            &mut self.values,
            matrix,
            STORED,
            regularization,
            Par::Seq,
            stack,
            params,
        );
        factors.ok()?;
        let mut negative = 0;
        let mut look = |pivot: f64| {
            negative += usize::from(pivot < 0.0);
            (pivot.is_finite() && pivot != 0.0).then_some(())
        };
        match self.symbolic.raw() {
            SymbolicCholeskyRaw::Simplicial(simplicial) => {
                let columns = simplicial.col_ptr();
                columns[..simplicial.ncols()].iter().try_for_each(|start| look(self.values[*start]))?;
            }
            SymbolicCholeskyRaw::Supernodal(supernodal) => {
                let factors = SupernodalLdltRef::new(supernodal, &self.values);
                for s in 0..supernodal.n_supernodes() {
                    let block = factors.supernode(s).val();
                    (0..block.ncols()).try_for_each(|j| look(block[(j, j)]))?;
                }
            }
        }
        Some(negative)
    }

    /// Solves with the matrix factorised last.
    pub(crate) fn solve(&mut self, column: &mut [f64]) {
        let size = column.len();
        let right = MatMut::from_column_major_slice_mut(column, size, 1);
        let factors = LdltRef::new(&self.symbolic, &self.values);
        factors.solve_in_place_with_conj(Conj::No, right, Par::Seq, MemStack::new(&mut self.memory.0));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A chain of `size` unknowns with `diagonal` on and -1 beside the diagonal.
    fn chain(size: usize) -> SymbolicSparseColMat<usize> {
        let columns = (0..=size).map(|j| (2 * j).min(2 * size - 1)).collect();
        let rows = (0..size).flat_map(|j| [j, j + 1]).take(2 * size - 1).collect();
        SymbolicSparseColMat::new_checked(size, size, columns, None, rows)
    }

    fn values(size: usize, diagonal: f64) -> Vec<f64> {
        (0..2 * size - 1).map(|k| if k % 2 == 0 { diagonal } else { -1.0 }).collect()
    }

    #[test]
    fn counts_negative_eigenvalues_and_solves() {
        let size = 50;
        let structure = chain(size);
        let mut factor = Factor::new(&structure).expect("small");
        for diagonal in [2.5, 1.3, 0.1, -0.7, -3.0] {
            let values = values(size, diagonal);
            let negative = factor.factorise(SparseColMatRef::new(structure.as_ref(), &values));
            // Eigenvalues of a chain: diagonal - 2 cos(k pi / (size + 1)).
            let angle = |k: usize| std::f64::consts::PI * k as f64 / (size + 1) as f64;
            let expected = (1..=size).filter(|k| diagonal - 2.0 * angle(*k).cos() < 0.0).count();
            assert_eq!(negative, Some(expected), "{diagonal}");
            let x: Vec<f64> = (0..size).map(|i| (i as f64).sin()).collect();
            let at = |i: usize| x.get(i).copied().unwrap_or(0.0);
            let mut b: Vec<f64> =
                (0..size).map(|i| diagonal * x[i] - at(i + 1) - if i > 0 { x[i - 1] } else { 0.0 }).collect();
            factor.solve(&mut b);
            assert!(b.iter().zip(&x).all(|(b, x)| (b - x).abs() < 1e-12), "{diagonal}");
        }
        let nan = values(size, f64::NAN);
        assert_eq!(factor.factorise(SparseColMatRef::new(structure.as_ref(), &nan)), None);
    }
}
