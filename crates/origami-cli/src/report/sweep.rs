//! The tables of `origami sweep`: one row for each sheet, as JSON and as CSV.

use origami::model::Material;
use origami::solve::Point;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::args::Shard;

use super::{Adapter, By, Divergence, Measured, Seconds};

/// What sweep.json begins with: all that a sweep goes on with must have been made with the same.
#[derive(Debug, Serialize)]
pub(crate) struct Head {
    /// As named on the command line.
    pub(crate) input: String,
    /// `relax`, `dynamics`, `newton` or `reflect`.
    pub(crate) solver: &'static str,
    /// `cpu` or `gpu`.
    pub(crate) backend: &'static str,
    /// What decided that.
    pub(crate) backend_by: By,
    /// The GPU.
    pub(crate) adapter: Option<Adapter>,
    /// `f64` or `mixed` on the processor, `f32` on a GPU.
    pub(crate) precision: &'static str,
    /// Distance from the equilibrium at which to stop, in radii.
    pub(crate) tolerance: f64,
    /// What keeps its place in the folded sheets.
    pub(crate) attitude: String,
    /// What was asked for.
    pub(crate) settings: Asked,
}

/// What was asked for besides.
#[derive(Debug, Serialize)]
pub(crate) struct Asked {
    /// The program's.
    pub(crate) version: &'static str,
    /// A number that another pattern has not.
    pub(crate) pattern: String,
    /// How many sheets.
    pub(crate) count: usize,
    pub(crate) percents: Vec<f64>,
    pub(crate) perturbations: Vec<f64>,
    pub(crate) seeds: u64,
    pub(crate) ea: Vec<f64>,
    pub(crate) k_fold: Vec<f64>,
    pub(crate) k_facet: Vec<f64>,
    pub(crate) k_face: Vec<f64>,
    pub(crate) zeta: Vec<f64>,
    pub(crate) max_steps: u64,
    pub(crate) steps: Option<u64>,
    pub(crate) ramp: Option<u32>,
    pub(crate) residual: Option<f64>,
    /// `paper`, `safe` or a number.
    pub(crate) time_step: String,
    pub(crate) integrator: &'static str,
    /// Formats of the folded sheets.
    pub(crate) folded: Vec<&'static str>,
    /// Which part of the sweep these are.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) shard: Option<Shard>,
}

/// What sweep.json ends with.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Tail<'a, Scene> {
    /// Whether all sheets have a row.
    pub(crate) complete: bool,
    /// What was built: materials differ in what they need.
    pub(crate) scenes: &'a [Scene],
    /// How long each part took.
    pub(crate) seconds: Seconds,
}

/// All of it, for the line about it.
#[derive(Debug)]
pub(crate) struct Table {
    pub(crate) head: Head,
    /// In the order in which they vary.
    pub(crate) instances: Vec<Row>,
    pub(crate) seconds: Seconds,
}

/// What came of one sheet.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Row {
    pub(crate) index: usize,
    /// Its place in the table's scenes.
    pub(crate) scene: usize,
    #[serde(flatten)]
    pub(crate) varied: Varied,
    #[serde(flatten)]
    pub(crate) measured: Measured,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) diverged: Option<Divergence>,
    /// Why what computes gave up.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) error: Option<String>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) outputs: Vec<String>,
}

/// What varies, but for the percentage.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Varied {
    ea: f64,
    k_fold: f64,
    k_facet: f64,
    k_face: f64,
    zeta: f64,
    perturbation: f64,
    seed: u64,
}

impl Varied {
    pub(crate) fn new(material: &Material, point: &Point) -> Self {
        let Material { ea, k_fold, k_facet, k_face, zeta, .. } = *material;
        Self { ea, k_fold, k_facet, k_face, zeta, perturbation: point.perturbation, seed: point.seed }
    }
}

/// The columns of sweep.csv: where a row of the JSON has them. Numbers and words of our own, which need no quotes.
const COLUMNS: [&str; 32] = [
    "index",
    "ea",
    "k_fold",
    "k_facet",
    "k_face",
    "zeta",
    "perturbation",
    "seed",
    "percent",
    "converged",
    "stop",
    "steps",
    "attempts",
    "residual",
    "distance",
    "strain/mean",
    "strain/rms",
    "strain/max",
    "nodes_strain/mean",
    "energy/beams",
    "energy/creases",
    "energy/corner_angles",
    "energy/areas",
    "energy/total",
    "angle_error_deg/mean",
    "angle_error_deg/max",
    "tangled_creases",
    "diverged/vertex",
    "diverged/step",
    "diverged/quantity",
    "diverged/value",
    "scene",
];

/// The line of names that a CSV table (RFC 4180) begins with.
pub(crate) fn csv_names() -> String {
    format!("{}\r\n", COLUMNS.join(",").replace('/', "_"))
}

/// A line of it: what is null or absent in JSON is empty.
pub(crate) fn csv_line(row: &Row) -> serde_json::Result<String> {
    let row = serde_json::to_value(row)?;
    let cells = COLUMNS.map(|column| cell(row.pointer(&format!("/{column}"))));
    Ok(format!("{}\r\n", cells.join(",")))
}

fn cell(value: Option<&Value>) -> String {
    match value {
        None | Some(Value::Null) => String::new(),
        Some(Value::String(word)) => word.clone(),
        Some(other) => other.to_string(),
    }
}

/// The JSON up to the rows, which follow.
pub(crate) fn json_begin(head: &impl Serialize) -> serde_json::Result<String> {
    let text = serde_json::to_string_pretty(head)?;
    Ok(format!("{},\n  \"instances\": [", text.strip_suffix("\n}").unwrap_or(&text)))
}

/// A row, the first of all or not.
pub(crate) fn json_row(row: &Row, is_first: bool) -> serde_json::Result<String> {
    let text = serde_json::to_string_pretty(row)?.replace('\n', "\n    ");
    Ok(format!("{}\n    {text}", if is_first { "" } else { "," }))
}

/// What follows the rows, if there are any.
pub(crate) fn json_end(tail: Tail<'_, impl Serialize>, has_rows: bool) -> serde_json::Result<String> {
    let text = serde_json::to_string_pretty(&tail)?;
    let text = text.strip_prefix("{\n").unwrap_or(&text);
    Ok(format!("{}],\n{text}\n", if has_rows { "\n  " } else { "" }))
}
