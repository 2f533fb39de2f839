//! States along the way: folding depends on its path, and an animation shows it.

use std::ops::ControlFlow;

use super::{Failed, Folded, Progress, Solver, State, Stop};
use crate::error::Short;
use crate::model::Model;
use crate::scene::Scene;

/// Percentages of `frames` + 1 states from 0 to `percent`, both included, evenly spaced.
#[must_use]
pub fn frame_percents(percent: f64, frames: u32) -> Vec<f64> {
    (0..=frames).map(|i| percent * f64::from(i) / f64::from(frames.max(1))).collect()
}

/// One stage of a path did not hold.
#[derive(Clone, Debug, thiserror::Error)]
#[error("at {} %: {failed}", Short(*percent))]
pub struct PathFailed {
    /// The states before it, all of which held.
    pub states: Vec<Folded>,
    /// The percentage that it was on its way to.
    pub percent: f64,
    /// What happened, with the last good state of that stage.
    #[source]
    pub failed: Failed,
}

/// Folds to each percentage in turn, every one from the state before it, the first from the sheet at rest;
/// [`fold_path_from`] begins elsewhere.
///
/// # Errors
/// As for that.
pub fn fold_path(
    model: &Model,
    solver: &dyn Solver,
    percents: &[f64],
    observe: &mut dyn FnMut(usize, Progress) -> ControlFlow<()>,
) -> Result<Vec<Folded>, PathFailed> {
    fold_path_from(model, solver, &State::at_rest(model), percents, observe)
}

/// Folds to each percentage in turn, every one from the state before it, the first from `first`. `observe` is
/// told the index of the stage in `percents` and how far its solver has come; where it breaks, the path ends with the state
/// at hand.
///
/// # Errors
/// [`PathFailed`] from the first that does not hold, with the states before it.
pub fn fold_path_from(
    model: &Model,
    solver: &dyn Solver,
    first: &State,
    percents: &[f64],
    observe: &mut dyn FnMut(usize, Progress) -> ControlFlow<()>,
) -> Result<Vec<Folded>, PathFailed> {
    let mut states: Vec<Folded> = Vec::with_capacity(percents.len());
    let mut session = solver.session(model);
    for (stage, &percent) in percents.iter().enumerate() {
        let start = states.last().map_or(first, |folded| &folded.state);
        match session.fold(start, &Scene::percent(percent), &mut |progress| observe(stage, progress)) {
            Ok(folded) => {
                let cancelled = folded.stop == Stop::Cancelled;
                states.push(folded);
                if cancelled {
                    break;
                }
            }
            Err(failed) => return Err(PathFailed { states, percent, failed }),
        }
    }
    Ok(states)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::catalog;
    use crate::model::Material;
    use crate::solve::{Dynamics, TimeStep};

    /// Steps that hold up to a percentage, and far too long ones beyond it.
    struct Breaks {
        beyond: f64,
    }

    impl Solver for Breaks {
        fn fold(
            &self,
            model: &Model,
            start: &State,
            scene: &Scene,
            observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
        ) -> Result<Folded, Failed> {
            let time_step =
                if scene.targets.label() > Some(self.beyond) { TimeStep::Fixed(10.0) } else { TimeStep::Safe };
            let solver = Dynamics { time_step, steps: Some(200), ..Dynamics::default() };
            solver.fold(model, start, scene, observe)
        }
    }

    #[test]
    fn states_before_a_divergence_are_handed_back() {
        let pattern = catalog::generate("single-crease", &[]).expect("a pattern");
        let model = Model::new(&pattern, &Material::default()).expect("a model");
        let mut stages = Vec::new();
        let percents = frame_percents(90.0, 3);
        let failed = fold_path(&model, &Breaks { beyond: 45.0 }, &percents, &mut |stage, _| {
            stages.push(stage);
            ControlFlow::Continue(())
        });
        let failed = failed.expect_err("a step of 10 does not hold");
        let reached: Vec<f64> = failed.states.iter().filter_map(Folded::percent).collect();
        assert_eq!((reached, failed.percent), (vec![0.0, 30.0], 60.0));
        assert!(failed.to_string().starts_with("at 60 %: diverged at step "), "{failed}");
        let last = &failed.states[1].state;
        assert_eq!(
            failed.failed.last_state().positions,
            last.positions,
            "the third stage began where the second ended"
        );
        stages.dedup();
        assert!(stages.is_sorted() && stages.last() <= Some(&2));
    }
}
