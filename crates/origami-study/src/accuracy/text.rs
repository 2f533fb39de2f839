//! What the document says: every figure in it is computed from the runs.

use super::claims::Claims;
use super::closed::ClosedForms;
use super::tables::{self, ASKED, Against};
use super::transient::Transient;
use super::{Found, heading, text};
use crate::table::Table;
use crate::{Options, Part};

/// Cases with the default ramp whose ways are plotted: a rigid fold, one that is strained, and one with many ways to go.
const PLOTTED: [(&str, f64); 3] = [("miura", 100.0), ("waterbomb", 60.0), ("crane", 100.0)];

pub(super) fn introduction(found: &Found, options: &Options) -> Vec<Part> {
    let mut parts = vec![text(
        "Errors are distances of vertices from the equilibrium itself, in radii of the sheet, after the best rigid motion. \
         The equilibrium is what `newton` finds, to a residual of 1e-10 and better, from where `relax` ends; of a sheet that is \
         to fold flat it is the exact state, by reflecting its faces. A run that ends \
         in another equilibrium is measured against that one, and its row says so. Seconds are of solving alone; the least \
         of three for short runs, and never more than those of a longer run.",
    )];
    parts.push(text(match options.gpu.name() {
        Some(name) => format!("Runs on a GPU are on {name}; building its pipelines is not in their seconds."),
        None => "All runs are on the processor.".into(),
    }));
    if !found.left_out.is_empty() {
        parts.push(text(format!(
            "{} runs were left out, for want of time or because no reference was found: {}.",
            found.left_out.len(),
            found.left_out.join("; ")
        )));
    }
    parts
}

pub(super) fn runs(found: &Found, options: &Options) -> Vec<Part> {
    let note = &match options.gpu.name() {
        Some(name) => format!("processor, and dashed on {name}"),
        None => "processor".into(),
    };
    let mut parts = vec![heading("Solvers side by side")];
    let jumps = found.references.iter().filter(|(case, _)| case.in_full);
    for (case, _) in jumps {
        parts.push(text(format!("**{}** ({} vertices).", case.title(), case.model.node_count())));
        let name = file_name(&format!("{}-{}", case.name, case.percent));
        for (against, what) in [(Against::Seconds, "seconds"), (Against::Evaluations, "evaluations")] {
            parts.push(plot(&format!("error-{what}-{name}"), tables::plot(found, case, against, note)));
        }
        parts.push(table(
            &format!("runs-{name}"),
            tables::runs(found.of(case)),
            &[
                "solver",
                "backend",
                "evaluations_1e-2",
                "evaluations_1e-4",
                "evaluations_1e-6",
                "seconds_1e-4",
                "seconds",
                "error_max",
                "branch",
                "failed",
            ],
        ));
    }
    if found.runs.iter().any(|run| run.jump) {
        parts.push(heading("Error at a given budget"));
        parts.push(text("The error that a solver has come down to when so much time is gone, on a jump from flat."));
        parts.push(table(
            "budgets",
            tables::budgets(found),
            &["scene", "solver", "backend", "1ms", "10ms", "100ms", "1s", "10s"],
        ));
    }
    parts.extend(risen(found, note));
    parts.push(heading("References and curves in full"));
    parts.push(text("The equilibria, and every point of every curve."));
    parts.push(table("references", tables::references(found), &[]));
    parts.push(table("ways", tables::ways(found), &[]));
    parts
}

