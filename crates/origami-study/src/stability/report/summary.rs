//! What the rows of a family have in common, and what misses.

use crate::stability::cases::Size;
use crate::stability::found::{Found, Limit, Relaxed};
use crate::stability::motion::Outcome;
use crate::stability::row::{CaseResult, Row};
use crate::table::{Cell, Column, Table, column};

/// The bound is to lie between these shares of the largest step that holds.
pub(super) const LEAST: f64 = 0.4;
pub(super) const MOST: f64 = 1.0;

const COLUMNS: &[Column] = &[
    column("family", "family", "rows of one family vary one thing"),
    column("rows", "rows", "how many there are"),
    column("run", "run", "how many were run to their end"),
    column("paper_holds", "paper's step holds", "rows in which it does"),
    column("safe_holds", "safe step holds", "rows in which it does, with Euler and with Verlet"),
    column("ratio_min", "bound / largest: min", "of all ratios: at rest, with Verlet, folded"),
    column("ratio_median", "median", "of the same"),
    column("ratio_max", "max", "of the same"),
    column("converged", "relax converged", "rows in which it did"),
    column("claims", "claims checked", "of these, rows with a reference equilibrium"),
    column("claims_true", "claims true", "of these, rows within the tolerance of it"),
    column("gpu_safe_holds", "f32: safe step holds", "rows in which it does on the GPU"),
    column("gpu_converged", "f32: relax converged", "rows in which it did on the GPU"),
    column("gpu_median", "f32: off at the end, median", "distance from the equilibrium in 64 bits, in radii"),
    column("gpu_max", "max", "of the same"),
];

/// Columns without those of the GPU.
pub(super) const WITHOUT_GPU: usize = 11;

/// Keys of the columns that the document shows.
pub(super) fn shown(gpu: bool) -> Vec<&'static str> {
    let columns = if gpu { COLUMNS } else { &COLUMNS[..WITHOUT_GPU] };
    columns.iter().map(|column| column.key).collect()
}

/// How many of some rows did what.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::stability) struct Counts {
    pub(super) rows: usize,
    pub(super) run: usize,
    pub(super) paper_holds: usize,
    pub(super) safe_holds: usize,
    /// Bound over largest step that holds, of every state and integrator; sorted.
    pub(super) ratios: Vec<f64>,
    pub(super) converged: usize,
    pub(in crate::stability) claims: usize,
    pub(in crate::stability) claims_true: usize,
    pub(super) gpu: usize,
    pub(super) gpu_safe_holds: usize,
    pub(super) gpu_converged: usize,
    /// Distances from the equilibrium in 64 bits, of what converged; sorted.
    pub(super) gpu_distances: Vec<f64>,
}

/// The ratios of bound to largest step of a row, by name.
pub(in crate::stability) fn ratios(found: &Found) -> impl Iterator<Item = (&'static str, f64)> {
    let limits = [("at rest", Some(found.at_rest)), ("Verlet", found.verlet), ("folded", found.folded)];
    limits.into_iter().filter_map(|(what, limit)| limit.and_then(Limit::ratio).map(|ratio| (what, ratio)))
}

impl Counts {
    pub(in crate::stability) fn of<'r>(rows: impl Iterator<Item = &'r Row>) -> Self {
        let mut counts = Self::default();
        for row in rows {
            counts.rows += 1;
            if let Some(found) = row.found() {
                counts.add(found);
            }
            if let Some(gpu) = &row.gpu {
                counts.gpu += 1;
                counts.gpu_safe_holds += usize::from(gpu.safe.holds());
                counts.gpu_converged += usize::from(gpu.relaxed == Ok(true));
                counts.gpu_distances.extend(gpu.at_equilibrium.filter(|_| gpu.relaxed == Ok(true)));
            }
        }
        counts.ratios.sort_by(f64::total_cmp);
        counts.gpu_distances.sort_by(f64::total_cmp);
        counts
    }

    fn add(&mut self, found: &Found) {
        self.run += 1;
        self.paper_holds += usize::from(found.paper.holds());
        self.safe_holds += usize::from(found.safe.holds() && found.safe_verlet.holds());
        self.ratios.extend(ratios(found).map(|(_, ratio)| ratio));
        self.converged += usize::from(found.relaxed.converged());
        let claim = found.relaxed.claim_is_true();
        self.claims += usize::from(claim.is_some());
        self.claims_true += usize::from(claim == Some(true));
    }

    /// How many ratios lie where they should.
    pub(super) fn ratios_within(&self) -> usize {
        self.ratios.iter().filter(|ratio| (LEAST..=MOST).contains(*ratio)).count()
    }
}

