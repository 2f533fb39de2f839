//! Eigenvalues and eigenvectors of a small symmetric matrix.
//!
//! Jacobi's method: turns in the plane of two axes, each of which makes one entry off the diagonal 0, until all are.
//! It is slow for large matrices and as exact as can be for small ones. Golub and Van Loan, Matrix Computations, 8.5.

/// Sweeps over all entries; convergence is quadratic, and six or so are enough.
const SWEEPS: usize = 30;

/// The eigenvalues of a symmetric matrix of finite numbers, the largest first, each with a unit eigenvector.
pub(super) fn eigenvectors<const N: usize>(mut matrix: [[f64; N]; N]) -> [(f64, [f64; N]); N] {
    // Its rows become the eigenvectors.
    let mut vectors = [[0.0; N]; N];
    for (i, row) in vectors.iter_mut().enumerate() {
        row[i] = 1.0;
    }
    for _ in 0..SWEEPS {
        let mut turned = false;
        for p in 0..N {
            for q in p + 1..N {
                turned |= turn(&mut matrix, &mut vectors, p, q);
            }
        }
        if !turned {
            break;
        }
    }
    let mut pairs: [(f64, [f64; N]); N] = std::array::from_fn(|i| (matrix[i][i], vectors[i]));
    // Of equal ones the last first.
    pairs.reverse();
    pairs.sort_by(|a, b| b.0.total_cmp(&a.0));
    pairs
}

/// Turns the axes `p` and `q` so that the entry between them becomes 0; false where it is already nothing beside theirs.
fn turn<const N: usize>(matrix: &mut [[f64; N]; N], vectors: &mut [[f64; N]; N], p: usize, q: usize) -> bool {
    let entry = matrix[p][q];
    if entry.abs() <= f64::EPSILON * f64::EPSILON * (matrix[p][p].abs() + matrix[q][q].abs()) {
        return false;
    }
    let half = (matrix[q][q] - matrix[p][p]) / (2.0 * entry);
    let tan = half.signum() / (half.abs() + half.hypot(1.0));
    let cos = 1.0 / tan.hypot(1.0);
    let sin = tan * cos;
    let rotate = |a: f64, b: f64| (cos * a - sin * b, sin * a + cos * b);
    for row in matrix.iter_mut() {
        (row[p], row[q]) = rotate(row[p], row[q]);
    }
    for rows in [&mut *matrix, vectors] {
        let (before, from_q) = rows.split_at_mut(q);
        for (a, b) in before[p].iter_mut().zip(&mut from_q[0]) {
            (*a, *b) = rotate(*a, *b);
        }
    }
    // But for rounding they are.
    (matrix[p][q], matrix[q][p]) = (0.0, 0.0);
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn times<const N: usize>(matrix: &[[f64; N]; N], vector: &[f64; N]) -> [f64; N] {
        matrix.map(|row| row.iter().zip(vector).map(|(a, b)| a * b).sum())
    }

    fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    #[test]
    fn the_vector_is_turned_into_a_multiple_of_itself_and_none_is_stretched_more() {
        for seed in 0..50 {
            let entry = |i: usize, j: usize| (f64::from(seed) + 1.7 * (i * j) as f64 + 0.9 * (i + j) as f64).sin();
            let matrix: [[f64; 4]; 4] = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
            let pairs = eigenvectors(matrix);
            for (value, vector) in pairs {
                let stretched = times(&matrix, &vector);
                let off = std::array::from_fn::<_, 4, _>(|i| stretched[i] - value * vector[i]);
                assert!((dot(&vector, &vector) - 1.0).abs() < 1e-14 && dot(&off, &off) < 1e-28, "{seed}: {off:?}");
            }
            assert!(pairs.is_sorted_by(|a, b| a.0 >= b.0));
            let value = pairs[0].0;
            for other in 0..200 {
                let other: [f64; 4] = std::array::from_fn(|i| (f64::from(other) * (1.0 + i as f64)).cos());
                assert!(dot(&other, &times(&matrix, &other)) <= (value + 1e-12) * dot(&other, &other), "{seed}");
            }
        }
    }

    #[test]
    fn a_diagonal_matrix_has_its_axes() {
        let axes = eigenvectors([[1.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 2.0]]);
        assert_eq!(axes, [(3.0, [0.0, 1.0, 0.0]), (2.0, [0.0, 0.0, 1.0]), (1.0, [1.0, 0.0, 0.0])]);
        assert!(eigenvectors([[0.0; 2]; 2]).iter().all(|(value, _)| *value == 0.0));
    }
}
