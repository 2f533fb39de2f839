//! Tables of what a run wrote.

use std::collections::BTreeSet;
use std::fmt::Write;

use crate::kept::{Run, distinct};
use crate::results::Row;

/// All tables, one after the other.
///
/// # Errors
/// None, where they are written into a string.
pub(crate) fn write(run: &Run, text: &mut String) -> std::fmt::Result {
    tests(run, text)?;
    parity(run, text)?;
    speed(run, text)?;
    ensembles(run, text)?;
    folded(run, text)?;
    contact(run, text)?;
    others(run, text)
}

fn head(text: &mut String, above: &str, columns: &[String]) -> std::fmt::Result {
    writeln!(text, "\n{above}\n\n| {} |\n|{}", columns.join(" | "), "---|".repeat(columns.len()))
}

fn line(text: &mut String, cells: &[String]) -> std::fmt::Result {
    writeln!(text, "| {} |", cells.join(" | "))
}

fn cell(value: Option<f64>, show: impl Fn(f64) -> String) -> String {
    value.map_or_else(|| "-".to_owned(), show)
}

/// Seconds in the unit that fits them.
pub(crate) fn time(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-3 => (1e6 * s, "µs"),
        s if s < 1.0 => (1e3 * s, "ms"),
        s => (s, "s"),
    };
    let digits = if value < 10.0 {
        2
    } else if value < 100.0 {
        1
    } else {
        0
    };
    format!("{value:.digits$} {unit}")
}

fn yes(value: f64) -> String {
    if value > 0.0 { "yes" } else { "no" }.to_owned()
}

fn tests(run: &Run, text: &mut String) -> std::fmt::Result {
    if run.of("tests", "tests passed").next().is_none() {
        return Ok(());
    }
    head(text, "Tests:", &["program", "passed", "failed", "time"].map(String::from))?;
    for row in run.of("tests", "tests passed") {
        let of = |quantity| run.value("tests", quantity, |other| other.sheet == row.sheet);
        let count = |value: f64| format!("{value:.0}");
        line(text, &[row.sheet.clone(), count(row.value), cell(of("tests failed"), count), cell(of("seconds"), time)])?;
    }
    for row in run.of("tests", "passed").filter(|row| row.value == 0.0) {
        writeln!(text, "\n`{}` failed.", row.sheet)?;
    }
    Ok(())
}

fn parity(run: &Run, text: &mut String) -> std::fmt::Result {
    let far = "distance from the CPU after 300 steps, radii";
    let shape = "distance from the CPU's equilibrium, radii";
    let above = "Against the CPU in f64, at 60 %: the farthest vertex after 300 steps of dynamics, and in the folded state of a relaxation \
         (after the best rigid motion), in radii; whether both say that they converged, and after how many evaluations; whether two \
         runs gave the same bits, of either solver.";
    let columns = ["pattern", "vertices", "by", "dynamics", "folded state", "converged: CPU", "GPU", "same bits"];
    if run.of("parity", shape).next().is_none() {
        return Ok(());
    }
    head(text, above, &columns.map(String::from))?;
    for row in run.of("parity", shape) {
        let like = |by: &str, solver: &str, quantity: &str| {
            run.value("parity", quantity, |r| {
                (&r.sheet, r.vertices, &r.by[..], &r.solver[..]) == (&row.sheet, row.vertices, by, solver)
            })
        };
        let ended = |by: &str| {
            let count = |value| format!("{value:.0}");
            format!("{}, {}", cell(like(by, "relax", "converged"), yes), cell(like(by, "relax", "evaluations"), count))
        };
        let bits = ["dynamics", "relax"].map(|solver| cell(like(&row.by, solver, "same bits"), yes));
        line(
            text,
            &[
                row.sheet.clone(),
                row.vertices.to_string(),
                row.by.clone(),
                cell(like(&row.by, "dynamics", far), |far| format!("{far:.1e}")),
                format!("{:.1e}", row.value),
                ended("CPU"),
                ended(&row.by),
                bits.join(", "),
            ],
        )?;
    }
    Ok(())
}

