//! The tables of BENCHMARKS.md from what criterion left behind:
//! `cargo run --release -p origami-tools --bin tables -- target/criterion`
//!
//! Means, in nanoseconds per vertex and step, or per vertex.

#![expect(clippy::print_stdout, reason = "tables are what it is for")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use serde_json::Value;

/// Nanoseconds per element, by group, function and number of vertices.
type Means = BTreeMap<(String, String), BTreeMap<u64, f64>>;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).ok_or("the folder of criterion's results is missing")?;
    let mut means = Means::new();
    collect(Path::new(&folder), &mut means)?;
    steps(&means);
    threads(&means);
    parts(&means, "build", &["pattern", "pattern_of_lines", "model"]);
    let groups: BTreeSet<&str> = means.keys().map(|(group, _)| group.as_str()).collect();
    for group in groups.into_iter().filter(|group| group.starts_with("files/")) {
        parts(&means, group, &["read", "pattern", "model", "write"]);
    }
    Ok(())
}

fn collect(folder: &Path, means: &mut Means) -> Result<(), Box<dyn std::error::Error>> {
    for entry in std::fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, means)?;
        }
    }
    if !folder.ends_with("new") {
        return Ok(());
    }
    let read = |name: &str| -> Result<Value, Box<dyn std::error::Error>> {
        Ok(serde_json::from_slice(&std::fs::read(folder.join(name))?)?)
    };
    let (benchmark, estimates) = (read("benchmark.json")?, read("estimates.json")?);
    let elements = benchmark["throughput"]["Elements"].as_f64();
    let size = benchmark["value_str"].as_str().and_then(|size| size.parse().ok());
    let mean = estimates["mean"]["point_estimate"].as_f64();
    if let (Some(elements), Some(size), Some(mean)) = (elements, size, mean) {
        let name = |key: &str| benchmark[key].as_str().unwrap_or_default().to_owned();
        means.entry((name("group_id"), name("function_id"))).or_default().insert(size, mean / elements);
    }
    Ok(())
}

fn of(means: &Means, group: &str, function: &str, size: u64) -> Option<f64> {
    means.get(&(group.to_owned(), function.to_owned()))?.get(&size).copied()
}

fn sizes(means: &Means, group: &str) -> Vec<u64> {
    let own = means.iter().filter(|((own, _), _)| own == group);
    let mut sizes: Vec<u64> = own.flat_map(|(_, sizes)| sizes.keys().copied()).collect();
    sizes.sort_unstable();
    sizes.dedup();
    sizes
}

fn cell(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(|| "-".into(), |value| format!("{value:.digits$}"))
}

fn row(cells: &[String]) {
    println!("| {} |", cells.join(" | "));
}

fn head(title: &str, cells: &[&str]) {
    println!("\n{title}\n\n| {} |\n|{}", cells.join(" | "), "---|".repeat(cells.len()));
}

fn steps(means: &Means) {
    let columns = ["vertices", "printed", "plain", "`dynamics` f64", "of printed", "of plain", "mixed", "of printed"];
    head("One step on one thread", &[&columns[..], &["of plain", "`relax` f64", "mixed"]].concat());
    for size in sizes(means, "cpu_step") {
        let of = |function| of(means, "cpu_step", function, size);
        let ratio = |slow, fast| Some(of(slow)? / of(fast)?);
        let mut cells = vec![size.to_string(), cell(of("printed"), 0), cell(of("plain"), 0)];
        for fast in ["dynamics/f64", "dynamics/mixed"] {
            cells.extend([cell(of(fast), 0), cell(ratio("printed", fast), 1), cell(ratio("plain", fast), 1)]);
        }
        cells.extend([cell(of("relax/f64"), 0), cell(of("relax/mixed"), 0)]);
        row(&cells);
    }
}

fn threads(means: &Means) {
    let shared: Vec<&str> = means.keys().filter(|(group, _)| group == "cpu_step").map(|(_, f)| f.as_str()).collect();
    head("Shared out among threads", &["what", "vertices", "one thread", "all", "gain"]);
    for function in shared.iter().filter(|function| function.ends_with(" threads")) {
        let Some((alone, _)) = function.rsplit_once('/') else { continue };
        for size in sizes(means, "cpu_step") {
            let of = |function| of(means, "cpu_step", function, size);
            let Some((one, all)) = of(alone).zip(of(function)) else { continue };
            row(&[
                function.to_string(),
                size.to_string(),
                cell(Some(one), 0),
                cell(Some(all), 0),
                cell(Some(one / all), 2),
            ]);
        }
    }
}

fn parts(means: &Means, group: &str, functions: &[&str]) {
    head(&format!("{group}, nanoseconds per vertex"), &[&["size"], functions].concat());
    for size in sizes(means, group) {
        let cells = functions.iter().map(|function| cell(of(means, group, function, size), 0));
        row(&std::iter::once(size.to_string()).chain(cells).collect::<Vec<_>>());
    }
}
