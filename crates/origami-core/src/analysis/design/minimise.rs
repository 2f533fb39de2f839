//! The least value of a smooth function between bounds: a projected quasi-Newton method. D. P. Bertsekas, Projected Newton
//! methods for optimization problems with simple constraints, SIAM J. Control Optim. 20 (1982), with the BFGS formula for the
//! inverse of the Hessian.
//!
//! Of our own, as the quasi-Newton methods of argmin know no bounds and L-BFGS-B is Fortran. The inverse is kept whole: that of a
//! thousand unknowns has 8 MB and takes less time than an equilibrium.

use crate::analysis::eigen::dot;

/// When a minimisation ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// Evaluations after which it gives up. Default 200.
    pub evaluations: u32,
    /// It ends where the value is at most this. Default 0: where nothing leads down any more.
    pub enough: f64,
    /// It ends where no variable that is not held at a bound would change the value by more on its way from bound to bound, were
    /// it to go on as it begins. Default 1e-10.
    pub gradient: f64,
}

impl Default for Effort {
    fn default() -> Self {
        Self { evaluations: 200, enough: 0.0, gradient: 1e-10 }
    }
}

/// The share of the promised decrease that is enough.
const ENOUGH: f64 = 1e-4;
/// How often a step is halved.
const HALVINGS: u32 = 40;

/// What was found.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Minimum {
    pub(super) at: Vec<f64>,
    pub(super) value: f64,
    pub(super) evaluations: u32,
    pub(super) history: Vec<Progress>,
}

/// How far a minimisation was after so many evaluations.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Progress {
    /// Evaluations so far.
    pub evaluations: u32,
    /// The least value so far.
    pub value: f64,
    /// The largest entry of the gradient that bounds leave free, as [`Effort::gradient`] has it.
    pub gradient: f64,
}

/// A value with its gradient.
pub(super) type Slope = (f64, Vec<f64>);

/// From `at` downhill. `evaluate` gives value and gradient, none where the function is not defined; `bounds` are the least and
/// the largest of each unknown. None where the function is not defined at the start.
pub(super) fn minimise(
    at: Vec<f64>,
    bounds: &[[f64; 2]],
    effort: &Effort,
    evaluate: &mut dyn FnMut(&[f64]) -> Option<Slope>,
) -> Option<Minimum> {
    // Each unknown in shares of the range between its bounds.
    let scale = |[low, high]: &[f64; 2]| if (high - low).is_finite() && high > low { high - low } else { 1.0 };
    let scales: Vec<f64> = bounds.iter().map(scale).collect();
    let by_scale =
        |x: &[f64], power: i32| -> Vec<f64> { x.iter().zip(&scales).map(|(x, s)| x * s.powi(power)).collect() };
    let mut scaled = |x: &[f64]| {
        let (value, gradient) = evaluate(&by_scale(x, 1))?;
        Some((value, by_scale(&gradient, 1)))
    };
    let own: Vec<[f64; 2]> = bounds.iter().zip(&scales).map(|(b, s)| b.map(|x| x / s)).collect();
    let mut found = minimise_scaled(by_scale(&at, -1), &own, effort, &mut scaled)?;
    found.at = by_scale(&found.at, 1);
    found.at.iter_mut().zip(bounds).for_each(|(x, [low, high])| *x = x.clamp(*low, *high));
    Some(found)
}

