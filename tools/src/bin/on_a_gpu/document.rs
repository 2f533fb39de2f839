//! The part of BENCHMARKS.md that tells of runs.

use std::error::Error;
use std::fmt::Write;
use std::path::Path;

use crate::kept::Run;
use crate::{figures, run, tables};

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
    tables::write(run, &mut text)?;
    plots.iter().try_for_each(|plot| writeln!(text, "\n![{}]({plot})", run.adapter()))?;
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::results::Row;

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
            row("contact", 9, "GPU", "seconds until it is at rest", 0.5),
            row("contact", 9, "GPU", "evaluations", 561.0),
            row("contact", 9, "GPU", "crossings", 0.0),
            row("contact", 9, "GPU", "most pairs", 123.0),
            row("contact", 9, "GPU", "blocked", 1.0),
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
            "| miura | 9 | 500 ms, 561, 0, blocked | 123 | - |",
            "![llvmpipe (Vulkan), a software adapter](gpu/some-relax.svg)",
        ] {
            assert!(text.lines().any(|written| written == line), "{line}\n{text}");
        }
        assert!(!text.contains("`speed`"), "what is whole is not told of");
    }
}
