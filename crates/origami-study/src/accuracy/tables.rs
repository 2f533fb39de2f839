//! The runs as tables and plots.

use super::Found;
use super::cases::Case;
use super::runs::{PAPER, RELAX, Run};
use crate::plot::{Axis, Mark, Plot, Scale, Series};
use crate::table::{Cell, Column, Table};

/// Errors whose first arrival a table gives, in radii.
const LEVELS: [f64; 4] = [1e-2, 1e-3, 1e-4, 1e-6];
/// The one that `converged` claims by default.
pub(super) const ASKED: f64 = 1e-4;
/// Budgets of time, in seconds.
const BUDGETS: [f64; 5] = [1e-3, 1e-2, 1e-1, 1.0, 10.0];

const CASE: Column = Column { key: "scene", head: "scene", meaning: "what is folded" };
const PERCENT: Column = Column { key: "percent", head: "%", meaning: "percentage of the pattern's fold angles" };
const START: Column =
    Column { key: "start", head: "start", meaning: "a jump of the target angles, or the default ramp" };
const SOLVER: Column =
    Column { key: "solver", head: "solver", meaning: "solver and its settings where not the defaults" };
const BACKEND: Column = Column { key: "backend", head: "on", meaning: "cpu (64 bits) or gpu (32 bits)" };

const WAYS: &[Column] = &[
    CASE,
    PERCENT,
    START,
    SOLVER,
    BACKEND,
    Column { key: "evaluations", head: "evaluations", meaning: "force evaluations, the ramp included" },
    Column { key: "factorisations", head: "factorisations", meaning: "of Newton's method" },
    Column { key: "seconds", head: "seconds", meaning: "of solving" },
    Column { key: "error_max", head: "largest error", meaning: "of a vertex, in radii, after the best rigid motion" },
    Column { key: "error_rms", head: "rms error", meaning: "over all vertices, in radii" },
];

/// Every look at every run.
pub(super) fn ways(found: &Found) -> Table {
    let mut table = Table::new(WAYS);
    for run in &found.runs {
        for (look, error) in run.trail.looks.iter().zip(&run.errors) {
            let mut row = named(run);
            row.extend([
                look.evaluations.into(),
                look.factorisations.map(u64::from).into(),
                look.seconds.into(),
                error.max.into(),
                error.rms.into(),
            ]);
            table.push(row);
        }
    }
    table
}

const RUNS: &[Column] = &[
    CASE,
    PERCENT,
    START,
    SOLVER,
    BACKEND,
    Column { key: "nodes", head: "nodes", meaning: "vertices of the sheet" },
    Column { key: "evaluations_1e-2", head: "to 1e-2", meaning: "evaluations until the error stays within 1e-2 radii" },
    Column { key: "evaluations_1e-3", head: "to 1e-3", meaning: "until within 1e-3" },
    Column { key: "evaluations_1e-4", head: "to 1e-4", meaning: "until within 1e-4" },
    Column { key: "evaluations_1e-6", head: "to 1e-6", meaning: "until within 1e-6" },
    Column { key: "seconds_1e-2", head: "s to 1e-2", meaning: "seconds of solving until within 1e-2" },
    Column { key: "seconds_1e-3", head: "s to 1e-3", meaning: "until within 1e-3" },
    Column { key: "seconds_1e-4", head: "s to 1e-4", meaning: "until within 1e-4" },
    Column { key: "seconds_1e-6", head: "s to 1e-6", meaning: "until within 1e-6" },
    Column { key: "evaluations", head: "evaluations", meaning: "force evaluations in all" },
    Column { key: "seconds", head: "seconds", meaning: "of solving in all" },
    Column { key: "error_max", head: "last error", meaning: "largest of a vertex at the end, in radii" },
    Column { key: "error_rms", head: "rms", meaning: "the same over all vertices" },
    Column {
        key: "branch",
        head: "equilibrium",
        meaning: "whether it is the reference; errors are from the run's own",
    },
    Column { key: "energy", head: "energy", meaning: "at the end" },
    Column {
        key: "crossings",
        head: "crossings",
        meaning: "edges that go through triangles at the end, by the exact test",
    },
    Column { key: "kept", head: "claim kept", meaning: "whether the error is within the tolerance, where converged" },
    Column { key: "failed", head: "failed", meaning: "why it ended early" },
];

