//! The document: tables, plots, and words that are computed from the rows.

use super::row::{CLOSED, End, Found, Missing, NEAR, PART, Row, Way};
use crate::plot::{Axis, Mark, Plot, Scale, Series};
use crate::table::{Cell, Column, Table, column};
use crate::{Part, Study};

/// Energies within this share of each other are of one state.
const SAME_ENERGY: f64 = 0.01;
/// The largest sizes of the classes, in vertices; the last class is above.
const CLASSES: [usize; 4] = [150, 400, 1000, 2600];

/// The study of what was run.
pub(super) fn study(rows: &[Row]) -> Study {
    let mut parts = vec![Part::Text(about()), Part::Text(conclusions(rows))];
    let missing: Vec<&str> =
        rows.iter().filter(|r| matches!(r.result, Err(Missing::LeftOut))).map(|r| r.name.as_str()).collect();
    if !missing.is_empty() {
        parts.push(Part::Text(format!("There was no time for {}.", missing.join(", "))));
    }
    parts.push(Part::Heading("By size".into()));
    parts.push(whole("flat-sizes", sizes(rows)));
    parts.extend(plots(rows).into_iter().map(|(file, plot)| Part::Plot { file: file.into(), plot }));
    parts.push(Part::Heading(format!("Two ways to {PART} %")));
    parts.push(Part::Text(about_part(rows)));
    let shown =
        vec!["pattern", "vertices", "closed_energy", "energy_ratio", "closed_evaluations", "opened_evaluations"];
    parts.push(Part::Table { file: "flat-60".into(), table: two_ways(rows), shown });
    parts.push(Part::Heading("All patterns".into()));
    let shown = vec![
        "pattern",
        "vertices",
        "on",
        "arrived",
        "distance",
        "crossings",
        "wrong",
        "attempts",
        "evaluations",
        "seconds",
    ];
    parts.push(Part::Table { file: "flat-patterns".into(), table: patterns(rows), shown });
    Study { name: "flat", title: "Flat folding: to the exact state by motion alone".into(), parts }
}

fn whole(file: &str, table: Table) -> Part {
    let shown = table.columns.iter().map(|column| column.key).collect();
    Part::Table { file: file.into(), table, shown }
}

fn about() -> String {
    format!(
        "The flat-folded state of each pattern is constructed by reflecting its faces; patterns that miss themselves by more \
         than {CLOSED:e} of the radius are left out, and say so. Then `relax`, which knows nothing of it, folds the open sheet \
         to 100 %, with its defaults. *Arrived* means that every vertex ends within {NEAR:e} of the radius of where it lies in \
         the exact state, beside the file's own misfit, after the best rigid motion. Layers are not in the model. Evaluations \
         and seconds are of all attempts together."
    )
}

/// All runs to 100 % on the processor that came to an end of some kind.
fn ended(rows: &[Row]) -> impl Iterator<Item = (&Row, &Way, &End)> {
    let processor = |row| Row::found(row).and_then(|found| found.ways.first()).map(|way| (row, way));
    rows.iter().filter_map(processor).filter_map(|(row, way)| Some((row, way, way.end.as_ref().ok()?)))
}

fn conclusions(rows: &[Row]) -> String {
    let run = rows.iter().filter_map(Row::found).count();
    let arrived = ended(rows).filter(|(.., end)| end.arrived).count();
    let evaluations: u64 = ended(rows).map(|(.., end)| end.evaluations).sum();
    let lost: u64 = ended(rows).filter(|(.., end)| !end.arrived).map(|(.., end)| end.evaluations).sum();
    let false_claims = ended(rows).filter(|(.., end)| end.converged && !end.arrived && end.strain < NEAR).count();
    let mut text = format!(
        "**{arrived} of {run} patterns arrive**, in {evaluations} evaluations; {lost} of them in runs that do not arrive."
    );
    if false_claims > 0 {
        text += &format!(" {false_claims} end without strain in another state: some have more than one.");
    }
    text
}

