//! A few eigenvalues of a large symmetric matrix: those next to 0 of what is inverted. Subspace iteration with Rayleigh and
//! Ritz: K. J. Bathe, Finite Element Procedures, section 11.6.

use faer::{Mat, Side};

/// An eigenvalue with its unit vector.
pub(super) type Pair = (f64, Vec<f64>);

/// When subspace iteration ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Patience {
    /// No eigenvalue that is wanted changes any more by this share of itself ...
    pub(super) tolerance: f64,
    /// ... or of this, which counts as 0 ...
    pub(super) nothing: f64,
    /// ... or after so many rounds.
    pub(super) rounds: u32,
}

/// The `wanted` eigenvalues of least size of a matrix of `size` rows, by size; `times` multiplies with it, `solve` with its
/// inverse. They are sought within `space` first, where it has as many columns as it is to have, and that is where it has come to
/// in the end: for a matrix that is almost the same.
pub(super) fn nearest_to_zero(
    size: usize,
    wanted: usize,
    patience: Patience,
    space: &mut Vec<Vec<f64>>,
    times: impl Fn(&[f64]) -> Vec<f64>,
    mut solve: impl FnMut(&[f64]) -> Vec<f64>,
) -> Vec<Pair> {
    let wanted = wanted.min(size);
    // A few more columns than are wanted make those converge faster.
    let columns = size.min(wanted + wanted / 2 + 3);
    // Any directions will do that no symmetry forbids.
    let irregular = |i: usize, c: usize| ((i + 1) as f64 * ((c + 2) as f64).sqrt()).fract() - 0.5;
    if space.len() == columns {
        // What symmetry keeps out of the space must have a way in.
        space.truncate(columns - 1);
    } else {
        space.clear();
    }
    space.extend((space.len()..columns).map(|c| (0..size).map(|i| irregular(i, c)).collect()));
    orthonormalise(space);
    let mut last: Vec<f64> = Vec::new();
    let mut pairs = Vec::new();
    for _ in 0..patience.rounds {
        for column in space.iter_mut() {
            *column = solve(column);
        }
        orthonormalise(space);
        pairs = ritz(space, &times);
        let values: Vec<f64> = pairs.iter().take(wanted).map(|(value, _)| *value).collect();
        let settled =
            |(new, old): (&f64, &f64)| (new - old).abs() <= (patience.tolerance * new.abs()).max(patience.nothing);
        let done = last.len() == values.len() && values.iter().zip(&last).all(settled);
        last = values;
        // Without directions for all columns those that there are go on.
        if pairs.len() == space.len() {
            *space = pairs.iter().map(|(_, vector)| vector.clone()).collect();
        }
        if done {
            break;
        }
    }
    pairs.truncate(wanted);
    pairs
}

/// The eigenvalues of the matrix within a space of orthonormal columns, by size.
fn ritz(space: &[Vec<f64>], times: &impl Fn(&[f64]) -> Vec<f64>) -> Vec<Pair> {
    let images: Vec<Vec<f64>> = space.iter().map(|column| times(column)).collect();
    let small = Mat::from_fn(space.len(), space.len(), |i, j| dot(&space[i.min(j)], &images[i.max(j)]));
    let Ok(eigen) = small.self_adjoint_eigen(Side::Lower) else { return Vec::new() };
    let (values, vectors) = (eigen.S(), eigen.U());
    let pair = |k: usize| {
        let mut own = vec![0.0; space[0].len()];
        for (j, column) in space.iter().enumerate() {
            own.iter_mut().zip(column).for_each(|(x, c)| *x += vectors[(j, k)] * c);
        }
        (values[k], own)
    };
    let mut pairs: Vec<Pair> = (0..space.len()).map(pair).collect();
    pairs.sort_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
    pairs
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Gram and Schmidt, twice.
fn orthonormalise(columns: &mut [Vec<f64>]) {
    for i in 0..columns.len() {
        let (before, from) = columns.split_at_mut(i);
        let own = &mut from[0];
        for _ in 0..2 {
            for other in before.iter() {
                let along = dot(own, other);
                own.iter_mut().zip(other).for_each(|(x, o)| *x -= along * o);
            }
            let length = dot(own, own).sqrt();
            if length > 0.0 {
                own.iter_mut().for_each(|x| *x /= length);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_chain_they_are_known() {
        // 2 on and -1 beside the diagonal: 2 - 2 cos(k pi / (n + 1)), less a shift that makes one negative.
        let (size, shift) = (60, 0.01);
        let times = |x: &[f64]| -> Vec<f64> {
            let at = |i: Option<usize>| i.and_then(|i| x.get(i)).copied().unwrap_or(0.0);
            (0..size).map(|i| (2.0 - shift) * x[i] - at(i.checked_sub(1)) - at(Some(i + 1))).collect()
        };
        // Thomas' algorithm.
        let solve = |b: &[f64]| -> Vec<f64> {
            let (mut c, mut d) = (vec![0.0; size], b.to_vec());
            for i in 0..size {
                let (before, own) = if i > 0 { (c[i - 1], d[i - 1]) } else { (0.0, 0.0) };
                let pivot = 2.0 - shift + before;
                c[i] = -1.0 / pivot;
                d[i] = (d[i] + own) / pivot;
            }
            for i in (0..size - 1).rev() {
                d[i] -= c[i] * d[i + 1];
            }
            d
        };
        let patience = Patience { tolerance: 1e-14, nothing: 0.0, rounds: 200 };
        let pairs = nearest_to_zero(size, 5, patience, &mut Vec::new(), times, solve);
        let angle = |k: usize| std::f64::consts::PI * k as f64 / (size + 1) as f64;
        let mut wanted: Vec<f64> = (1..=size).map(|k| 2.0 - shift - 2.0 * angle(k).cos()).collect();
        wanted.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        assert!(wanted[..5].iter().any(|value| *value < 0.0));
        for ((value, vector), wanted) in pairs.iter().zip(&wanted) {
            assert!((value - wanted).abs() < 1e-12, "{value} is not {wanted}");
            let rest: Vec<f64> = times(vector).iter().zip(vector).map(|(a, v)| a - value * v).collect();
            assert!(dot(&rest, &rest).sqrt() < 1e-6 && (dot(vector, vector) - 1.0).abs() < 1e-12);
        }
    }
}
