//! What structural analysis found, as dicts of arrays.

use numpy::{PyArray1, PyArray3, PyArrayMethods};
use origami::analysis::{Gradient, Mode, Trace};
use origami::glam::DVec3;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use pythonize::pythonize;
use serde_json::json;

use crate::arrays::{table, vectors};

/// A dict that is filled in turn.
pub(crate) struct Table<'py>(Bound<'py, PyDict>);

impl<'py> Table<'py> {
    pub(crate) fn new(py: Python<'py>) -> Self {
        Self(PyDict::new(py))
    }

    pub(crate) fn with(self, name: &str, value: impl IntoPyObject<'py>) -> PyResult<Self> {
        self.0.set_item(name, value)?;
        Ok(self)
    }

    pub(crate) fn finish(self) -> Bound<'py, PyDict> {
        self.0
    }
}

/// Vectors by node of several states, of shape (states, nodes, 3).
pub(crate) fn blocks<'py, 'a>(
    py: Python<'py>,
    states: impl Iterator<Item = &'a [DVec3]>,
) -> PyResult<Bound<'py, PyArray3<f64>>> {
    let (mut count, mut nodes, mut numbers) = (0, 0, Vec::new());
    for state in states {
        count += 1;
        nodes = state.len();
        numbers.extend(state.iter().flat_map(DVec3::to_array));
    }
    PyArray1::from_vec(py, numbers).reshape([count, nodes, 3])
}

/// The gradient of a result.
pub(crate) fn gradient(py: Python<'_>, gradient: Gradient) -> PyResult<Bound<'_, PyDict>> {
    let numbers = |numbers| PyArray1::from_vec(py, numbers);
    Table::new(py)
        .with("rest_angles", numbers(gradient.rest_angles))?
        .with("hinge_stiffnesses", numbers(gradient.hinge_stiffnesses))?
        .with("rest_lengths", numbers(gradient.rest_lengths))?
        .with("rigidities", numbers(gradient.rigidities))?
        .with("loads", vectors(py, gradient.loads)?)?
        .with("held", vectors(py, gradient.held)?)?
        .with("load_factor", gradient.load_factor)
        .map(Table::finish)
}

/// A path, point by point.
pub(crate) fn path<'py>(py: Python<'py>, trace: &Trace) -> PyResult<Bound<'py, PyDict>> {
    let points = &trace.points;
    let column = |of: fn(&origami::analysis::Point) -> f64| PyArray1::from_vec(py, points.iter().map(of).collect());
    let hinges = points.first().map_or(0, |point| point.configuration.fold_angles.len());
    let angles = points.iter().flat_map(|point| point.configuration.fold_angles.iter().copied()).collect();
    let negative: Vec<i64> = points.iter().map(|point| i64::try_from(point.negative).unwrap_or(i64::MAX)).collect();
    let events: Vec<&str> = points.iter().map(|point| point.event.name()).collect();
    let equilibria: Vec<_> = trace
        .equilibria()
        .iter()
        .map(|state| json!({"point": state.point, "energy": state.energy, "index": state.index, "barrier": state.barrier}))
        .collect();
    Table::new(py)
        .with("load_factor", column(|point| point.load_factor))?
        .with("arc", column(|point| point.arc))?
        .with("energy", column(|point| point.energies.total()))?
        .with("work", column(|point| point.work))?
        .with("negative", PyArray1::from_vec(py, negative))?
        .with("nearest_eigenvalue", column(|point| point.nearest_eigenvalue))?
        .with("residual", column(|point| point.residual))?
        .with("event", events)?
        .with("positions", blocks(py, points.iter().map(|point| point.configuration.positions.as_slice()))?)?
        .with("fold_angles", table(py, angles, hinges)?)?
        .with("ended", pythonize(py, &trace.ended)?)?
        .with("equilibria", pythonize(py, &equilibria)?)
        .map(Table::finish)
}

/// Vibrations; `hertz` turns the root of an eigenvalue into a frequency.
pub(crate) fn modes<'py>(py: Python<'py>, modes: &[Mode], hertz: Option<f64>) -> PyResult<Bound<'py, PyDict>> {
    let numbers = |of: &dyn Fn(&Mode) -> f64| PyArray1::from_vec(py, modes.iter().map(of).collect());
    let kinds: Vec<_> = modes.iter().map(|mode| json!(mode.kind)).collect();
    Table::new(py)
        .with("eigenvalue", numbers(&|mode| mode.eigenvalue))?
        .with("frequency_hz", hertz.map(|hertz| numbers(&|mode| mode.eigenvalue.max(0.0).sqrt() * hertz)))?
        .with("kind", pythonize(py, &kinds)?)?
        .with("shape", blocks(py, modes.iter().map(|mode| mode.shape.as_slice()))?)
        .map(Table::finish)
}