const SIZE_COLUMNS: &[Column] = &[
    column("size", "vertices", "of the sheets, from and to"),
    column("patterns", "patterns", "that have a flat-folded state"),
    column("arrived", "arrived", "those that were folded to it"),
    column("evaluations_median", "evaluations, median", "force evaluations of a run, the middle one of all"),
    column("evaluations_max", "max", "the most of them"),
    column("evaluations", "in sum", "of all runs"),
    column("seconds_median", "seconds, median", "of solving, on all threads, the middle one"),
    column("seconds_max", "max", "the longest"),
];

fn sizes(rows: &[Row]) -> Table {
    let mut table = Table::new(SIZE_COLUMNS);
    let mut from = 1;
    for to in CLASSES.into_iter().chain([usize::MAX]) {
        let name = if to == usize::MAX { format!("{from} and more") } else { format!("{from} to {to}") };
        let within = |row: &&Row| (from..=to).contains(&row.vertices);
        if rows.iter().filter(within).any(|row| row.found().is_some()) {
            table.push(size(name, rows.iter().filter(within)));
        }
        from = to.saturating_add(1);
    }
    table.push(size("all".into(), rows.iter()));
    table
}

fn size<'r>(name: String, rows: impl Iterator<Item = &'r Row>) -> Vec<Cell> {
    let ways: Vec<&Way> = rows.filter_map(|row| row.found()?.ways.first()).collect();
    let ends = || ways.iter().filter_map(|way| way.end.as_ref().ok());
    let mut evaluations: Vec<u64> = ends().map(|end| end.evaluations).collect();
    evaluations.sort_unstable();
    let mut seconds: Vec<f64> = ways.iter().map(|way| way.seconds).collect();
    seconds.sort_by(f64::total_cmp);
    vec![
        name.into(),
        ways.len().into(),
        ends().filter(|end| end.arrived).count().into(),
        evaluations.get(evaluations.len() / 2).copied().into(),
        evaluations.last().copied().into(),
        evaluations.iter().sum::<u64>().into(),
        seconds.get(seconds.len() / 2).copied().into(),
        seconds.last().copied().into(),
    ]
}

const COLUMNS: &[Column] = &[
    column("pattern", "pattern", "its name"),
    column("vertices", "vertices", "of the sheet"),
    column("on", "on", "the processor, or the name of a GPU"),
    column("closure", "closure (radii)", "how far the exact state misses itself, which is the file's own misfit"),
    column("arrived", "arrived", "whether the sheet ends in the exact state"),
    column("converged", "converged", "whether the solver says that it is in an equilibrium"),
    column("distance", "distance (radii)", "largest distance of a vertex from the exact state"),
    column("strain", "strain", "largest of a beam"),
    column(
        "crossings",
        "crossings",
        "edges that go through triangles at the end: layers lie in one plane but for the tolerance",
    ),
    column("energy", "energy", "in the model's unit"),
    column("wrong", "wrong way", "creases more than half a turn from their targets"),
    column("attempts", "attempts", "ways that were tried"),
    column("evaluations", "evaluations", "force evaluations of all attempts"),
    column("seconds", "seconds", "of solving, on all threads"),
    column("why_not", "why not", "why there is no exact state, or no end"),
];

fn patterns(rows: &[Row]) -> Table {
    let mut table = Table::new(COLUMNS);
    for row in rows {
        let head =
            |on: Cell, closure: Option<f64>| vec![row.name.as_str().into(), row.vertices.into(), on, closure.into()];
        let nothing = |why: &str| [vec![Cell::Missing; COLUMNS.len() - 5], vec![why.into()]].concat();
        match &row.result {
            Err(Missing::LeftOut) => {}
            Err(Missing::NotFlat(why)) => table.push([head(Cell::Missing, None), nothing(why)].concat()),
            Ok(found) => {
                for way in &found.ways {
                    let rest = way.end.as_ref().map_or_else(|why| nothing(why), |end| cells(end, way.seconds));
                    table.push([head(way.on.as_str().into(), Some(found.closure)), rest].concat());
                }
            }
        }
    }
    table
}

fn cells(end: &End, seconds: f64) -> Vec<Cell> {
    vec![
        end.arrived.into(),
        end.converged.into(),
        end.distance.into(),
        end.strain.into(),
        end.crossings.into(),
        end.energy.into(),
        end.wrong.into(),
        u64::from(end.attempts).into(),
        end.evaluations.into(),
        seconds.into(),
        Cell::Missing,
    ]
}

