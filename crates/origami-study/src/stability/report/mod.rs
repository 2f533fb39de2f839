//! The document: what was run, and what came out, in words that are computed from the rows.

mod plots;
pub(super) mod summary;
mod table;

use self::summary::{Counts, LEAST, MOST};
use super::drift::Drift;
use super::found::Budget;
use super::row::{CaseResult, Row};
use crate::table::{Cell, Column, Table};
use crate::{Part, Study};

/// All that was run, for the report.
pub(super) struct Ran<'a> {
    pub(super) rows: &'a [Row],
    pub(super) drifts: &'a [Drift],
    /// Whether there was no time for some of those.
    pub(super) drifts_left_out: bool,
    pub(super) budget: Budget,
    /// The name of the GPU on which runs were repeated.
    pub(super) gpu: Option<String>,
}

/// The study of what was run.
pub(super) fn study(ran: &Ran<'_>) -> Study {
    let mut parts = vec![Part::Text(what_was_run(ran)), Part::Heading("Families".into())];
    let counts = Counts::of(ran.rows.iter());
    parts.push(Part::Text(conclusions(&counts)));
    let shown = summary::shown(ran.gpu.is_some());
    parts.push(Part::Table { file: "stability-families".into(), table: summary::table(ran.rows), shown });
    parts.push(plot("bound", plots::ratios_by_family(ran.rows)));

    parts.push(Part::Heading("What misses".into()));
    let misses = summary::misses(ran.rows);
    parts.push(Part::Text(match misses.rows.len() {
        0 => "Nothing.".into(),
        count => format!("{count} things are not as one would have them; a row may have several."),
    }));
    let shown = misses.columns.iter().map(|column| column.key).collect();
    parts.push(Part::Table { file: "stability-misses".into(), table: misses, shown });

    parts.push(Part::Heading("Time steps".into()));
    parts.extend(plots::steps(ran.rows).into_iter().map(|(file, drawn)| plot(file, drawn)));

    parts.push(Part::Heading("Drift".into()));
    parts.push(Part::Text(about_drift(ran)));
    let drifts = drift_table(ran.drifts);
    let shown = drifts.columns.iter().map(|column| column.key).collect();
    parts.push(Part::Table { file: "stability-drift".into(), table: drifts, shown });
    parts.push(plot("energy", plots::drift(ran.drifts)));

    if let Some(gpu) = &ran.gpu {
        parts.push(Part::Heading("32 bits".into()));
        parts.push(Part::Text(about_32_bits(&counts, gpu)));
        parts.push(plot("f32", plots::in_32_bits(ran.rows, gpu)));
    }

    parts.push(Part::Heading("All rows".into()));
    parts.push(Part::Table {
        file: "stability-rows".into(),
        table: table::table(ran.rows),
        shown: table::SHOWN.to_vec(),
    });
    Study { name: "stability", title: "Stability".into(), parts }
}

fn plot(file: &str, plot: crate::Plot) -> Part {
    Part::Plot { file: format!("stability-{file}"), plot }
}

fn what_was_run(ran: &Ran<'_>) -> String {
    let Budget { steps, steps_of_large, relaxation, relaxation_of_large, effort, .. } = ran.budget;
    let mut text = format!(
        "Each row folds a scene from rest, 60 % unless a row says otherwise. *Holds* means that {steps} steps of the \
         motion, the target jumping, end without divergence, and that the mechanical energy, looked at ten times, is \
         halfway at most what the jump gave and does not rise after that (by more than a hundredth of it; without damping: \
         that it never is more than twice of it). *Largest* \
         is the longest fixed step with which a small random vibration about the state at rest, or about the folded \
         equilibrium, does not grow in {} steps, enclosed to {} %; *bound* is the safe step without its margin. *Relax* \
         has at most {relaxation} evaluations; its *distance* is that of the farthest vertex from the equilibrium to \
         which Newton's method refines it, and its claim to have converged is *true* where that is within the tolerance. \
         Large sheets have {steps_of_large} steps and {relaxation_of_large} evaluations, too few to arrive: the answer \
         asked of them is `step limit`. Everything is seeded; the same program gives the same rows.",
        2 * effort.half,
        100.0 * effort.precision,
    );
    if let Some(gpu) = &ran.gpu {
        text += &format!(" The same was run in 32 bits on {gpu}.");
    }
    let left_out: Vec<String> =
        ran.rows.iter().filter(|row| matches!(row.result, CaseResult::LeftOut)).map(|row| row.case.name()).collect();
    if !left_out.is_empty() {
        text += &format!("\n\nThere was no time for {} rows: {}.", left_out.len(), left_out.join("; "));
    }
    text
}

