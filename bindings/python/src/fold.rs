//! Folding: to one state, or to several on the way.

use std::time::Instant;

use origami::Scene;
use origami::solve::{State, fold_path as path};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::Numbers;
use crate::backend::Computer;
use crate::failures::{failed, path_failed};
use crate::folded::Folded;
use crate::model::model_of;
use crate::run::Run;
use crate::scene::{hold, scene, targets};
use crate::settings::Method;
use crate::watch::Watch;

/// Folds a sheet as a solver's settings say.
#[pyfunction]
#[pyo3(signature = (solver, sheet, percent=100.0, *, targets=None, start=None, supports=None, loads=None, hold=None, gpu=None, progress=None))]
#[expect(clippy::too_many_arguments, reason = "all but the first two can be left out, and each has its name")]
pub(crate) fn fold(
    solver: &Bound<'_, PyAny>,
    sheet: &Bound<'_, PyAny>,
    percent: f64,
    targets: Option<Numbers<'_>>,
    start: Option<&Bound<'_, Folded>>,
    supports: Option<&Bound<'_, PyDict>>,
    loads: Option<&Bound<'_, PyDict>>,
    hold: Option<&Bound<'_, PyAny>>,
    gpu: Option<&Bound<'_, PyAny>>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Folded> {
    let py = solver.py();
    let method = Method::of(solver)?;
    let computer = Computer::new(&method, gpu)?;
    let model = model_of(sheet, &method)?;
    let sheet = &model.get().sheet;
    let scene = scene(sheet, self::targets(sheet, percent, targets.as_ref())?, supports, loads)?;
    let hold = self::hold(sheet, hold, &scene)?;
    let start = start.map(|folded| folded.get().start_of(sheet)).transpose()?;
    let from = if start.is_some() { "state" } else { "rest" };
    let mut watch = Watch::new(progress);
    let begun = Instant::now();
    let folded = py.detach(|| {
        let rest;
        let start = match start {
            Some(state) => state,
            None => {
                rest = State::at_rest(&sheet.model);
                &rest
            }
        };
        computer.solver().fold(&sheet.model, start, &scene, &mut |progress| watch.observe(progress))
    });
    watch.finish()?;
    let folded = folded.map_err(|error| failed(sheet, &error))?;
    let mut run = Run::new(&computer, sheet, &scene, hold, begun.elapsed().as_secs_f64());
    from.clone_into(&mut run.from);
    Ok(Folded::new(model.clone().unbind(), folded, run))
}

/// Folds a sheet to each of several percentages in turn, every one from the state before it.
#[pyfunction]
#[pyo3(signature = (solver, sheet, percents, *, hold=None, gpu=None, progress=None))]
pub(crate) fn fold_path(
    solver: &Bound<'_, PyAny>,
    sheet: &Bound<'_, PyAny>,
    percents: Vec<f64>,
    hold: Option<&Bound<'_, PyAny>>,
    gpu: Option<&Bound<'_, PyAny>>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Vec<Folded>> {
    let py = solver.py();
    let method = Method::of(solver)?;
    let computer = Computer::new(&method, gpu)?;
    let model = model_of(sheet, &method)?;
    let sheet = &model.get().sheet;
    let scene = Scene::default();
    let hold = self::hold(sheet, hold, &scene)?;
    let mut watch = Watch::new(progress);
    let begun = Instant::now();
    let states =
        py.detach(|| path(&sheet.model, computer.solver(), &percents, &mut |_, progress| watch.observe(progress)));
    watch.finish()?;
    let states = states.map_err(|error| path_failed(sheet, &error))?;
    let run = Run::new(&computer, sheet, &scene, hold, begun.elapsed().as_secs_f64());
    Ok(states.into_iter().map(|folded| Folded::new(model.clone().unbind(), folded, run.clone())).collect())
}
