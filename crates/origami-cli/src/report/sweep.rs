//! The tables of `origami sweep`: one row for each sheet, as JSON and as CSV.

use std::io::Write;

use origami::Error;
use origami::model::Material;
use origami::solve::Point;
use serde::Serialize;
use serde_json::Value;

use super::{Adapter, Divergence, Measured, SceneFacts, Seconds};

/// All of sweep.json.
#[derive(Debug, Serialize)]
pub(crate) struct Table {
    /// As named on the command line.
    pub(crate) input: String,
    /// `relax`, `dynamics` or `newton`.
    pub(crate) solver: &'static str,
    /// `cpu` or `gpu`.
    pub(crate) backend: &'static str,
    /// The GPU.
    pub(crate) adapter: Option<Adapter>,
    /// `f64` or `mixed` on the processor, `f32` on a GPU.
    pub(crate) precision: &'static str,
    /// Distance from the equilibrium at which to stop, in radii.
    pub(crate) tolerance: f64,
    /// What keeps its place in the folded sheets.
    pub(crate) attitude: String,
    /// What was built: materials differ in what they need.
    pub(crate) scenes: Vec<SceneFacts>,
    /// In the order in which they vary.
    pub(crate) instances: Vec<Row>,
    /// How long each part took.
    pub(crate) seconds: Seconds,
}

/// What came of one sheet.
#[derive(Debug, Serialize)]
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
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) outputs: Vec<String>,
}

/// What varies, but for the percentage.
#[derive(Debug, Serialize)]
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
        let Material { ea, k_fold, k_facet, k_face, zeta } = *material;
        Self { ea, k_fold, k_facet, k_face, zeta, perturbation: point.perturbation, seed: point.seed }
    }
}

/// The columns of sweep.csv: where a row of the JSON has them. Numbers and words of our own, which need no quotes.
const COLUMNS: [&str; 31] = [
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

/// As CSV (RFC 4180): a line of names, then a line for each row; what is null or absent in JSON is empty.
pub(crate) fn write_csv(writer: &mut dyn Write, rows: &[Row]) -> Result<(), Error> {
    let io = |source| Error::Io { path: "-".to_owned(), source };
    write!(writer, "{}\r\n", COLUMNS.join(",").replace('/', "_")).map_err(io)?;
    for row in rows {
        let row = serde_json::to_value(row).map_err(|error| io(error.into()))?;
        let cells = COLUMNS.map(|column| cell(row.pointer(&format!("/{column}"))));
        write!(writer, "{}\r\n", cells.join(",")).map_err(io)?;
    }
    Ok(())
}

fn cell(value: Option<&Value>) -> String {
    match value {
        None | Some(Value::Null) => String::new(),
        Some(Value::String(word)) => word.clone(),
        Some(other) => other.to_string(),
    }
}

/// As JSON.
pub(crate) fn write_json(writer: &mut dyn Write, table: &Table) -> Result<(), Error> {
    let io = |source| Error::Io { path: "-".to_owned(), source };
    serde_json::to_writer_pretty(&mut *writer, table).map_err(|error| io(error.into()))?;
    writer.write_all(b"\n").map_err(io)
}