fn speed(run: &Run, text: &mut String) -> std::fmt::Result {
    let each = "seconds a step";
    for solver in ["dynamics", "relax"] {
        let rows = || run.of("speed", each).filter(|row| row.solver == solver);
        let by = distinct(rows().map(|row| row.by.as_str()));
        let sizes: BTreeSet<usize> = rows().map(|row| row.vertices).collect();
        if sizes.is_empty() {
            continue;
        }
        let above = format!(
            "One step of `{solver}`, Miura sheets on their way to 60 %; the last column is the best of the GPU."
        );
        let mut columns = vec!["vertices".to_owned()];
        columns.extend(by.iter().map(ToString::to_string));
        columns.push("vertices times steps a second".to_owned());
        head(text, &above, &columns)?;
        for size in &sizes {
            let of = |by: &str| rows().find(|row| row.by == by && row.vertices == *size).map(|row| row.value);
            let best = best(rows().filter(|row| row.vertices == *size), "GPU");
            let mut cells = vec![size.to_string()];
            cells.extend(by.iter().map(|by| cell(of(by), time)));
            cells.push(cell(best, |seconds| format!("{:.2e}", *size as f64 / seconds)));
            line(text, &cells)?;
        }
        writeln!(text)?;
        for processor in by.iter().filter(|by| by.starts_with("CPU")) {
            let gains = |size: &usize| {
                let here = || rows().filter(|row| row.vertices == *size);
                Some(best(here(), processor)? / best(here(), "GPU")?)
            };
            let from = crossover(sizes.iter().filter_map(|size| Some((*size, gains(size)?))));
            match from {
                Some(size) => writeln!(text, "- `{solver}`, {processor}: the GPU gains from {size} vertices on.")?,
                None => writeln!(
                    text,
                    "- `{solver}`, {processor}: the GPU gains at none of these sizes, or not at the largest."
                )?,
            }
        }
    }
    floors(run, text)
}

/// The least of the rows whose `by` begins so.
fn best<'r>(rows: impl Iterator<Item = &'r Row>, by: &str) -> Option<f64> {
    rows.filter(|row| row.by.starts_with(by)).map(|row| row.value).reduce(f64::min)
}

/// The size from which on every gain is above 1, of sizes in order; `None` where the last is not.
fn crossover(gains: impl Iterator<Item = (usize, f64)>) -> Option<usize> {
    gains.fold(None, |from, (size, gain)| if gain > 1.0 { from.or(Some(size)) } else { None })
}

/// How near the time of a step is to what its bytes take at least.
fn floors(run: &Run, text: &mut String) -> std::fmt::Result {
    let copied = run.of("memory", "bytes read and written in a second by copies").next().map(|row| row.value);
    let Some(bandwidth) = copied else { return Ok(()) };
    let above = format!(
        "Copies of a buffer read and write {:.0} GB/s. What the buffers of a step take at that rate, and how many times as long a \
         step took:",
        bandwidth / 1e9
    );
    head(
        text,
        &above,
        &["vertices", "solver", "by", "bytes a vertex and step", "floor", "of the floor"].map(String::from),
    )?;
    for row in run.of("speed", "bytes a step").filter(|row| row.vertices >= 10_000) {
        let same = |other: &Row| (other.vertices, &other.by, &other.solver) == (row.vertices, &row.by, &row.solver);
        let Some(measured) = run.value("speed", "seconds a step", same) else { continue };
        let floor = row.value / bandwidth;
        line(
            text,
            &[
                row.vertices.to_string(),
                row.solver.clone(),
                row.by.clone(),
                format!("{:.0}", row.value / row.vertices as f64),
                time(floor),
                format!("{:.2}", measured / floor),
            ],
        )?;
    }
    Ok(())
}

fn ensembles(run: &Run, text: &mut String) -> std::fmt::Result {
    for sheet in distinct(run.rows.iter().filter(|row| row.section == "ensembles").map(|row| row.sheet.as_str())) {
        let rows = |quantity| run.of("ensembles", quantity).filter(move |row| row.sheet == sheet);
        let (step, whole) = ("seconds a step of all", "seconds until all are folded");
        let [steps_by, whole_by] = [step, whole].map(|quantity| distinct(rows(quantity).map(|row| row.by.as_str())));
        let counts: BTreeSet<usize> = rows(step).chain(rows(whole)).map(|row| row.sheets).collect();
        let vertices = rows(whole).chain(rows(step)).next().map_or(0, |row| row.vertices);
        let above = format!(
            "Many sheets of {vertices} vertices (`{sheet}`) at once, by `relax`: a step of all, and until all are folded."
        );
        let mut columns = vec!["sheets".to_owned()];
        columns.extend(steps_by.iter().map(|by| format!("a step: {by}")));
        columns.extend(whole_by.iter().map(|by| format!("folded: {by}")));
        head(text, &above, &columns)?;
        for count in &counts {
            let of = |quantity, by: &str| rows(quantity).find(|r| r.sheets == *count && r.by == by).map(|r| r.value);
            let mut cells = vec![count.to_string()];
            cells.extend(steps_by.iter().map(|by| cell(of(step, by), time)));
            cells.extend(whole_by.iter().map(|by| cell(of(whole, by), time)));
            line(text, &cells)?;
        }
    }
    Ok(())
}

