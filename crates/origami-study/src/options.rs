//! What a study is asked for.

use std::time::{Duration, Instant};

use origami_core::CreasePattern;

use crate::GpuChoice;

/// What to study, and how long.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Patterns of the user's, by name, in place of the shipped cases.
    pub patterns: Vec<(String, CreasePattern)>,
    /// A part of the cases and of their parameters, for a look in less than a minute.
    pub quick: bool,
    /// No run is begun after this; those left out are named. Default: none.
    pub time_limit: Option<Duration>,
    /// The adapter on which runs are repeated. Default: none, the processor alone.
    pub gpu: GpuChoice,
}

/// Follows a study; every method is called by one thread at a time.
pub trait Watch {
    /// So many runs are to come.
    fn begins(&mut self, runs: usize);
    /// One is done, or was left out; what it was, for people.
    fn ran(&mut self, what: &str);
}

/// For studies that nobody watches.
impl Watch for () {
    fn begins(&mut self, _: usize) {}
    fn ran(&mut self, _: &str) {}
}

/// When a study shall begin no more runs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Deadline(Option<Instant>);

impl Deadline {
    pub(crate) fn after(limit: Option<Duration>) -> Self {
        // A limit past what a clock can show is none.
        Self(limit.and_then(|limit| Instant::now().checked_add(limit)))
    }

    pub(crate) fn passed(self) -> bool {
        self.0.is_some_and(|end| Instant::now() >= end)
    }
}