fn minimise_scaled(
    at: Vec<f64>,
    bounds: &[[f64; 2]],
    effort: &Effort,
    evaluate: &mut dyn FnMut(&[f64]) -> Option<Slope>,
) -> Option<Minimum> {
    let count = at.len();
    let within = |x: &mut [f64]| x.iter_mut().zip(bounds).for_each(|(x, [low, high])| *x = x.clamp(*low, *high));
    let mut at = at;
    within(&mut at);
    let (mut value, mut gradient) = evaluate(&at)?;
    let mut evaluations = 1;
    let mut inverse = identity(count);
    let mut fresh = true;
    let mut history = Vec::new();
    loop {
        // Unknowns that lie at a bound and would leave it stay.
        let free: Vec<bool> = (0..count)
            .map(|i| !(at[i] <= bounds[i][0] && gradient[i] > 0.0 || at[i] >= bounds[i][1] && gradient[i] < 0.0))
            .collect();
        let largest = (0..count).filter(|i| free[*i]).map(|i| gradient[i].abs()).fold(0.0, f64::max);
        let progress = Progress { evaluations, value, gradient: largest };
        if history.last().is_none_or(|last: &Progress| last.value != value) {
            history.push(progress);
        }
        if value <= effort.enough || evaluations >= effort.evaluations || largest <= effort.gradient {
            break;
        }
        let along: Vec<f64> = (0..count).map(|i| if free[i] { gradient[i] } else { 0.0 }).collect();
        let direction: Vec<f64> = (0..count).map(|i| if free[i] { -dot(&inverse[i], &along) } else { 0.0 }).collect();
        let mut share = 1.0;
        let mut next = None;
        for _ in 0..HALVINGS {
            let mut trial: Vec<f64> = at.iter().zip(&direction).map(|(x, d)| x + share * d).collect();
            within(&mut trial);
            let step: Vec<f64> = trial.iter().zip(&at).map(|(new, old)| new - old).collect();
            evaluations += 1;
            let found = evaluate(&trial);
            if let Some((lower, slope)) = found.filter(|(lower, _)| *lower <= value + ENOUGH * dot(&gradient, &step)) {
                next = Some((trial, step, lower, slope));
                break;
            }
            share *= 0.5;
        }
        let Some((trial, step, lower, slope)) = next else {
            // The curvature that has been gathered may mislead: once more without it.
            if fresh {
                break;
            }
            (inverse, fresh) = (identity(count), true);
            continue;
        };
        let turned: Vec<f64> = slope.iter().zip(&gradient).map(|(new, old)| new - old).collect();
        update(&mut inverse, &step, &turned, fresh);
        (at, value, gradient, fresh) = (trial, lower, slope, false);
    }
    Some(Minimum { at, value, evaluations, history })
}

fn identity(count: usize) -> Vec<Vec<f64>> {
    (0..count).map(|i| (0..count).map(|j| f64::from(u8::from(i == j))).collect()).collect()
}

/// BFGS: what the step and the change of the gradient tell of the inverse of the Hessian. The first one also tells its scale.
fn update(inverse: &mut [Vec<f64>], step: &[f64], turned: &[f64], first: bool) {
    let curvature = dot(step, turned);
    if curvature <= 1e-14 * dot(step, step).sqrt() * dot(turned, turned).sqrt() {
        return;
    }
    if first {
        let scale = curvature / dot(turned, turned);
        inverse.iter_mut().enumerate().for_each(|(i, row)| row[i] = scale);
    }
    let image: Vec<f64> = inverse.iter().map(|row| dot(row, turned)).collect();
    let own = (1.0 + dot(turned, &image) / curvature) / curvature;
    for (i, row) in inverse.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry += own * step[i] * step[j] - (image[i] * step[j] + step[i] * image[j]) / curvature;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rosenbrock's valley.
    fn valley(x: &[f64]) -> Option<(f64, Vec<f64>)> {
        let (a, b) = (1.0 - x[0], x[1] - x[0] * x[0]);
        Some((a * a + 100.0 * b * b, vec![-2.0 * a - 400.0 * x[0] * b, 200.0 * b]))
    }

    #[test]
    fn the_end_of_a_valley_is_found_and_bounds_hold() {
        let free = [[-10.0, 10.0]; 2];
        let found = minimise(vec![-1.2, 1.0], &free, &Effort::default(), &mut valley).expect("defined");
        assert!((found.at[0] - 1.0).abs() < 1e-8 && (found.at[1] - 1.0).abs() < 1e-8, "{found:?}");
        assert!(found.evaluations < 80, "{}", found.evaluations);
        // With x at most 0.5 it is at the bound, with y = x^2.
        let bound = [[-10.0, 0.5], [-10.0, 10.0]];
        let found = minimise(vec![-1.2, 1.0], &bound, &Effort::default(), &mut valley).expect("defined");
        assert!(found.at[0] == 0.5 && (found.at[1] - 0.25).abs() < 1e-8, "{found:?}");
    }

    #[test]
    fn where_it_is_not_defined_it_does_not_go() {
        let mut root = |x: &[f64]| (x[0] > 0.0).then(|| (x[0] - x[0].ln(), vec![1.0 - 1.0 / x[0]]));
        let bounds = [[f64::NEG_INFINITY, f64::INFINITY]];
        let found = minimise(vec![5.0], &bounds, &Effort::default(), &mut root).expect("defined");
        assert!((found.at[0] - 1.0).abs() < 1e-8, "{found:?}");
        assert_eq!(minimise(vec![-1.0], &bounds, &Effort::default(), &mut root), None);
    }
}
