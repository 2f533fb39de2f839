//! Tables of what runs wrote, for BENCHMARKS.md.

use std::collections::BTreeSet;
use std::error::Error;
use std::fmt::Write;
use std::path::Path;

use serde_json::Value;

use crate::results::{self, Row};
use crate::{figures, machine, run};

/// Between these lines of a document stands what is written here.
const BEGIN: &str = "<!-- on-a-gpu: what follows is written by the command that it names -->\n";
const END: &str = "<!-- on-a-gpu ends -->\n";

/// Puts a part for each folder into the document at `path`, in place of those that it has, and their plots into the folder
/// `plots`.
///
/// # Errors
/// If a folder was not written by a run, the document has no place for them, or something cannot be written.
pub(crate) fn write(path: &Path, plots: &Path, folders: &[&str]) -> Result<(), Box<dyn Error>> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut parts = String::new();
    for folder in folders {
        let run = Run::read(folder.as_ref())?;
        let drawn = figures::draw(&run, plots)?;
        // A document names its plots from where it lies.
        let beside = path.parent().unwrap_or_else(|| Path::new(""));
        let links = drawn
            .iter()
            .map(|plot| plot.strip_prefix(beside).unwrap_or(plot).display().to_string())
            .collect::<Vec<_>>();
        parts += &part(&run, &links)?;
    }
    if parts.is_empty() {
        parts += "\nNo run has been kept yet.\n";
    }
    let whole = replaced(&text, &parts).ok_or(format!("{}: has no line {BEGIN}", path.display()))?;
    Ok(std::fs::write(path, whole)?)
}

/// The text with other words between the two lines; `None` where it lacks them.
fn replaced(text: &str, parts: &str) -> Option<String> {
    let (before, rest) = text.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{BEGIN}{parts}\n{END}{after}"))
}

/// What a run wrote.
pub(crate) struct Run {
    /// The folder's own name.
    pub(crate) name: String,
    folder: String,
    pub(crate) rows: Vec<Row>,
    machine: Value,
    run: Value,
}

impl Run {
    fn read(folder: &Path) -> Result<Self, Box<dyn Error>> {
        let json = |name: &str| -> Result<Value, Box<dyn Error>> {
            let path = folder.join(name);
            let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
            Ok(serde_json::from_str(&text)?)
        };
        let name = folder.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let rows = results::read(folder)?;
        let folder = folder.display().to_string();
        let (machine, run) = (json(machine::FILE)?, json(run::FILE)?);
        Ok(Self { name, rows, machine, run, folder })
    }

    /// `name (interface)`, and whether it is software.
    pub(crate) fn adapter(&self) -> String {
        let of = |key: &str| self.machine["adapter"][key].as_str().unwrap_or("?");
        let software = if of("kind") == "software" { ", a software adapter" } else { "" };
        format!("{} ({}){software}", of("name"), of("backend"))
    }

    pub(crate) fn of<'r>(&'r self, section: &'r str, quantity: &'r str) -> impl Iterator<Item = &'r Row> {
        self.rows.iter().filter(move |row| row.section == section && row.quantity == quantity)
    }

    /// The figure of one row like `like`.
    fn value(&self, section: &str, quantity: &str, like: impl Fn(&Row) -> bool) -> Option<f64> {
        self.of(section, quantity).find(|row| like(row)).map(|row| row.value)
    }
}

/// Each once, in the order in which they come.
pub(crate) fn distinct<'r>(of: impl Iterator<Item = &'r str>) -> Vec<&'r str> {
    let mut seen = BTreeSet::new();
    of.filter(|name| seen.insert(*name)).collect()
}

