//! Progress on standard error, where that is a terminal.

use std::io::{self, IsTerminal};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::numbers::{grouped, short};

/// Parts that one bar is divided into.
const PARTS: u64 = 1000;

/// Columns below which a line has no room for a bar.
const NARROW: u16 = 64;

/// A line that shows how far the work has come.
pub(crate) struct ProgressLine {
    bar: ProgressBar,
}

/// How much there is to do.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Way {
    /// States to settle.
    pub(crate) stages: usize,
    /// Steps of each, where their number is given.
    pub(crate) steps: Option<u64>,
}

impl Way {
    /// The share that is done of it, in this stage.
    fn share(self, stage: usize, solver: origami::solve::Progress) -> f64 {
        let of_stage = match self.steps {
            Some(steps) => solver.step as f64 / steps.max(1) as f64,
            None => solver.ramp,
        };
        (stage as f64 + of_stage.min(1.0)) / self.stages.max(1) as f64
    }
}

impl ProgressLine {
    /// For `files` inputs; hidden if `quiet` or where no terminal shows it.
    pub(crate) fn new(files: usize, quiet: bool) -> Self {
        match files {
            1 => Self::of(PARTS, "{bar:30} {wide_msg} {elapsed:>5}", "{percent:>3} % {wide_msg}", quiet),
            _ => Self::of(files as u64, "{bar:30} {pos} of {len} files ({elapsed})", "{pos} of {len} files", quiet),
        }
    }

    /// For `count` sheets of one pattern.
    pub(crate) fn of_sheets(count: usize, quiet: bool) -> Self {
        let full = "{bar:30} {percent} % ({elapsed}, about {eta} to go)";
        Self::of(PARTS * count as u64, full, "{percent} %, {eta} to go", quiet)
    }

    /// For the runs of a study.
    #[cfg(feature = "study")]
    pub(crate) fn of_runs(quiet: bool) -> Self {
        Self::of(0, "{bar:30} {pos} of {len} ({elapsed}, about {eta} to go) {wide_msg}", "{pos} of {len}", quiet)
    }

    /// A line as `full` says, or as `narrow` does where that would not fit.
    fn of(length: u64, full: &str, narrow: &str, quiet: bool) -> Self {
        let hidden = quiet || !io::stderr().is_terminal();
        let width = terminal_size::terminal_size_of(io::stderr()).map(|(width, _)| width.0);
        let template = if width.is_some_and(|width| width < NARROW) { narrow } else { full };
        let target = if hidden { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = ProgressBar::with_draw_target(Some(length), target).with_style(style);
        if !hidden {
            bar.enable_steady_tick(Duration::from_millis(200));
        }
        Self { bar }
    }

    /// Within one file: stage `stage` of its way and what its solver tells.
    pub(crate) fn show(&self, stage: usize, way: Way, solver: origami::solve::Progress) {
        if self.bar.is_hidden() {
            return;
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of 1000")]
        self.bar.set_position((way.share(stage, solver) * PARTS as f64) as u64);
        self.bar.set_message(said(stage, way, solver));
    }

    /// All sheets together have come so far; each is 1 when it is folded.
    pub(crate) fn show_sheets(&self, sum: f64) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a million sheets at most")]
        self.bar.set_position((sum * PARTS as f64) as u64);
    }

    /// So many more runs are to come.
    #[cfg(feature = "study")]
    pub(crate) fn runs_to_come(&self, runs: usize) {
        self.bar.inc_length(runs as u64);
    }

    /// One is done.
    #[cfg(feature = "study")]
    pub(crate) fn run_done(&self, what: &str) {
        self.bar.set_message(what.to_owned());
        self.bar.inc(1);
    }

    /// Within one film: so many pictures of `of` are drawn.
    pub(crate) fn show_pictures(&self, drawn: usize, of: usize) {
        if self.bar.is_hidden() {
            return;
        }
        self.bar.set_position(PARTS * drawn as u64 / of.max(1) as u64);
        self.bar.set_message(format!("picture {drawn} of {of}"));
    }

    /// One more file is done.
    pub(crate) fn file_done(&self) {
        self.bar.inc(1);
    }

    /// Writes something else without tearing the line.
    pub(crate) fn aside(&self, write: impl FnOnce()) {
        self.bar.suspend(write);
    }

    /// Takes the line away.
    pub(crate) fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// Such as `stage 2 of 5, step 1 240, 0.0031 of the radius to go`.
fn said(stage: usize, way: Way, solver: origami::solve::Progress) -> String {
    let mut text = String::new();
    if way.stages > 1 {
        text += &format!("stage {} of {}, ", stage + 1, way.stages);
    }
    text += &format!("step {}", grouped(solver.step));
    match way.steps {
        Some(steps) => text += &format!(" of {}", grouped(steps)),
        None if solver.distance.is_finite() => text += &format!(", {} of the radius to go", short(solver.distance)),
        None => {}
    }
    text
}

#[cfg(test)]
mod tests {
    use origami::solve::Progress;

    use super::*;

    #[test]
    fn where_steps_are_counted_they_are_what_is_shown() {
        let solver = Progress { step: 265_750, ramp: 1.0, distance: 2e-15 };
        let counted = Way { stages: 1, steps: Some(3_000_000) };
        assert_eq!(said(0, counted, solver), "step 265 750 of 3 000 000");
        assert!((counted.share(0, solver) - 265_750.0 / 3e6).abs() < 1e-12);
        assert_eq!(Way { stages: 2, steps: Some(10) }.share(1, solver), 1.0, "never more than all");

        let settling = Way { stages: 4, steps: None };
        assert_eq!(said(1, settling, solver), "stage 2 of 4, step 265 750, 2.0e-15 of the radius to go");
        assert_eq!(settling.share(1, Progress { ramp: 0.5, ..solver }), 0.375);
    }
}