/// With the default ramp.
fn risen(found: &Found, note: &str) -> Vec<Part> {
    let mut parts = vec![heading("relax against the paper's scheme")];
    let ratios = tables::ratios(found);
    for (name, ratio) in &ratios.jumps {
        parts.push(text(format!("{name}: `relax` is within {ASKED:e} after {ratio:.4} of the paper's scheme's time.")));
    }
    if let Some(median) = ratios.risen.get(ratios.risen.len() / 2) {
        parts.push(text(format!(
            "With the default ramp, over {} scenes, the median of that share is {median:.4}; the paper's scheme is given \
             the same ramp.",
            ratios.risen.len()
        )));
    }
    if !ratios.never.is_empty() {
        parts.push(text(format!("The paper's scheme never arrives at {}.", ratios.never.join(", "))));
    }
    parts.push(text(format!("The references have residuals of at most {:.1e}.", ratios.newton)));
    parts.push(plot("ratio", tables::ratio_plot(&ratios, note)));
    let all = ["scene", "percent", "start", "backend", "paper", "relax", "ratio", "paper_ends", "newton"];
    parts.push(table("ratios", ratios.table, &all));
    for (case, _) in &found.references {
        let own =
            case.ramp > 0 && (PLOTTED.contains(&(case.name.as_str(), case.percent)) || found.references.len() < 8);
        if own {
            let name = file_name(&format!("{}-{}", case.name, case.percent));
            parts.push(plot(&format!("error-seconds-{name}-ramp"), tables::plot(found, case, Against::Seconds, note)));
        }
    }
    let risen = tables::runs(found.runs.iter().filter(|run| !run.jump));
    parts.push(table(
        "runs",
        risen,
        &[
            "scene",
            "percent",
            "solver",
            "backend",
            "evaluations_1e-4",
            "seconds_1e-4",
            "error_max",
            "branch",
            "energy",
            "kept",
        ],
    ));
    parts
}

pub(super) fn closed_forms(closed: ClosedForms) -> Vec<Part> {
    vec![
        heading("Closed forms"),
        text(format!(
            "Scenes whose folded state is known without any simulation. `newton` meets them to {:.1e}; `relax` is at most \
             {:.2} of its tolerance away.",
            closed.newton, closed.relax
        )),
        table(
            "closed-forms",
            closed.table,
            &["scene", "solver", "evaluations", "error", "unit", "closure", "converged"],
        ),
    ]
}

pub(super) fn transient(transient: Transient) -> Vec<Part> {
    let [[euler_least, euler_most], [verlet_least, verlet_most]] = transient.orders;
    vec![
        heading("The motion in time"),
        text(format!(
            "Between the two shortest steps the error of Euler falls with order {euler_least:.2} to {euler_most:.2}, that of \
             Verlet with order {verlet_least:.2} to {verlet_most:.2}."
        )),
        plot("transient", transient.plot),
        table("transient", transient.table, &["scene", "zeta", "integrator", "of_paper", "error", "order"]),
    ]
}

pub(super) fn claims(claims: &Claims) -> Vec<Part> {
    let (made, misses) = claims.missed();
    let kept = made - misses.rows.len();
    let share = 100.0 * kept as f64 / made.max(1) as f64;
    let mut parts = vec![
        heading("What `converged` is worth"),
        text(format!(
            "{kept} of {made} runs that say that they have converged are within their tolerance of their equilibrium: \
             {share:.1} %."
        )),
        table("claims", claims.table.clone(), &[]),
    ];
    if !misses.rows.is_empty() {
        parts.push(text("Those that are not:"));
        let shown =
            ["scene", "percent", "start", "solver", "tolerance", "evaluations", "estimate", "distance", "branch"];
        parts.push(table("claims-missed", misses, &shown));
    }
    parts
}

pub(super) fn omissions(omissions: Table) -> Vec<Part> {
    vec![
        heading("What leaving things out saves"),
        text(
            "A Miura sheet at 60 %. *With* is what a scene would pay that does not need the thing but builds it all the \
             same; *change* is how far the equilibrium moves when the thing is taken from a scene that has it: the error \
             made by leaving out what does matter.",
        ),
        table("omissions", omissions, &["what", "solver", "with", "without", "saved", "error", "why"]),
    ]
}

fn table(file: &str, table: Table, shown: &[&'static str]) -> Part {
    Part::Table { file: file.into(), table, shown: shown.to_vec() }
}

fn plot(file: &str, plot: crate::Plot) -> Part {
    Part::Plot { file: file.into(), plot }
}

/// Letters, figures and hyphens.
fn file_name(words: &str) -> String {
    let plain: String = words.chars().map(|c| if c.is_ascii_alphanumeric() || c == '.' { c } else { '-' }).collect();
    plain.split('-').filter(|part| !part.is_empty()).collect::<Vec<_>>().join("-").to_lowercase()
}
