//! Measures of points and of patterns, without a fold.

use numpy::PyArray2;
use origami::flat::{Fault, FlatFoldability};
use pyo3::prelude::*;
use serde_json::json;

use crate::arrays::{Rows, to_vectors, vectors};
use crate::errors::refused;
use crate::pattern::Pattern;

/// Lays points upon others by the rotation and translation that make their mean square distance least.
///
/// points, onto: shape (n, 3), each point with its partner.
///
/// Returns the largest distance left, the root of the mean square one, and where the points come to lie, of shape (n, 3).
#[pyfunction]
pub(crate) fn align<'py>(
    py: Python<'py>,
    points: Rows<'py>,
    onto: Rows<'py>,
) -> PyResult<(f64, f64, Bound<'py, PyArray2<f64>>)> {
    let (points, onto) = (to_vectors("points", &points)?, to_vectors("onto", &onto)?);
    if points.len() != onto.len() || points.is_empty() {
        return Err(refused(
            "points",
            &format!("{} points onto {}", points.len(), onto.len()),
            "as many, and at least one",
        ));
    }
    let aligned = py.detach(|| origami::measure::align(&points, &onto));
    Ok((aligned.max, aligned.rms, vectors(py, aligned.moved)?))
}

/// What can be said of a pattern's flat folding, by the keys of docs/REPORT.md.
#[pyfunction]
pub(crate) fn flat_folding<'py>(py: Python<'py>, pattern: &Bound<'py, Pattern>) -> PyResult<Bound<'py, PyAny>> {
    let pattern = pattern.get().pattern();
    let found = py.detach(|| FlatFoldability::of(pattern));
    let at = |vertex: origami::ids::VertexId| {
        let place = pattern.vertices[vertex.index()];
        [place.x, place.y]
    };
    let faults = found.faults.iter().map(|fault| {
        let off = if let Fault::Kawasaki { off } = fault.fault { Some(off.to_degrees()) } else { None };
        json!({
            "rule": fault.fault.rule(),
            "vertex": fault.vertex.0,
            "at": at(fault.vertex),
            "creases": fault.creases.iter().map(|edge| edge.0).collect::<Vec<_>>(),
            "off_deg": off,
        })
    });
    let ends = found
        .open_ends
        .iter()
        .map(|end| json!({"vertex": end.vertex.0, "at": at(end.vertex), "crease": end.crease.0, "face": end.face.0}));
    let closure =
        found.closure.map(|closure| json!({"spread": closure.spread, "vertex": closure.vertex.map(|vertex| vertex.0)}));
    let told = json!({
        "applies": found.applies(),
        "folded": found.folded,
        "partial": found.partial,
        "free": found.free,
        "checked": found.checked,
        "unchecked": found.unchecked,
        "faults": faults.collect::<Vec<_>>(),
        "open_ends": ends.collect::<Vec<_>>(),
        "closure": closure,
    });
    Ok(pythonize::pythonize(py, &told)?)
}
