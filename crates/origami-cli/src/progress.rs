//! Progress on standard error, where that is a terminal.

use std::io::{self, IsTerminal};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::numbers::{grouped, short};

/// Parts that one bar is divided into.
const PARTS: u64 = 1000;

/// A line that shows how far the work has come.
pub(crate) struct ProgressLine {
    bar: ProgressBar,
}

impl ProgressLine {
    /// For `files` inputs; hidden if `quiet` or where no terminal shows it.
    pub(crate) fn new(files: usize, quiet: bool) -> Self {
        match files {
            1 => Self::of(PARTS, "{bar:30} {msg} ({elapsed})", quiet),
            _ => Self::of(files as u64, "{bar:30} {pos} of {len} files ({elapsed})", quiet),
        }
    }

    /// For `count` sheets of one pattern.
    pub(crate) fn of_sheets(count: usize, quiet: bool) -> Self {
        Self::of(PARTS * count as u64, "{bar:30} {percent} % ({elapsed}, about {eta} to go)", quiet)
    }

    /// For the runs of a study.
    #[cfg(feature = "study")]
    pub(crate) fn of_runs(quiet: bool) -> Self {
        Self::of(0, "{bar:30} {pos} of {len} ({elapsed}, about {eta} to go) {wide_msg}", quiet)
    }

    fn of(length: u64, template: &str, quiet: bool) -> Self {
        let hidden = quiet || !io::stderr().is_terminal();
        let target = if hidden { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = ProgressBar::with_draw_target(Some(length), target).with_style(style);
        if !hidden {
            bar.enable_steady_tick(Duration::from_millis(200));
        }
        Self { bar }
    }

    /// Within one file: stage `stage` of `stages` and what its solver tells.
    pub(crate) fn show(&self, stage: usize, stages: usize, solver: origami::solve::Progress) {
        if self.bar.is_hidden() {
            return;
        }
        let share = (stage as f64 + solver.ramp) / stages.max(1) as f64;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of 1000")]
        self.bar.set_position((share * PARTS as f64) as u64);
        let stage = if stages > 1 { format!("stage {} of {stages}, ", stage + 1) } else { String::new() };
        let distance = if solver.distance.is_finite() {
            format!(", {} of the radius to go", short(solver.distance))
        } else {
            String::new()
        };
        self.bar.set_message(format!("{stage}step {}{distance}", grouped(solver.step)));
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