fn part(run: &Run, plots: &[String]) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    let machine = |key: &str| run.machine[key].as_str().unwrap_or("?").to_owned();
    let driver = run.machine["adapter"]["driver"].as_str().unwrap_or("?");
    writeln!(text, "\n### On {}\n", run.adapter())?;
    writeln!(
        text,
        "Driver {driver}; {}, {} threads, {} of memory, load {} before. `./on-a-gpu run` at commit {} wrote `{}`, of which `cargo run \
         --release -p origami-tools --bin on_a_gpu -- tables` made this.",
        machine("processor"),
        run.machine["threads"],
        machine("memory"),
        machine("load").split(' ').next().unwrap_or("?"),
        run.run["commit"].as_str().unwrap_or("?"),
        run.folder
    )?;
    if run.run["rehearsal"] == true {
        writeln!(text, "\nA rehearsal, which tells that everything runs, and nothing of speed.")?;
    }
    for section in run.run["sections"].as_array().into_iter().flatten() {
        match section["ended"].as_str() {
            Some(run::WHOLE) => {}
            ended => writeln!(
                text,
                "\nThe section `{}` ended otherwise than whole: {}.",
                section["section"].as_str().unwrap_or("?"),
                ended.unwrap_or("?")
            )?,
        }
    }
    tests(run, &mut text)?;
    parity(run, &mut text)?;
    speed(run, &mut text)?;
    ensembles(run, &mut text)?;
    folded(run, &mut text)?;
    others(run, &mut text)?;
    plots.iter().try_for_each(|plot| writeln!(text, "\n![{}]({plot})", run.adapter()))?;
    Ok(text)
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
    fn only_what_stands_between_the_lines_is_replaced() {
        let text = format!("above\n{BEGIN}old\n{END}below\n");
        let new = replaced(&text, "\nnew\n").expect("it has both lines");
        assert_eq!(new, format!("above\n{BEGIN}\nnew\n\n{END}below\n"));
        assert_eq!(replaced(&new, "\nnew\n"), Some(new.clone()), "again the same");
        assert_eq!(replaced("above\n", "new"), None);
    }

    /// A run on a software adapter of two sizes, with a sheet that was not folded in its time.
    fn run() -> Run {
        let row = |section: &str, vertices, by: &str, quantity: &str, value| Row {
            section: section.into(),
            sheet: "miura".into(),
            vertices,
            sheets: 1,
            solver: "relax".into(),
            by: by.into(),
            quantity: quantity.into(),
            value,
        };
        let (gpu, cpu, each) = ("GPU, passes", "CPU, f64, one thread", "seconds a step");
        let rows = vec![
            row("speed", 100, gpu, each, 2e-5),
            row("speed", 100, cpu, each, 4e-6),
            row("speed", 10_000, gpu, each, 5e-5),
            row("speed", 10_000, cpu, each, 5e-4),
            row("speed", 10_000, gpu, "bytes a step", 8e6),
            row("memory", 0, "GPU", "bytes read and written in a second by copies", 2e12),
            row("folded", 10_000, gpu, "seconds until it is folded", 0.25),
            row("folded", 10_000, gpu, "evaluations", 1234.0),
            row("folded", 10_000, cpu, "seconds without being folded", 60.0),
        ];
        let machine = serde_json::json!({
            "adapter": { "name": "llvmpipe", "backend": "Vulkan", "kind": "software", "driver": "Mesa" },
            "processor": "Any 1000", "threads": 16, "memory": "64 kB", "load": "0.5 1 2",
        });
        let run = serde_json::json!({ "commit": "abc", "sections": [
            { "section": "speed", "ended": run::WHOLE }, { "section": "folded", "ended": run::OUT_OF_TIME },
        ] });
        Run { name: "some".into(), folder: "docs/gpu/some".into(), rows, machine, run }
    }

    #[test]
    fn a_part_has_every_figure_and_tells_what_was_cut() {
        let text = part(&run(), &["gpu/some-relax.svg".into()]).expect("written");
        for line in [
            "### On llvmpipe (Vulkan), a software adapter",
            "The section `folded` ended otherwise than whole: out of time.",
            "| 100 | 20.0 µs | 4.00 µs | 5.00e6 |",
            "| 10000 | 50.0 µs | 500 µs | 2.00e8 |",
            "- `relax`, CPU, f64, one thread: the GPU gains from 10000 vertices on.",
            "| 10000 | relax | GPU, passes | 800 | 4.00 µs | 12.50 |",
            "| 10000 | 250 ms, 1234 | more than 60.0 s, - |",
            "![llvmpipe (Vulkan), a software adapter](gpu/some-relax.svg)",
        ] {
            assert!(text.lines().any(|written| written == line), "{line}\n{text}");
        }
        assert!(!text.contains("`speed`"), "what is whole is not told of");
    }

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
