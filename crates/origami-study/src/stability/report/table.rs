//! The table of all rows.

use origami_core::Folded;
use origami_core::solve::Stop;

use crate::crossings::crossings;
use crate::stability::found::{Found, Limit, Relaxed};
use crate::stability::row::{CaseResult, Row};
use crate::table::{Cell, Column, Table, column};

const COLUMNS: &[Column] = &[
    column("family", "family", "rows of one family vary one thing"),
    column("pattern", "pattern", "what is folded"),
    column("parameter", "parameter", "what is varied"),
    column("value", "value", "its value"),
    column("path", "%", "percentages of the fold angles that it is sent to, one after the other"),
    column("nodes", "nodes", "nodes of the model"),
    column("answer", "answer", "run; refused, with the error; panicked; left out for want of time"),
    column("paper", "paper's step", "whether it holds, or how it fails"),
    column("safe", "safe step", "whether it holds (Euler), or how it fails"),
    column("safe_verlet", "safe step, Verlet", "whether it holds (Verlet), or how it fails"),
    column("paper_step", "paper's dt", "the paper's step, in units of model time"),
    column("bound", "bound", "the bound at rest (Euler), in units of model time"),
    column("largest", "largest", "largest step that was seen to hold at rest (Euler), in units of model time"),
    column("ratio", "bound / largest", "at rest, Euler"),
    column("bound_verlet", "bound, Verlet", "the bound at rest (Verlet), in units of model time"),
    column("largest_verlet", "largest, Verlet", "largest step that was seen to hold at rest (Verlet), in model time"),
    column("ratio_verlet", "bound / largest, Verlet", "at rest, Verlet"),
    column("bound_folded", "bound, folded", "the bound at the folded equilibrium (Euler), in units of model time"),
    column("largest_folded", "largest, folded", "largest step that was seen to hold there (Euler), in model time"),
    column("ratio_folded", "bound / largest, folded", "at the folded equilibrium, Euler"),
    column("relax", "relax", "how the relaxation ended"),
    column("evaluations", "evaluations", "force evaluations of the relaxation"),
    column("estimate", "estimate", "its estimate of the distance from the equilibrium, in radii"),
    column("distance", "distance", "largest distance of a vertex from Newton's equilibrium, in radii"),
    column("saddles", "saddles", "saddles that Newton's method left on its way there"),
    column("claim", "claim true", "whether `converged` was true: the distance is at most the tolerance"),
    column("crossings", "crossings", "edges that go through triangles where the relaxation ended, by the exact test"),
    column("gpu_safe", "f32: safe step", "whether it holds on the GPU (Euler), or how it fails"),
    column(
        "gpu_after_steps",
        "f32: off after the steps",
        "largest distance from 64 bits after the same steps, in radii",
    ),
    column("gpu_relax", "f32: relax", "how the relaxation ended on the GPU"),
    column("gpu_at_equilibrium", "f32: off at the end", "largest distance from the equilibrium in 64 bits, in radii"),
];

/// Columns that the document shows.
pub(super) const SHOWN: &[&str] = &[
    "family",
    "pattern",
    "parameter",
    "value",
    "path",
    "paper",
    "safe",
    "ratio",
    "relax",
    "evaluations",
    "distance",
    "crossings",
];

/// A table of all rows, with all that was found.
pub(super) fn table(rows: &[Row]) -> Table {
    let mut table = Table::new(COLUMNS);
    for row in rows {
        let case = &row.case;
        let path: Vec<String> = case.path.iter().map(f64::to_string).collect();
        let value = (!case.parameter.is_empty()).then_some(case.value);
        let result = match &row.result {
            CaseResult::Found(_) => "run".to_owned(),
            CaseResult::Refused(error) => format!("refused: {error}"),
            CaseResult::Panicked(what) => format!("panicked: {what}"),
            CaseResult::LeftOut => "left out".to_owned(),
        };
        let mut cells = vec![
            case.family.into(),
            case.pattern_name.as_str().into(),
            case.parameter.into(),
            value.into(),
            path.join(", ").into(),
            row.found().map(|found| found.model.node_count()).into(),
            result.into(),
        ];
        match row.found() {
            Some(found) => add(found, &mut cells),
            None => cells.extend((cells.len()..COLUMNS.len() - 4).map(|_| Cell::Missing)),
        }
        let gpu = row.gpu.as_ref();
        cells.push(gpu.map(|gpu| gpu.safe.to_string()).into());
        cells.push(gpu.and_then(|gpu| gpu.after_steps).into());
        let relaxed = gpu.map(|gpu| match &gpu.relaxed {
            Ok(true) => "converged".to_owned(),
            Ok(false) => "step limit".to_owned(),
            Err(held) => held.to_string(),
        });
        cells.push(relaxed.into());
        cells.push(gpu.and_then(|gpu| gpu.at_equilibrium).into());
        table.push(cells);
    }
    table
}

fn add(found: &Found, cells: &mut Vec<Cell>) {
    let runs = [&found.paper, &found.safe, &found.safe_verlet];
    cells.extend(runs.map(|held| Cell::from(held.to_string())));
    cells.push(found.paper_step.into());
    let limits = [Some(found.at_rest), found.verlet, found.folded];
    let cells_of = |limit: Option<Limit>| {
        let largest = limit.and_then(|limit| limit.largest);
        [limit.map(|limit| limit.bound), largest, limit.and_then(Limit::ratio)].map(Cell::from)
    };
    cells.extend(limits.into_iter().flat_map(cells_of));
    cells.push(ended(&found.relaxed).into());
    let folded = found.relaxed.folded();
    cells.push(folded.map(|folded| folded.steps).into());
    cells.push(folded.map(|folded| folded.distance).filter(|distance| distance.is_finite()).into());
    let (distance, saddles) = match &found.relaxed {
        Relaxed::Ended { distance, saddles, .. } => (*distance, *saddles),
        Relaxed::Failed(_) => (None, None),
    };
    cells.push(distance.into());
    cells.push(saddles.map(u64::from).into());
    cells.push(found.relaxed.claim_is_true().into());
    cells.push(folded.and_then(|folded| crossings(&found.model, &folded.state.positions)).into());
}

/// How a relaxation ended, for people.
pub(super) fn ended(relaxed: &Relaxed) -> String {
    match relaxed {
        Relaxed::Failed(held) => held.to_string(),
        Relaxed::Ended { folded, .. } => word(folded).to_owned(),
    }
}

fn word(folded: &Folded) -> &'static str {
    match folded.stop {
        Stop::Converged => "converged",
        Stop::StepsDone => "steps done",
        Stop::StepLimit => "step limit",
        Stop::Crushed => "crushed",
        _ => "stopped",
    }
}