/// A row for each run.
pub(super) fn runs<'a>(runs: impl Iterator<Item = &'a Run>) -> Table {
    let mut table = Table::new(RUNS);
    for run in runs {
        let mut row = named(run);
        row.push(run.nodes.into());
        row.extend(LEVELS.map(|level| run.arrival(level).map(|(evaluations, _)| evaluations).into()));
        row.extend(LEVELS.map(|level| run.arrival(level).map(|(_, seconds)| seconds).into()));
        let last = run.trail.looks.last();
        row.extend([
            last.map(|look| look.evaluations).into(),
            last.map(|look| look.seconds).into(),
            run.error().map(|error| error.max).into(),
            run.error().map(|error| error.rms).into(),
            run.branch.name().into(),
            run.energy.into(),
            run.crossings.into(),
            run.keeps_claim().into(),
            run.trail.failed.clone().into(),
        ]);
        table.push(row);
    }
    table
}

const RATIOS: &[Column] = &[
    CASE,
    PERCENT,
    START,
    BACKEND,
    Column { key: "paper", head: "paper's scheme (s)", meaning: "seconds until within 1e-4 radii of its equilibrium" },
    Column { key: "relax", head: "relax (s)", meaning: "the same of relax" },
    Column { key: "ratio", head: "ratio", meaning: "relax / paper's scheme; 0 where that does not arrive" },
    Column { key: "paper_ends", head: "paper's scheme ends at", meaning: "its last error, in radii" },
    Column { key: "newton", head: "newton's residual", meaning: "largest force on a vertex that newton leaves" },
];

/// How much sooner `relax` is there than the paper's scheme.
pub(super) struct Ratios {
    pub(super) table: Table,
    /// Of jumps, with their case and backend.
    pub(super) jumps: Vec<(String, f64)>,
    /// Of all others, sorted.
    pub(super) risen: Vec<f64>,
    /// Where the paper's scheme does not arrive.
    pub(super) never: Vec<String>,
    /// Vertices and ratio on the processor; of a logarithmic plot ratios of 0 are left out.
    by_size: Vec<(f64, f64)>,
    pub(super) newton: f64,
}

pub(super) fn ratios(found: &Found) -> Ratios {
    let mut ratios = Ratios {
        table: Table::new(RATIOS),
        jumps: Vec::new(),
        risen: Vec::new(),
        never: Vec::new(),
        by_size: Vec::new(),
        newton: 0.0,
    };
    for (case, reference) in &found.references {
        for backend in ["cpu", "gpu"] {
            let of = |method: &str| found.of(case).find(|run| run.method == method && run.backend == backend);
            let (Some(paper), Some(relax)) = (of(PAPER), of(RELAX)) else { continue };
            let [slow, fast] = [paper, relax].map(|run| run.arrival(ASKED).map(|(_, seconds)| seconds));
            let Some(fast) = fast else { continue };
            let ratio = slow.map_or(0.0, |slow| fast / slow);
            let name = format!("{} at {} % ({backend})", case.name, case.percent);
            if slow.is_none() {
                ratios.never.push(name.clone());
            }
            if backend == "cpu" {
                ratios.by_size.push((case.model.node_count() as f64, ratio));
            }
            if case.ramp == 0 {
                ratios.jumps.push((name, ratio));
            } else {
                ratios.risen.push(ratio);
            }
            let residual = reference.as_ref().map(|reference| reference.residual);
            ratios.newton = ratios.newton.max(residual.unwrap_or(0.0));
            ratios.table.push(vec![
                case.name.as_str().into(),
                case.percent.into(),
                start(case.ramp == 0).into(),
                backend.into(),
                slow.into(),
                fast.into(),
                ratio.into(),
                paper.error().map(|error| error.max).into(),
                residual.into(),
            ]);
        }
    }
    ratios.risen.sort_by(f64::total_cmp);
    ratios
}

