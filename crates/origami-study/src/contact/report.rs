//! The document: tables, plots, and words that are computed from the rows.

use super::asked::{self, Asked};
use super::found::Found;
use super::row::{Free, Held, Row};
use crate::plot::{Axis, Mark, Plot, Scale, Series};
use crate::table::{Cell, Column, Table, column};
use crate::{Part, Study};

/// The study of what was run.
pub(super) fn study(rows: &[Row], found: Vec<Found>, left_out: &[String]) -> Study {
    let mut all = of_rows(rows);
    let mut more = Vec::new();
    for Found { parts, asked } in found {
        more.extend(parts);
        all.extend(asked);
    }
    let mut parts = vec![Part::Text(ABOUT.into()), Part::Text(conclusions(rows))];
    if !left_out.is_empty() {
        parts.push(Part::Text(format!("There was no time for {}.", left_out.join(", "))));
    }
    parts.push(Part::Heading("What is asked for".into()));
    parts.push(Part::Text(asked::missed(&all)));
    parts.push(whole("contact-asked", asked::table(&all)));
    parts.push(Part::Text(ELSEWHERE.into()));
    parts.push(Part::Heading("Patterns".into()));
    parts.push(Part::Text(ABOUT_TOUCHING.into()));
    parts.push(whole("contact-touching", touching(rows)));
    parts.push(Part::Table { file: "contact-patterns".into(), table: table(rows), shown: Vec::new() });
    parts.extend(plots(rows).into_iter().map(|(file, plot)| Part::Plot { file: file.into(), plot }));
    parts.extend(more);
    Study {
        name: "contact",
        title: "Contact: what goes through what, and what keeping it from that costs".into(),
        parts,
    }
}

fn whole(file: &str, table: Table) -> Part {
    let shown = table.columns.iter().map(|column| column.key).collect();
    Part::Table { file: file.into(), table, shown }
}

const ABOUT: &str = "`origami study contact -o FOLDER` writes this. Each pattern is folded from the open sheet, all creases at once, on one \
    thread: freely by `relax` with its defaults, and by `relax` under contact with its defaults, from three perturbations of \
    the start. *Crossings* are edges that go through triangles by the exact test; freely at the end, under contact at the end \
    and at every tenth evaluation, added up. Layers that a free sheet has brought to one plane but for its tolerance cross as \
    deep as that (`deepest_free` in the table's file). *Blocked* means that layers press and keep a crease 10 degrees or more \
    from its angle. All figures but times are the same on every machine.";

const ELSEWHERE: &str = "What else is asked for is held by tests of origami-core: gradients (`--test contact`, `--lib contact::barrier`, \
    `--lib contact::layers`) and Hessians by differences (`--lib contact::hessian`), no force and no torque of contact on the \
    whole sheet (`--lib contact::layers`), the energy of ten thousand steps (`--test contact ten_thousand -- --ignored`), a thousand \
    random folds (`--test contact a_thousand -- --ignored`).";

const ABOUT_TOUCHING: &str =
    "Of the three perturbations the worst, where layers touch under contact or cross without it:";

/// Those of a pattern at a percentage stand together.
fn groups(rows: &[Row]) -> impl Iterator<Item = &[Row]> {
    rows.chunk_by(|a, b| a.name == b.name && a.percent == b.percent)
}

fn worst(group: &[Row], of: impl Fn(&Row) -> Option<f64>) -> f64 {
    group.iter().filter_map(of).fold(f64::NAN, f64::max)
}

fn came(rows: &[Row]) -> impl Iterator<Item = (&Row, &Free, &Held)> {
    rows.iter().filter_map(|row| row.both().map(|(free, held)| (row, free, held)))
}

fn conclusions(rows: &[Row]) -> String {
    let count = |which: &dyn Fn(&Free, &Held) -> bool| came(rows).filter(|(_, free, held)| which(free, held)).count();
    format!(
        "Of {} folds {} end crossed freely. **Under contact {} have a crossing on the way or at the end**; {} converge, {} are \
         blocked, {} end at the limit of steps.",
        came(rows).count(),
        count(&|free, _| free.crossings > 0),
        count(&|_, held| held.came.crossings > 0),
        count(&|_, held| held.came.stop() == "converged"),
        count(&|_, held| held.came.stop() == "blocked"),
        count(&|_, held| held.came.stop() == "step limit"),
    )
}

