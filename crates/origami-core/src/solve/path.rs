//! States along the way: folding depends on its path, and an animation shows it.

use super::{Diverged, Folded, Progress, Solver, State};
use crate::model::Model;

/// Percentages of `frames` + 1 states from 0 to `percent`, both included, evenly spaced.
#[must_use]
pub fn frame_percents(percent: f64, frames: u32) -> Vec<f64> {
    (0..=frames).map(|i| percent * f64::from(i) / f64::from(frames.max(1))).collect()
}

/// Folds to each percentage in turn, every one from the state before it, the first from the sheet at rest.
///
/// # Errors
/// [`Diverged`] from the first that does not hold; the states before it are lost, its last good one is in the error.
pub fn fold_path(
    model: &Model,
    solver: &dyn Solver,
    percents: &[f64],
    observe: &mut dyn FnMut(usize, Progress),
) -> Result<Vec<Folded>, Diverged> {
    let mut states: Vec<Folded> = Vec::with_capacity(percents.len());
    for (i, percent) in percents.iter().enumerate() {
        let start = states.last().map_or_else(|| State::at_rest(model), |f| f.state.clone());
        states.push(solver.fold(model, &start, *percent, &mut |progress| observe(i, progress))?);
    }
    Ok(states)
}