const PART_COLUMNS: &[Column] = &[
    column("pattern", "pattern", "its name"),
    column("vertices", "vertices", "of the sheet"),
    column("closed_energy", "energy, closed", "where the open sheet is closed, in the model's unit"),
    column("opened_energy", "opened", "where the flat-folded sheet is opened"),
    column("energy_ratio", "opened / closed", "the energies: below 1 where opening ends lower"),
    column("closed_wrong", "wrong way, closed", "creases more than half a turn from their targets"),
    column("opened_wrong", "opened", "the same"),
    column("closed_evaluations", "evaluations, closed", "force evaluations of all attempts"),
    column("opened_evaluations", "opened", "the same"),
    column("closed_converged", "converged, closed", "whether the solver says so"),
    column("opened_converged", "opened", "the same"),
];

/// Both ends at the part of the way, where there are two.
fn both(found: &Found) -> Option<(&End, &End)> {
    Some((found.closed.end.as_ref().ok()?, found.opened.end.as_ref().ok()?))
}

fn two_ways(rows: &[Row]) -> Table {
    let mut table = Table::new(PART_COLUMNS);
    for (row, (closed, opened)) in rows.iter().filter_map(|row| Some((row, both(row.found()?)?))) {
        table.push(vec![
            row.name.as_str().into(),
            row.vertices.into(),
            closed.energy.into(),
            opened.energy.into(),
            (opened.energy / closed.energy).into(),
            closed.wrong.into(),
            opened.wrong.into(),
            closed.evaluations.into(),
            opened.evaluations.into(),
            closed.converged.into(),
            opened.converged.into(),
        ]);
    }
    table
}

fn about_part(rows: &[Row]) -> String {
    let all: Vec<(&End, &End)> = rows.iter().filter_map(|row| both(row.found()?)).collect();
    let ends = |which: &dyn Fn(&End, &End) -> bool| all.iter().filter(|(closed, opened)| which(closed, opened)).count();
    let lower = |a: &End, b: &End| a.energy < b.energy - SAME_ENERGY * b.energy.abs().max(1e-9);
    format!(
        "The energy of where the flat-folded sheet is opened to {PART} % (`--from-flat`) against that of where the open sheet \
         is closed to it. Of {} patterns opening ends lower in {}, higher in {}, and within {} % in the others; it takes {} \
         evaluations in sum, closing {}. Creases that closed the wrong way are left in {} when opened, in {} when closed.",
        all.len(),
        ends(&|closed, opened| lower(opened, closed)),
        ends(&|closed, opened| lower(closed, opened)),
        100.0 * SAME_ENERGY,
        all.iter().map(|(_, opened)| opened.evaluations).sum::<u64>(),
        all.iter().map(|(closed, _)| closed.evaluations).sum::<u64>(),
        ends(&|_, opened| opened.wrong > 0),
        ends(&|closed, _| closed.wrong > 0),
    )
}

/// Evaluations, seconds and distance against the size, a series for those that arrive and one for those that do not.
fn plots(rows: &[Row]) -> Vec<(&'static str, Plot)> {
    let plot = |title: &str, label: &str, y: &dyn Fn(&Way, &End) -> Option<f64>| {
        let series = |label: &str, arrived: bool| Series {
            label: label.into(),
            mark: Mark::Points,
            points: ended(rows)
                .filter(|(.., end)| end.arrived == arrived)
                .filter_map(|(row, way, end)| Some((row.vertices as f64, y(way, end)?)))
                .collect(),
        };
        let axis = |label: &str| Axis { label: label.into(), scale: Scale::Log };
        Plot {
            title: title.into(),
            note: "relax to 100 %, all attempts together".into(),
            x: axis("vertices"),
            y: axis(label),
            series: vec![series("arrived", true), series("elsewhere", false)],
        }
    };
    vec![
        (
            "flat-evaluations",
            plot("Evaluations against size", "force evaluations", &|_, end| Some(end.evaluations as f64)),
        ),
        ("flat-seconds", plot("Time against size", "seconds of solving", &|way, _| Some(way.seconds))),
        (
            "flat-distance",
            plot("Distance from the exact state", "largest of a vertex, in radii", &|_, end| end.distance),
        ),
    ]
}