fn folded(run: &Run, text: &mut String) -> std::fmt::Result {
    let (folded, not) = ("seconds until it is folded", "seconds without being folded");
    let rows = || run.of("folded", folded).chain(run.of("folded", not));
    let by = distinct(rows().map(|row| row.by.as_str()));
    let sizes: BTreeSet<usize> = rows().map(|row| row.vertices).collect();
    if sizes.is_empty() {
        return Ok(());
    }
    let mut columns = vec!["vertices".to_owned()];
    columns.extend(by.iter().map(ToString::to_string));
    head(
        text,
        "From the sheet at rest to the folded state, Miura sheets at 60 %, with all that is built before; evaluations:",
        &columns,
    )?;
    for size in &sizes {
        let of = |by: &&str| {
            let like = |row: &Row| row.vertices == *size && row.by == **by;
            let evaluations = cell(run.value("folded", "evaluations", like), |value| format!("{value:.0}"));
            match (run.value("folded", folded, like), run.value("folded", not, like)) {
                (Some(seconds), _) => format!("{}, {evaluations}", time(seconds)),
                (None, Some(seconds)) => format!("more than {}, {evaluations}", time(seconds)),
                (None, None) => "-".to_owned(),
            }
        };
        line(text, &std::iter::once(size.to_string()).chain(by.iter().map(of)).collect::<Vec<_>>())?;
    }
    Ok(())
}

fn contact(run: &Run, text: &mut String) -> std::fmt::Result {
    let whole = "seconds until it is at rest";
    let by = distinct(run.of("contact", whole).map(|row| row.by.as_str()));
    if by.is_empty() {
        return Ok(());
    }
    let above = "Folded flat under contact, with all that is built before: seconds, evaluations, crossings; the most pairs that were \
         listed, and how far fold angles on the GPU are from the processor's, in degrees:";
    let mut columns = ["pattern", "vertices"].map(String::from).to_vec();
    columns.extend(by.iter().map(ToString::to_string));
    columns.extend(["pairs", "angles apart"].map(String::from));
    head(text, above, &columns)?;
    let first = by.first().copied().unwrap_or_default();
    for row in run.of("contact", whole).filter(|row| row.by == first) {
        let of = |by: &str, quantity: &str| {
            run.value("contact", quantity, |r| (&r.sheet, r.vertices, &r.by[..]) == (&row.sheet, row.vertices, by))
        };
        let count = |value: f64| format!("{value:.0}");
        let ended = |by: &&str| {
            let blocked = if of(by, "blocked") == Some(1.0) { ", blocked" } else { "" };
            let (evaluations, crossings) = (cell(of(by, "evaluations"), count), cell(of(by, "crossings"), count));
            format!("{}, {evaluations}, {crossings}{blocked}", cell(of(by, whole), time))
        };
        let mut cells = vec![row.sheet.clone(), row.vertices.to_string()];
        cells.extend(by.iter().map(ended));
        cells.push(cell(of(first, "most pairs"), count));
        cells.push(cell(of(first, "fold angles from the CPU's, degrees"), |far| format!("{far:.1e}")));
        line(text, &cells)?;
    }
    Ok(())
}

/// Memory and pictures, as they stand in the file.
fn others(run: &Run, text: &mut String) -> std::fmt::Result {
    let rows = || run.rows.iter().filter(|row| ["memory", "pictures"].contains(&row.section.as_str()));
    if rows().next().is_none() {
        return Ok(());
    }
    head(
        text,
        "Memory, and pictures of 1000 x 800 pixels:",
        &["sheet", "vertices", "by", "what", "figure"].map(String::from),
    )?;
    for row in rows() {
        let value = match row.quantity.as_str() {
            quantity if quantity.starts_with("seconds") => time(row.value),
            quantity if quantity.starts_with("bytes") => format!("{:.3e}", row.value),
            _ => format!("{:.1e}", row.value),
        };
        let what = row.quantity.trim_start_matches("seconds, ").to_owned();
        line(text, &[row.sheet.clone(), row.vertices.to_string(), row.by.clone(), what, value])?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gpu_gains_from_where_it_never_loses_again() {
        let gains = |gains: &[f64]| crossover(gains.iter().enumerate().map(|(i, gain)| (i, *gain)));
        assert_eq!(gains(&[0.1, 1.1, 0.9, 2.0, 3.0]), Some(3));
        assert_eq!(gains(&[0.1, 1.1, 0.9]), None);
        assert_eq!(gains(&[]), None);
    }

    #[test]
    fn times_are_told_in_the_unit_that_fits() {
        assert_eq!([2.5e-6, 0.0123, 45.678].map(time), ["2.50 µs", "12.3 ms", "45.7 s"]);
    }
}