const REFERENCES: &[Column] = &[
    CASE,
    PERCENT,
    START,
    Column { key: "nodes", head: "nodes", meaning: "vertices of the sheet" },
    Column { key: "energy", head: "energy", meaning: "of the equilibrium" },
    Column { key: "residual", head: "residual", meaning: "largest force on a vertex" },
    Column { key: "neutral", head: "free modes", meaning: "directions that cost nothing, beyond rigid motion" },
];

/// What errors are measured against.
pub(super) fn references(found: &Found) -> Table {
    let mut table = Table::new(REFERENCES);
    for (case, reference) in &found.references {
        let reference = reference.as_ref();
        table.push(vec![
            case.name.as_str().into(),
            case.percent.into(),
            start(case.ramp == 0).into(),
            case.model.node_count().into(),
            reference.map(|reference| reference.energy).into(),
            reference.map(|reference| reference.residual).into(),
            reference.map(|reference| reference.neutral).into(),
        ]);
    }
    table
}

const BUDGET: &[Column] = &[
    CASE,
    SOLVER,
    BACKEND,
    Column { key: "1ms", head: "1 ms", meaning: "largest error of a vertex after 1 ms of solving, in radii" },
    Column { key: "10ms", head: "10 ms", meaning: "after 10 ms" },
    Column { key: "100ms", head: "0.1 s", meaning: "after 0.1 s" },
    Column { key: "1s", head: "1 s", meaning: "after 1 s" },
    Column { key: "10s", head: "10 s", meaning: "after 10 s" },
];

/// The error that each run has reached by each budget of time: that of its last look before.
pub(super) fn budgets(found: &Found) -> Table {
    let mut table = Table::new(BUDGET);
    for run in found.runs.iter().filter(|run| run.jump) {
        let mut row: Vec<Cell> = vec![run.case.as_str().into(), run.method.as_str().into(), run.backend.into()];
        row.extend(BUDGETS.map(|budget| {
            let looks = run.trail.looks.iter().zip(&run.errors);
            looks.take_while(|(look, _)| look.seconds <= budget).last().map(|(_, error)| error.max).into()
        }));
        table.push(row);
    }
    table
}

/// Error of a case's runs against what `cost` says of a look.
pub(super) fn plot(found: &Found, case: &Case, against: Against, note: &str) -> Plot {
    let series = found.of(case).map(|run| {
        let points = run.trail.looks.iter().zip(&run.errors).map(|(look, error)| match against {
            Against::Seconds => (look.seconds, error.max),
            Against::Evaluations => (look.evaluations as f64, error.max),
        });
        let on_gpu = run.backend == "gpu";
        Series {
            label: if on_gpu { format!("{} (gpu)", run.method) } else { run.method.clone() },
            mark: if on_gpu { Mark::Dashed } else { Mark::Line },
            points: points.collect(),
        }
    });
    Plot {
        title: case.title(),
        note: note.into(),
        x: Axis {
            label: match against {
                Against::Seconds => "seconds of solving",
                Against::Evaluations => "force evaluations",
            }
            .into(),
            scale: Scale::Log,
        },
        y: Axis { label: "largest error of a vertex (radii)".into(), scale: Scale::Log },
        series: series.collect(),
    }
}

/// What an error is plotted against.
#[derive(Clone, Copy, Debug)]
pub(super) enum Against {
    Seconds,
    Evaluations,
}

/// The ratios of a processor by the size of the sheet, those above 0.
pub(super) fn ratio_plot(ratios: &Ratios, note: &str) -> Plot {
    Plot {
        title: "Time of relax to 1e-4 as a share of that of the paper's scheme".into(),
        note: format!("{note}; scenes where the paper's scheme does not arrive are left out"),
        x: Axis { label: "vertices".into(), scale: Scale::Log },
        y: Axis { label: "time of relax / time of the paper's scheme".into(), scale: Scale::Log },
        series: vec![Series { label: "a scene".into(), mark: Mark::Points, points: ratios.by_size.clone() }],
    }
}

fn named(run: &Run) -> Vec<Cell> {
    vec![
        run.case.as_str().into(),
        run.percent.into(),
        start(run.jump).into(),
        run.method.as_str().into(),
        run.backend.into(),
    ]
}

fn start(jump: bool) -> &'static str {
    if jump { "jump" } else { "ramp" }
}