fn conclusions(counts: &Counts) -> String {
    let Counts { rows, run, paper_holds, safe_holds, ratios, converged, claims, claims_true, .. } = counts;
    let mut text = format!(
        "Of {rows} rows {run} were run. The paper's step holds in {paper_holds} of them, the safe step, with Euler and \
         with Verlet, in {safe_holds}. The relaxation converged in {converged}; of {claims} claims that a reference \
         equilibrium could check {claims_true} are true{}.",
        percent_of(*claims_true, *claims),
    );
    if let (Some(least), Some(most)) = (ratios.first(), ratios.last()) {
        let within = counts.ratios_within();
        text += &format!(
            " The bound lies between {least:.2} and {most:.3} of the largest step that holds, in {within} of {} cases{} \
             between {LEAST} and {MOST}.",
            ratios.len(),
            percent_of(within, ratios.len()),
        );
    }
    text
}

fn percent_of(part: usize, whole: usize) -> String {
    if whole == 0 { String::new() } else { format!(" ({:.1} %)", 100.0 * part as f64 / whole as f64) }
}

fn about_32_bits(counts: &Counts, gpu: &str) -> String {
    let mut text = format!(
        "On {gpu} the safe step holds in {} of {} rows, and the relaxation converged in {}.",
        counts.gpu_safe_holds, counts.gpu, counts.gpu_converged
    );
    if let (Some(median), Some(most)) = (summary::median(&counts.gpu_distances), counts.gpu_distances.last()) {
        text += &format!(
            " Where it did, it ended {median:.1e} radii (median; {most:.1e} at most) from the equilibrium in 64 bits. Far \
             away means another branch as often as an error: the two round differently where a sheet may buckle either way."
        );
    }
    text
}

fn about_drift(ran: &Ran<'_>) -> String {
    let mut text = match ran.drifts.first() {
        Some(first) => format!(
            "A Miura of 2 x 2 panels for {} steps. Without damping the sheet spins while its target jumps to 20 %: springs should keep energy, momentum \
             and angular momentum. With damping it lies at rest, or in its equilibrium at 60 %, and should stay there.",
            first.steps
        ),
        None => String::new(),
    };
    for (renewed, step) in [(false, "a step that stays the same"), (true, "one that is renewed")] {
        let changes = ran.drifts.iter().filter(|drift| drift.renewed == renewed).filter_map(Drift::of_energy);
        if let Some(most) = changes.map(f64::abs).max_by(f64::total_cmp) {
            text += &format!(
                " With {step} the mean energy changed by {:.2} % at most from the first tenth to the last.",
                100.0 * most
            );
        }
    }
    if ran.drifts_left_out {
        text += " There was no time for all of these runs.";
    }
    text
}

const DRIFT_COLUMNS: &[Column] = &[
    Column { key: "run", head: "run", meaning: "integrator and step" },
    Column { key: "steps", head: "steps", meaning: "how many" },
    Column { key: "held", head: "held", meaning: "whether it held, or how it failed" },
    Column {
        key: "energy",
        head: "energy drift",
        meaning: "mean energy (that which the steps keep) of the last tenth of the run over that of the first, less 1",
    },
    Column { key: "centroid", head: "centroid", meaning: "largest distance from where it was, in radii" },
    Column { key: "momentum", head: "momentum", meaning: "the largest; it should be 0" },
    Column { key: "angular_momentum", head: "angular momentum", meaning: "largest change, as a share" },
    Column { key: "moved", head: "moved", meaning: "largest way of a vertex from the equilibrium, in radii" },
];

fn drift_table(drifts: &[Drift]) -> Table {
    let mut table = Table::new(DRIFT_COLUMNS);
    for drift in drifts {
        table.push(vec![
            drift.name.into(),
            drift.steps.into(),
            drift.outcome.to_string().into(),
            drift.of_energy().into(),
            drift.centroid.into(),
            drift.momentum.into(),
            Cell::from(drift.angular_momentum),
            drift.moved.into(),
        ]);
    }
    table
}