/// The middle one of sorted numbers.
pub(super) fn median(sorted: &[f64]) -> Option<f64> {
    sorted.get(sorted.len().checked_sub(1)? / 2).copied()
}

/// One row for each family, and one for all.
pub(super) fn table(rows: &[Row]) -> Table {
    let mut families: Vec<&str> = rows.iter().map(|row| row.case.family).collect();
    families.dedup();
    let mut table = Table::new(COLUMNS);
    for family in families {
        table.push(cells(family, &Counts::of(rows.iter().filter(|row| row.case.family == family))));
    }
    table.push(cells("all", &Counts::of(rows.iter())));
    table
}

fn cells(family: &str, counts: &Counts) -> Vec<Cell> {
    let on_gpu = |count: usize| if counts.gpu > 0 { Cell::from(count) } else { Cell::Missing };
    vec![
        family.into(),
        counts.rows.into(),
        counts.run.into(),
        counts.paper_holds.into(),
        counts.safe_holds.into(),
        counts.ratios.first().copied().into(),
        median(&counts.ratios).into(),
        counts.ratios.last().copied().into(),
        counts.converged.into(),
        counts.claims.into(),
        counts.claims_true.into(),
        on_gpu(counts.gpu_safe_holds),
        on_gpu(counts.gpu_converged),
        median(&counts.gpu_distances).into(),
        counts.gpu_distances.last().copied().into(),
    ]
}

const MISS_COLUMNS: &[Column] = &[
    column("family", "family", "that of the row"),
    column("scene", "scene", "what is folded, and the value of what is varied"),
    column("path", "%", "percentages that it is sent to"),
    column("miss", "what misses", "what should be otherwise"),
];

/// All that should be otherwise.
pub(super) fn misses(rows: &[Row]) -> Table {
    let mut table = Table::new(MISS_COLUMNS);
    for row in rows {
        let path: Vec<String> = row.case.path.iter().map(f64::to_string).collect();
        for miss in misses_of(row) {
            let case = row.case.name();
            table.push(vec![row.case.family.into(), case.into(), path.join(", ").into(), miss.into()]);
        }
    }
    table
}

fn misses_of(row: &Row) -> Vec<String> {
    let found = match &row.result {
        CaseResult::Found(found) => found,
        CaseResult::Refused(error) => return vec![format!("makes no model: {error}")],
        CaseResult::Panicked(what) => return vec![format!("panicked: {what}")],
        CaseResult::LeftOut => return vec!["left out: no time".into()],
    };
    let mut misses = Vec::new();
    if let Outcome::Wrong(what) = &found.paper {
        misses.push(format!("the paper's step fails as nothing should: {what}"));
    }
    for (name, held) in [("Euler", &found.safe), ("Verlet", &found.safe_verlet)] {
        if !held.holds() {
            misses.push(format!("safe step, {name}: {held}"));
        }
    }
    let wrong = ratios(found).filter(|(_, ratio)| !(LEAST..=MOST).contains(ratio));
    misses.extend(wrong.map(|(what, ratio)| format!("bound / largest step, {what}: {ratio:.3}")));
    let limits = [("at rest", Some(found.at_rest)), ("Verlet", found.verlet), ("folded", found.folded)];
    let unknown = limits.into_iter().filter(|(_, limit)| limit.is_some_and(|limit| limit.largest.is_none()));
    misses.extend(unknown.map(|(what, _)| format!("largest step, {what}: not found")));
    let small = row.case.size == Size::Small;
    if small && !found.relaxed.converged() {
        let distance = found.relaxed.folded().map_or(f64::NAN, |folded| folded.distance);
        misses.push(format!("relax: {}, estimate {distance:.1e}", super::table::ended(&found.relaxed)));
    }
    if small && found.equilibrium.is_none() {
        misses.push("no reference equilibrium was found".into());
    }
    if let Relaxed::Ended { distance: Some(distance), saddles, .. } = &found.relaxed
        && found.relaxed.claim_is_true() == Some(false)
    {
        let place = if saddles.is_some_and(|saddles| saddles > 0) { ", on a saddle" } else { "" };
        misses.push(format!("claims to have converged, {distance:.1e} from the equilibrium{place}"));
    }
    if let Some(gpu) = &row.gpu {
        if !gpu.safe.holds() {
            misses.push(format!("f32, safe step: {}", gpu.safe));
        }
        match &gpu.relaxed {
            Ok(false) if small => misses.push("f32, relax: step limit".into()),
            Err(held) => misses.push(format!("f32, relax: {held}")),
            Ok(_) => {}
        }
    }
    misses
}
