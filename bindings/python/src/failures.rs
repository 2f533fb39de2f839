//! Solvers without a result, as exceptions.

use origami::solve::{Diverged, Failed, PathFailed, Quantity};
use pyo3::prelude::*;
use serde_json::{Map, Value, json};

use crate::arrays::vectors;
use crate::errors::{exception, refused_as};
use crate::model::Sheet;

/// Why a solver has no result.
pub(crate) fn failed(sheet: &Sheet, failed: &Failed) -> PyErr {
    let message = failed.to_string();
    match failed {
        Failed::Diverged(diverged) => exception("Diverged", &message, divergence(diverged), |details| {
            let last_good = sheet.model.file_positions(sheet.pattern(), &diverged.last_good.positions);
            details.set_item("last_good", vectors(details.py(), last_good)?)
        }),
        Failed::Refused { .. } => refused_as(&message),
        _ => exception("BackendError", &message, Map::new(), |_| Ok(())),
    }
}

/// Why a path ended, with the percentage that it was on its way to.
pub(crate) fn path_failed(sheet: &Sheet, failed_at: &PathFailed) -> PyErr {
    let error = failed(sheet, &failed_at.failed);
    Python::attach(|py| {
        // Told, if it can be; what is wrong is told in any case.
        let _ = error.value(py).setattr("percent", failed_at.percent);
    });
    error
}

/// Where and how a state left all bounds, as `docs/REPORT.md` has it.
pub(crate) fn divergence(diverged: &Diverged) -> Map<String, Value> {
    let quantity = if diverged.quantity == Quantity::Position { "position" } else { "move" };
    let parts = json!({
        "vertex": diverged.vertex.0,
        "step": diverged.step,
        "quantity": quantity,
        "value": diverged.value,
    });
    if let Value::Object(parts) = parts { parts } else { Map::new() }
}
