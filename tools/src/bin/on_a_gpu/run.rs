//! A whole run: section after section, each in a process and a time of its own.

use std::error::Error;
use std::fs;
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus};
use std::time::{Duration, Instant, SystemTime};

use serde_json::{Value, json};

use crate::section::{ALL, CUT, TESTS};

/// The file that tells how a run went.
pub(crate) const FILE: &str = "run.json";

/// How long a section may go on with what it was at when its time was over. Then it is ended.
const GRACE: Duration = Duration::from_secs(10);

/// What a run is asked for.
pub(crate) struct Asked {
    /// Where everything is written.
    pub(crate) folder: PathBuf,
    /// The time of the whole run.
    pub(crate) seconds: f64,
    /// Whether it is enough that everything runs.
    pub(crate) rehearse: bool,
    /// Which state of the source the programs were built from.
    pub(crate) commit: String,
    /// Programs that hold tests.
    pub(crate) tests: Vec<PathBuf>,
    /// The command `origami`.
    pub(crate) command: Option<PathBuf>,
}

impl Default for Asked {
    fn default() -> Self {
        Self {
            folder: PathBuf::new(),
            seconds: 320.0,
            rehearse: false,
            commit: String::new(),
            tests: Vec::new(),
            command: None,
        }
    }
}

/// Runs everything; a section that fails is told of, and the others run.
///
/// # Errors
/// If nothing can be written, or one of the sections failed.
pub(crate) fn measure(asked: &Asked) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(&asked.folder)?;
    let (began, at) = (Instant::now(), SystemTime::now().duration_since(SystemTime::UNIX_EPOCH)?.as_secs());
    let mut sections: Vec<(&str, f64)> = ALL.iter().map(|section| (section.name, section.share)).collect();
    if !asked.tests.is_empty() || asked.command.is_some() {
        // After what is known to be right, before what is merely fast.
        sections.insert(5, TESTS);
    }
    let mut told = Vec::new();
    for (i, (name, share)) in sections.iter().enumerate() {
        let left = (asked.seconds - began.elapsed().as_secs_f64()).max(0.0);
        let seconds = left * share / sections[i..].iter().map(|(_, share)| share).sum::<f64>();
        let section = Instant::now();
        println!("== {name}, {seconds:.0} s");
        let ended =
            start(asked, name, seconds).and_then(|child| wait(child, seconds)).unwrap_or_else(|why| why.to_string());
        println!("== {name}: {ended}, after {:.1} s", section.elapsed().as_secs_f64());
        told.push(json!({ "section": name, "ended": ended, "seconds": section.elapsed().as_secs_f64() }));
        // Anew after each: whatever comes next, it is kept.
        let run = json!({ "commit": asked.commit, "rehearsal": asked.rehearse, "began": at, "sections": told });
        fs::write(asked.folder.join(FILE), serde_json::to_string_pretty(&run)? + "\n")?;
    }
    let failed: Vec<&str> =
        told.iter().filter(|section| !is_sound(section)).filter_map(|s| s["section"].as_str()).collect();
    println!("== {:.0} s in all: {}", began.elapsed().as_secs_f64(), asked.folder.display());
    if failed.is_empty() { Ok(()) } else { Err(format!("{}: failed; see above", failed.join(", ")).into()) }
}

/// Whether a section did what it could.
fn is_sound(section: &Value) -> bool {
    section["ended"] == WHOLE || section["ended"] == OUT_OF_TIME
}

/// How a section ended that did all it had to.
pub(crate) const WHOLE: &str = "whole";
/// And one that left something out.
pub(crate) const OUT_OF_TIME: &str = "out of time";

fn start(asked: &Asked, name: &str, seconds: f64) -> Result<Child, Box<dyn Error>> {
    let mut command = Command::new(std::env::current_exe()?);
    command.arg("section").arg(name).arg(&asked.folder).arg(seconds.to_string());
    if asked.rehearse {
        command.arg("--rehearse");
    }
    for tests in &asked.tests {
        command.arg("--tests").arg(tests);
    }
    if let Some(origami) = &asked.command {
        command.arg("--command").arg(origami);
    }
    Ok(command.spawn()?)
}

/// How a section ended, in words.
fn wait(mut child: Child, seconds: f64) -> Result<String, Box<dyn Error>> {
    let ended = ended_within(&mut child, Instant::now() + Duration::from_secs_f64(seconds) + GRACE)?;
    Ok(match ended {
        None => "hung, and was ended".to_owned(),
        Some(status) if status.success() => WHOLE.to_owned(),
        Some(status) if status.code() == Some(CUT) => OUT_OF_TIME.to_owned(),
        Some(status) => format!("failed, {status}"),
    })
}

/// How a program ended; `None` where it had to be ended at the deadline.
///
/// # Errors
/// If it cannot be waited for.
pub(crate) fn ended_within(child: &mut Child, deadline: Instant) -> Result<Option<ExitStatus>, Box<dyn Error>> {
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        if Instant::now() >= deadline {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        std::thread::sleep(Duration::from_millis(20));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn what_hangs_is_ended_and_what_fails_is_told() {
        let spawn = |script: &str| Command::new("sh").args(["-c", script]).spawn().expect("a shell");
        let soon = || Instant::now() + Duration::from_millis(200);
        assert!(ended_within(&mut spawn("exec sleep 60"), soon()).expect("waited for").is_none());
        assert_eq!(wait(spawn("exit 0"), 5.0).expect("waited for"), WHOLE);
        assert_eq!(wait(spawn(&format!("exit {CUT}")), 5.0).expect("waited for"), OUT_OF_TIME);
        let crashed = wait(spawn("kill -SEGV $$"), 5.0).expect("waited for");
        assert!(crashed.starts_with("failed, signal"), "{crashed}");
        assert!(is_sound(&json!({ "ended": WHOLE })) && !is_sound(&json!({ "ended": crashed })));
    }
}