/// How many times as many evaluations, off by how many degrees, strained by how much: at 100 %.
const FOLDED: [&str; 5] = ["bird-base", "miura", "strip", "waterbomb", "square-twist"];

/// What is asked of the patterns.
fn of_rows(rows: &[Row]) -> Vec<Asked> {
    let crossed: usize = rows.iter().filter_map(|row| Some(row.contact.as_ref().ok()?.came.crossings)).sum();
    let what = "crossings at the ends and at every tenth evaluation";
    let mut all = vec![Asked::that(what, "none", crossed.to_string(), crossed == 0)];
    let at_100 = || groups(rows).filter(|group| group[0].percent == 100.0);
    let named = |name: &str| at_100().find(|group| group[0].name == name);
    let stops = |group: &[Row], stop: &str| {
        group.iter().all(|row| row.contact.as_ref().is_ok_and(|held| held.came.stop() == stop))
    };
    let others = at_100().filter(|group| group[0].name != "crane").count();
    let converged = at_100().filter(|group| group[0].name != "crane" && stops(group, "converged")).count();
    all.push(Asked::that(
        "patterns that converge at 100 %",
        format!("all {others} but the crane"),
        converged.to_string(),
        converged == others,
    ));
    if let Some(crane) = named("crane") {
        let pairs = crane[0].contact.as_ref().map_or(String::new(), |held| held.came.pressing(1));
        let blocked = stops(crane, "blocked") && !pairs.is_empty();
        all.push(Asked::that("crane, all creases at once", "blocked, pairs named", format!("faces {pairs}"), blocked));
    }
    for name in FOLDED {
        let Some(group) = named(name) else { continue };
        let most = if name == "square-twist" { 3.0 } else { 1.7 };
        all.push(Asked::at_most(
            format!("{name}: evaluations, times those without contact"),
            most,
            worst(group, Row::times),
        ));
        let held = |row: &Row| row.contact.as_ref().ok().map(|held| held.came.off);
        all.push(Asked::at_most(format!("{name}: off (degrees)"), 1.5, worst(group, held)));
        let strain = |row: &Row| row.contact.as_ref().ok().map(|held| 100.0 * held.came.strain);
        all.push(Asked::at_most(format!("{name}: strain (%)"), 0.3, worst(group, strain)));
    }
    let open: Vec<f64> = rows.iter().filter(|row| !row.touches()).filter_map(Row::times).collect();
    if !open.is_empty() {
        let most = open.into_iter().fold(f64::NAN, f64::max);
        all.push(Asked::at_most("where nothing touches: evaluations, times those without contact", 1.3, most));
    }
    all
}

const TOUCHING_COLUMNS: &[Column] = &[
    column("pattern", "pattern", "its name"),
    column("percent", "%", "that it was folded to"),
    column("crossings_free", "crossings, free", "at the end, without contact"),
    column("crossings", "with contact", "at the end and at every tenth evaluation, of all perturbations"),
    column("ends", "ends", "of the runs under contact"),
    column("evaluations", "evaluations", "under contact"),
    column("times", "times free", "the evaluations over those without contact"),
    column(
        "cost",
        "one takes, times free",
        "the time of an evaluation over that of one without contact, on one thread",
    ),
    column("off_deg", "off (degrees)", "the largest difference of an angle from its target"),
    column("strain", "strain", "largest of a beam"),
    column("pressing", "pressing", "of blocked sheets: the faces that press hardest, in pairs"),
];

fn touching(rows: &[Row]) -> Table {
    let mut table = Table::new(TOUCHING_COLUMNS);
    let touches =
        |group: &&[Row]| group.iter().any(|row| row.touches() || row.free.as_ref().is_ok_and(|f| f.crossings > 0));
    for group in groups(rows).filter(touches) {
        let held = || group.iter().filter_map(|row| row.contact.as_ref().ok());
        let mut ends: Vec<&str> = held().map(|held| held.came.stop()).collect();
        ends.dedup();
        let blocked = held().find(|held| held.came.stop() == "blocked").map(|held| held.came.pressing(3));
        table.push(vec![
            group[0].name.as_str().into(),
            group[0].percent.into(),
            group.iter().filter_map(|row| Some(row.free.as_ref().ok()?.crossings)).max().into(),
            held().map(|held| held.came.crossings).sum::<usize>().into(),
            ends.join(", ").into(),
            held().map(|held| held.came.evaluations).max().into(),
            worst(group, Row::times).into(),
            worst(group, Row::cost).into(),
            worst(group, |row| Some(row.contact.as_ref().ok()?.came.off)).into(),
            worst(group, |row| Some(row.contact.as_ref().ok()?.came.strain)).into(),
            blocked.into(),
        ]);
    }
    table
}

