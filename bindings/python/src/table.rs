//! Tables of sweeps: the lines of `sweep.csv`, byte for byte those of `origami sweep`, and their columns as arrays.

use numpy::PyArray1;
use origami::measure::{Strain, angle_error};
use origami::model::Model;
use origami::solve::{Failed, Folded, Point};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::Value;

use crate::errors::refused;
use crate::failures::divergence;
use crate::report::ending;

/// What a column holds.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Number,
    Whole,
    Flag,
    Word,
}

/// The columns, with what they hold; `docs/REPORT.md` says what they mean.
const COLUMNS: [(&str, Kind); 32] = [
    ("index", Kind::Whole),
    ("ea", Kind::Number),
    ("k_fold", Kind::Number),
    ("k_facet", Kind::Number),
    ("k_face", Kind::Number),
    ("zeta", Kind::Number),
    ("perturbation", Kind::Number),
    ("seed", Kind::Whole),
    ("percent", Kind::Number),
    ("converged", Kind::Flag),
    ("stop", Kind::Word),
    ("steps", Kind::Whole),
    ("attempts", Kind::Whole),
    ("residual", Kind::Number),
    ("distance", Kind::Number),
    ("strain_mean", Kind::Number),
    ("strain_rms", Kind::Number),
    ("strain_max", Kind::Number),
    ("nodes_strain_mean", Kind::Number),
    ("energy_beams", Kind::Number),
    ("energy_creases", Kind::Number),
    ("energy_corner_angles", Kind::Number),
    ("energy_areas", Kind::Number),
    ("energy_total", Kind::Number),
    ("angle_error_deg_mean", Kind::Number),
    ("angle_error_deg_max", Kind::Number),
    ("tangled_creases", Kind::Number),
    ("diverged_vertex", Kind::Number),
    ("diverged_step", Kind::Number),
    ("diverged_quantity", Kind::Word),
    ("diverged_value", Kind::Number),
    ("scene", Kind::Whole),
];
/// One more where the sheets are of several patterns.
const PATTERN: (&str, Kind) = ("pattern", Kind::Whole);

/// One sheet of a sweep.
pub(crate) struct Row<'a> {
    pub(crate) index: usize,
    pub(crate) scene: usize,
    /// The place of its pattern, where there are several.
    pub(crate) place: Option<usize>,
    pub(crate) point: &'a Point,
    pub(crate) model: &'a Model,
}

/// The line of a sheet.
pub(crate) fn line(row: &Row<'_>, folded: Result<Folded, Failed>) -> String {
    let material = &row.model.material;
    let mut cells: Vec<Value> = vec![row.index.into()];
    cells.extend([material.ea, material.k_fold, material.k_facet, material.k_face, material.zeta].map(Value::from));
    cells.extend([row.point.perturbation.into(), row.point.seed.into(), row.point.percent.into()]);
    match folded {
        Ok(folded) => {
            cells.extend([folded.converged().into(), ending(folded.stop).into(), folded.steps.into()]);
            cells.extend([folded.attempts.into(), folded.residual.into(), folded.distance.into()]);
            cells.extend(measures(row.model, &folded));
        }
        Err(failed) => {
            let parts =
                if let Failed::Diverged(diverged) = &failed { divergence(diverged) } else { Default::default() };
            let stop = if parts.is_empty() { "failed" } else { "diverged" };
            let part = |name: &str| parts.get(name).cloned().unwrap_or_default();
            let steps = if parts.is_empty() { 0.into() } else { part("step") };
            cells.extend([false.into(), stop.into(), steps, 1.into()]);
            cells.resize(MEASURED_TO, Value::Null);
            cells.extend(["vertex", "step", "quantity", "value"].map(part));
        }
    }
    cells.resize(COLUMNS.len() - 1, Value::Null);
    cells.push(row.scene.into());
    cells.extend(row.place.map(Value::from));
    format!("{}\r\n", cells.iter().map(cell).collect::<Vec<_>>().join(","))
}

/// Where the measures end.
const MEASURED_TO: usize = 27;

/// From `strain_mean` to `tangled_creases`.
fn measures(model: &Model, folded: &Folded) -> [Value; 12] {
    let Strain { beams, nodes, .. } = Strain::of(model, &folded.state.positions);
    let energy = folded.state.energy(model);
    let angles = angle_error(&folded.state);
    [
        beams.mean.into(),
        beams.rms.into(),
        beams.max.into(),
        nodes.mean.into(),
        energy.beams.into(),
        energy.creases.into(),
        energy.corner_angles.into(),
        energy.areas.into(),
        energy.total().into(),
        angles.mean.into(),
        angles.max.into(),
        folded.state.tangled_creases().into(),
    ]
}

/// What is null is empty.
fn cell(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(word) => word.clone(),
        other => other.to_string(),
    }
}

fn all(several: bool) -> impl Iterator<Item = (&'static str, Kind)> {
    COLUMNS.into_iter().chain(several.then_some(PATTERN))
}

/// The line of names, of a table of one pattern or of several.
#[pyfunction]
pub(crate) fn header(several: bool) -> String {
    let names: Vec<&str> = all(several).map(|(name, _)| name).collect();
    format!("{}\r\n", names.join(","))
}

/// The columns of lines as arrays, by name. What is empty is NaN; of a column of words, empty.
#[pyfunction]
pub(crate) fn columns(py: Python<'_>, lines: Vec<String>, several: bool) -> PyResult<Bound<'_, PyDict>> {
    let kinds: Vec<(&str, Kind)> = all(several).collect();
    let mut numbers: Vec<Vec<f64>> = vec![Vec::new(); kinds.len()];
    let mut words: Vec<Vec<&str>> = vec![Vec::new(); kinds.len()];
    for (i, line) in lines.iter().enumerate() {
        let cells: Vec<&str> = line.trim_end().split(',').collect();
        if cells.len() != kinds.len() {
            let expected = format!("a line of {} cells", kinds.len());
            return Err(refused(format!("line {i} of the rows"), &format!("{} cells", cells.len()), &expected));
        }
        for (column, ((name, kind), cell)) in kinds.iter().zip(&cells).enumerate() {
            match kind {
                Kind::Word => words[column].push(cell),
                Kind::Flag => numbers[column].push(f64::from(u8::from(*cell == "true"))),
                Kind::Number | Kind::Whole if cell.is_empty() => numbers[column].push(f64::NAN),
                Kind::Number | Kind::Whole => numbers[column].push(cell.parse().map_err(|_| {
                    refused(format!("{name} in line {i} of the rows"), &format!("`{cell}`"), "a number")
                })?),
            }
        }
    }
    let table = PyDict::new(py);
    for (((name, kind), numbers), words) in kinds.iter().zip(numbers).zip(words) {
        match kind {
            Kind::Number => table.set_item(name, PyArray1::from_vec(py, numbers))?,
            #[expect(clippy::cast_possible_truncation, reason = "they were whole numbers when they were written")]
            Kind::Whole => table.set_item(name, PyArray1::from_vec(py, numbers.iter().map(|x| *x as i64).collect()))?,
            Kind::Flag => table.set_item(name, PyArray1::from_vec(py, numbers.iter().map(|x| *x == 1.0).collect()))?,
            Kind::Word => table.set_item(name, py.import("numpy")?.call_method1("array", (words, "U"))?)?,
        }
    }
    Ok(table)
}
