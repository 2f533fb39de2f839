//! Time from a FOLD file to the folded FOLD file, as whole processes, with the parts that their reports tell:
//! `cargo build --release && cargo run --release -p origami-tools --bin processes -- target/release/origami`
//!
//! Every pattern of `examples/patterns`, larger Miura sheets to 60 %, and sheets of 100 000 and a million vertices that are
//! read, built, moved by one step and written. Least of ten processes each, of three for the largest; memory is the most that
//! Linux counted.

#![expect(clippy::print_stdout, reason = "its table is what it is for")]

use std::error::Error;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

/// What a process took.
struct Run {
    seconds: f64,
    /// Bytes, where the system tells.
    memory: Option<u64>,
    report: Value,
}

fn main() -> Result<(), Box<dyn Error>> {
    let program = std::env::args().nth(1).ok_or("the name of the program is missing")?;
    let scratch = Path::new("target/processes");
    std::fs::create_dir_all(scratch)?;
    let mut cases = Vec::new();
    for entry in std::fs::read_dir("examples/patterns")? {
        let path = entry?.path().display().to_string();
        cases.push((path, vec![], 10));
    }
    cases.sort();
    for (panels, options, times) in [
        (30, ["--percent", "60"].as_slice(), 10),
        (30, &["--percent", "60", "--precision", "mixed"], 10),
        (315, &["--steps", "1"], 3),
        (999, &["--steps", "1"], 3),
    ] {
        let path = scratch.join(format!("miura-{panels}.fold")).display().to_string();
        let columns = [format!("columns={panels}"), format!("rows={panels}")];
        let made = Command::new(&program)
            .args(["pattern", "miura", "-o", &path, "--set", &columns[0], "--set", &columns[1]])
            .stderr(Stdio::null())
            .status()?;
        if !made.success() {
            return Err(format!("{program} did not write {path}").into());
        }
        cases.push((path, options.to_vec(), times));
    }

    println!("| pattern | vertices | read | build | solve | write | the whole process | memory |");
    println!("|---|---|---|---|---|---|---|---|");
    for (path, options, times) in cases {
        let mut runs = Vec::new();
        for _ in 0..times {
            runs.push(run(&program, &path, &options, scratch)?);
        }
        let least = runs.iter().min_by(|a, b| a.seconds.total_cmp(&b.seconds)).ok_or("no runs")?;
        let part = |name: &str| time(least.report["seconds"][name].as_f64().unwrap_or(f64::NAN));
        let name = Path::new(&path).file_stem().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let memory = runs.iter().filter_map(|run| run.memory).max();
        let memory = memory.map_or_else(|| "-".into(), |bytes| format!("{:.0} MB", bytes as f64 / 1e6));
        println!(
            "| {} | {} | {} | {} | {} | {} | {} | {memory} |",
            [&[name.as_str()], &options[..]].concat().join(" "),
            least.report["vertices"],
            part("read"),
            part("build"),
            part("solve"),
            part("write"),
            time(least.seconds),
        );
    }
    Ok(())
}

fn run(program: &str, path: &str, options: &[&str], scratch: &Path) -> Result<Run, Box<dyn Error>> {
    let (folded, report) = (scratch.join("folded.fold"), scratch.join("report.json"));
    let start = Instant::now();
    let mut child = Command::new(program)
        .args(["fold", path, "--backend", "cpu"])
        .args(options)
        .arg("-o")
        .arg(&folded)
        .arg("--report")
        .arg(&report)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()?;
    let mut memory = None;
    let status = loop {
        memory = most_memory(&child).max(memory);
        if let Some(status) = child.try_wait()? {
            break status;
        }
        std::thread::sleep(Duration::from_micros(200));
    };
    let seconds = start.elapsed().as_secs_f64();
    if !status.success() {
        return Err(format!("{program} fold {path} {}: {status}", options.join(" ")).into());
    }
    Ok(Run { seconds, memory, report: serde_json::from_slice(&std::fs::read(report)?)? })
}

/// The most memory that a process has had so far.
fn most_memory(child: &Child) -> Option<u64> {
    let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).ok()?;
    let kilobytes = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?.split_whitespace().next()?;
    Some(1024 * kilobytes.parse::<u64>().ok()?)
}

fn time(seconds: f64) -> String {
    if seconds < 1e-3 {
        format!("{:.0} µs", 1e6 * seconds)
    } else if seconds < 1.0 {
        format!("{:.1} ms", 1e3 * seconds)
    } else {
        format!("{seconds:.2} s")
    }
}