const COLUMNS: &[Column] = &[
    column("pattern", "pattern", "its name"),
    column("vertices", "vertices", "of the sheet"),
    column("triangles", "triangles", "of the sheet"),
    column("percent", "%", "that it was folded to"),
    column("perturbation", "perturbation", "how far each node was moved at the start, as a share of its shortest beam"),
    column("crossings_free", "crossings, free", "at the end, without contact"),
    column("deepest_free", "deepest, free (radii)", "the depth of the deepest of these"),
    column("crossings", "with contact", "at the end and at every tenth evaluation, added up"),
    column("stop", "end", "of the run under contact"),
    column("evaluations_free", "evaluations, free", "force evaluations of all attempts"),
    column("evaluations", "with contact", "force evaluations"),
    column("times", "times free", "the evaluations over those without contact"),
    column("micros_free", "us an evaluation, free", "microseconds on one thread"),
    column("micros", "with contact", "the same"),
    column("cost", "times free", "the one over the other"),
    column("off_free_deg", "off, free (degrees)", "the largest difference of an angle from its target"),
    column("off_deg", "off, with contact (degrees)", "the same"),
    column("strain", "strain", "largest of a beam, under contact"),
    column("pairs", "pairs", "the most that were listed at one time"),
    column("limited", "limited", "evaluations in which a move was shortened"),
    column("first_percent", "first at (%)", "where that was first so"),
    column("least_gap", "least gap (radii)", "of layers that push at the end"),
    column("pressing", "pressing", "of a blocked sheet: the faces that press hardest, in pairs"),
    column("why_not", "why not", "why there is no end"),
];

fn table(rows: &[Row]) -> Table {
    let mut table = Table::new(COLUMNS);
    for row in rows {
        let (free, held) = (row.free.as_ref().ok(), row.contact.as_ref().ok());
        let came = held.map(|held| &held.came);
        let touch = came.map(|came| &came.touch);
        let why = [row.free.as_ref().err(), row.contact.as_ref().err()].into_iter().flatten().next();
        table.push(vec![
            row.name.as_str().into(),
            row.vertices.into(),
            row.triangles.into(),
            row.percent.into(),
            row.perturbation.into(),
            free.map(|free| free.crossings).into(),
            free.map(|free| free.deepest).into(),
            came.map(|came| came.crossings).into(),
            came.map(|came| came.stop()).into(),
            free.map(|free| free.evaluations).into(),
            came.map(|came| came.evaluations).into(),
            row.times().into(),
            free.map(|free| free.micros).into(),
            held.map(|held| held.micros).into(),
            row.cost().into(),
            free.map(|free| free.off).into(),
            came.map(|came| came.off).into(),
            came.map(|came| came.strain).into(),
            touch.map(|touch| touch.most_pairs).into(),
            touch.map(|touch| touch.limited).into(),
            touch.and_then(|touch| touch.first_limited).map(|share| share * row.percent).into(),
            touch.map(|touch| touch.least_gap).filter(|gap| gap.is_finite()).into(),
            came.filter(|came| came.stop() == "blocked").map(|came| came.pressing(3)).into(),
            why.map_or(Cell::Missing, |why| why.to_string().into()),
        ]);
    }
    table
}

/// Cost against size, a series for open sheets and one for stacked ones.
fn plots(rows: &[Row]) -> Vec<(&'static str, Plot)> {
    let plot = |title: &str, label: &str, y: &dyn Fn(&Row) -> Option<f64>| {
        let series = |label: &str, touching: bool| Series {
            label: label.into(),
            mark: Mark::Points,
            points: { rows.iter().filter(|row| row.touches() == touching) }
                .filter_map(|row| Some((row.triangles as f64, y(row)?)))
                .collect(),
        };
        let axis = |label: &str| Axis { label: label.into(), scale: Scale::Log };
        Plot {
            title: title.into(),
            note: "relax under contact against relax, one thread".into(),
            x: axis("triangles"),
            y: axis(label),
            series: vec![series("layers touch at the end", true), series("nothing touches", false)],
        }
    };
    vec![
        ("contact-evaluations", plot("Evaluations against those without contact", "times as many", &Row::times)),
        ("contact-cost", plot("An evaluation against one without contact", "times as long", &Row::cost)),
    ]
}
