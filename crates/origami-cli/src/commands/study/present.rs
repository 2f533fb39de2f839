//! A build with the feature `study`.

use std::path::{Path, PathBuf};
use std::time::Duration;

use origami::study::{Options, StudyError, Watch, accuracy, backwards, contact, flat, stability};

use super::{folder, patterns};
use crate::args::{BackendName, StudyArgs, StudyBackend, StudyName, is_named};
use crate::backend::Backend;
use crate::console;
use crate::exit::{Exit, Failure};
use crate::files::Reading;
use crate::numbers::{count, duration};
use crate::progress::ProgressLine;
use crate::stopwatch::Stopwatch;

/// Runs one and writes what comes of it.
pub(in crate::commands) fn run(args: &StudyArgs) -> Result<Exit, Failure> {
    if args.study == StudyName::Stability
        && let Some(pattern) = args.patterns.first()
    {
        return Err(format!("{}: stability has scenes of its own; expected no pattern", pattern.display()).into());
    }
    folder::check(&args.output)?;
    let patterns = patterns::read(&args.patterns, &Reading::new(&args.reading)?, args.quiet)?;
    let gpu = match args.backend {
        StudyBackend::Cpu => BackendName::Cpu,
        StudyBackend::Gpu => BackendName::Gpu,
    };
    let gpu = Backend::new(gpu, args.adapter.as_deref())?.studied();
    let document = match args.study {
        StudyName::Accuracy => "accuracy.md",
        StudyName::Stability => "stability.md",
        StudyName::Flat => "flat.md",
        StudyName::Contact => "contact.md",
        StudyName::Backwards => "backwards.md",
    };
    folder::make(&args.output, document)?;
    if !args.quiet && is_named(args.adapter.as_deref()) && args.backend == StudyBackend::Cpu {
        console::warning("--adapter has no effect with --backend cpu");
    }

    let mut watch = Stopwatch::start();
    let options = Options { patterns, quick: args.quick, time_limit: args.time_limit(), gpu };
    let mut follower = Follower { line: ProgressLine::of_runs(args.quiet), runs: 0 };
    let done = match args.study {
        StudyName::Accuracy => accuracy::study(&options, &mut follower),
        StudyName::Stability => stability::study(&options, &mut follower),
        StudyName::Flat => flat::study(&options, &mut follower),
        StudyName::Contact => contact::study(&options, &mut follower),
        StudyName::Backwards => backwards::study(&options, &mut follower),
    };
    follower.line.finish();
    let paths = done.and_then(|study| study.write(&args.output)).map_err(failure)?;
    if !args.quiet {
        let seconds = Duration::from_secs_f64(watch.lap());
        console::print_text(&format!("{}\n", summary(&args.output, &paths, follower.runs, seconds)))?;
    }
    Ok(Exit::Done)
}

/// Such as `out/accuracy.md and 12 files beside it: 340 runs, 45.2 s`.
fn summary(folder: &Path, paths: &[PathBuf], runs: usize, seconds: Duration) -> String {
    // The document comes last.
    let document = paths.last().map_or(folder, PathBuf::as_path).display();
    let beside = count(paths.len().saturating_sub(1), "file", "files");
    format!("{document} and {beside} beside it: {}, {}", count(runs, "run", "runs"), duration(seconds))
}

fn failure(error: StudyError) -> Failure {
    match error {
        StudyError::Core(error) => error.into(),
        other => other.to_string().into(),
    }
}

/// Shows how far a study has come.
struct Follower {
    line: ProgressLine,
    runs: usize,
}

impl Watch for Follower {
    fn begins(&mut self, runs: usize) {
        self.line.runs_to_come(runs);
    }

    fn ran(&mut self, what: &str) {
        self.runs += 1;
        self.line.run_done(what);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_names_the_document() {
        let paths = ["out/a.csv", "out/accuracy.md"].map(PathBuf::from);
        let line = summary(Path::new("out"), &paths, 1234, Duration::from_millis(2500));
        assert_eq!(line, "out/accuracy.md and 1 file beside it: 1 234 runs, 2.5 s");
    }
}
