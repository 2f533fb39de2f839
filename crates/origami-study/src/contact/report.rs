//! The document: a table, plots, and words that are computed from the rows.

use super::row::{Held, Row, Way};
use crate::plot::{Axis, Mark, Plot, Scale, Series};
use crate::table::{Cell, Column, Table, column};
use crate::{Part, Study};

/// The study of what was run.
pub(super) fn study(rows: &[Row], left_out: &[String]) -> Study {
    let mut parts = vec![Part::Text(ABOUT.into()), Part::Text(conclusions(rows))];
    if !left_out.is_empty() {
        parts.push(Part::Text(format!("There was no time for {}.", left_out.join(", "))));
    }
    let shown = vec![
        "pattern",
        "triangles",
        "percent",
        "crossings_free",
        "crossings",
        "stop",
        "evaluations_free",
        "evaluations",
        "micros_free",
        "micros",
        "off_deg",
        "strain",
    ];
    parts.push(Part::Table { file: "contact-patterns".into(), table: table(rows), shown });
    parts.extend(plots(rows).into_iter().map(|(file, plot)| Part::Plot { file: file.into(), plot }));
    Study {
        name: "contact",
        title: "Contact: what goes through what, and what keeping it from that costs".into(),
        parts,
    }
}

const ABOUT: &str = "Each pattern is folded from the open sheet, all creases at once, on one thread: freely by `relax` with its \
    defaults, and by `relax` under contact with its defaults. *Crossings* are edges that go through triangles by the exact \
    test; freely at the end, under contact at the end and at every tenth evaluation. Layers that a free sheet has brought to \
    one plane but for its tolerance cross as deep as that (`deepest_free` in the table's file). *Blocked* means that layers \
    press and keep a crease 10 degrees or more from its angle.";

/// All runs of both kinds that came to an end.
fn both(rows: &[Row]) -> impl Iterator<Item = (&Row, &Way, &Way, &Held)> {
    rows.iter().filter_map(|row| {
        let (contact, held) = row.contact.as_ref().ok()?;
        Some((row, row.free.as_ref().ok()?, contact, held))
    })
}

fn conclusions(rows: &[Row]) -> String {
    let count = |which: &dyn Fn(&Way, &Way, &Held) -> bool| both(rows).filter(|(_, f, c, h)| which(f, c, h)).count();
    let all = both(rows).count();
    format!(
        "Of {all} folds {} end crossed freely. **Under contact {} have a crossing on the way or at the end**; {} converge, {} are \
         blocked, {} end at the limit of steps.",
        count(&|free, _, _| free.crossings > 0),
        count(&|_, contact, _| contact.crossings > 0),
        count(&|_, _, held| held.stop == "converged"),
        count(&|_, _, held| held.stop == "blocked"),
        count(&|_, _, held| held.stop == "step limit"),
    )
}

const COLUMNS: &[Column] = &[
    column("pattern", "pattern", "its name"),
    column("vertices", "vertices", "of the sheet"),
    column("triangles", "triangles", "of the sheet"),
    column("percent", "%", "that it was folded to"),
    column("crossings_free", "crossings, free", "at the end, without contact"),
    column("deepest_free", "deepest, free (radii)", "the depth of the deepest of these"),
    column("crossings", "with contact", "at the end and at every tenth evaluation, added up"),
    column("stop", "end", "of the run under contact"),
    column("evaluations_free", "evaluations, free", "force evaluations of all attempts"),
    column("evaluations", "with contact", "force evaluations"),
    column("micros_free", "us an evaluation, free", "microseconds on one thread"),
    column("micros", "with contact", "the same"),
    column("off_free_deg", "off, free (degrees)", "the largest difference of an angle from its target"),
    column("off_deg", "off, with contact (degrees)", "the same"),
    column("strain", "strain", "largest of a beam, under contact"),
    column("pairs", "pairs", "the most that were listed at one time"),
    column("limited", "limited", "evaluations in which a move was shortened"),
    column("first_percent", "first at (%)", "where that was first so"),
    column("least_gap", "least gap (radii)", "of layers that push at the end"),
    column("why_not", "why not", "why there is no end"),
];

fn table(rows: &[Row]) -> Table {
    let mut table = Table::new(COLUMNS);
    for row in rows {
        let free = row.free.as_ref().ok();
        let contact = row.contact.as_ref().ok();
        let way = contact.map(|(way, _)| way);
        let held = contact.map(|(_, held)| held);
        let why = [row.free.as_ref().err(), row.contact.as_ref().err()].into_iter().flatten().next();
        table.push(vec![
            row.name.as_str().into(),
            row.vertices.into(),
            row.triangles.into(),
            row.percent.into(),
            free.map(|way| way.crossings).into(),
            free.map(|way| way.deepest).into(),
            way.map(|way| way.crossings).into(),
            held.map(|held| held.stop).into(),
            free.map(|way| way.evaluations).into(),
            way.map(|way| way.evaluations).into(),
            free.map(|way| way.micros).into(),
            way.map(|way| way.micros).into(),
            free.map(|way| way.off).into(),
            way.map(|way| way.off).into(),
            way.map(|way| way.strain).into(),
            held.map(|held| held.touch.most_pairs).into(),
            held.map(|held| held.touch.limited).into(),
            held.and_then(|held| held.touch.first_limited).map(|share| share * row.percent).into(),
            held.map(|held| held.touch.least_gap).filter(|gap| gap.is_finite()).into(),
            why.map_or(Cell::Missing, |why| why.as_str().into()),
        ]);
    }
    table
}

/// Cost against size, a series for open sheets and one for stacked ones.
fn plots(rows: &[Row]) -> Vec<(&'static str, Plot)> {
    let plot = |title: &str, label: &str, y: &dyn Fn(&Way, &Way) -> f64| {
        let series = |label: &str, touching: bool| Series {
            label: label.into(),
            mark: Mark::Points,
            points: both(rows)
                .filter(|(.., held)| held.touch.least_gap.is_finite() == touching)
                .map(|(row, free, contact, _)| (row.triangles as f64, y(free, contact)))
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
        (
            "contact-evaluations",
            plot("Evaluations against those without contact", "times as many", &|free, contact| {
                contact.evaluations as f64 / free.evaluations as f64
            }),
        ),
        (
            "contact-cost",
            plot("An evaluation against one without contact", "times as long", &|free, contact| {
                contact.micros / free.micros
            }),
        ),
    ]
}
