//! What is told of each input, in the order of the inputs, whatever the order in which they finish.

use std::collections::BTreeMap;
use std::io;
use std::sync::{Mutex, PoisonError};

use super::summary::Told;
use crate::console;
use crate::progress::ProgressLine;
use crate::text::plain;

/// Holds back what came too early.
pub(super) struct Queue<'a> {
    line: &'a ProgressLine,
    quiet: bool,
    /// Whether warnings need the name of their input.
    many: bool,
    /// Whether the summary has to go to standard error.
    stdout_taken: bool,
    inner: Mutex<Inner>,
}

struct Inner {
    next: usize,
    waiting: BTreeMap<usize, Told>,
    result: io::Result<()>,
}

impl<'a> Queue<'a> {
    pub(super) fn new(line: &'a ProgressLine, quiet: bool, many: bool, stdout_taken: bool) -> Self {
        let inner = Inner { next: 0, waiting: BTreeMap::new(), result: Ok(()) };
        Self { line, quiet, many, stdout_taken, inner: Mutex::new(inner) }
    }

    /// Input `index` is done.
    pub(super) fn push(&self, index: usize, told: Told) {
        let mut guard = self.inner.lock().unwrap_or_else(PoisonError::into_inner);
        let inner = &mut *guard;
        inner.waiting.insert(index, told);
        while let Some(told) = inner.waiting.remove(&inner.next) {
            inner.next += 1;
            self.line.aside(|| {
                if let Err(error) = self.tell(&told)
                    && inner.result.is_ok()
                {
                    inner.result = Err(error);
                }
            });
        }
    }

    /// What came of writing to standard output.
    pub(super) fn result(self) -> io::Result<()> {
        self.inner.into_inner().unwrap_or_else(PoisonError::into_inner).result
    }

    fn tell(&self, told: &Told) -> io::Result<()> {
        if !self.quiet {
            for warning in &told.warnings {
                if self.many {
                    console::warning(format_args!("{}: {warning}", told.input));
                } else {
                    console::warning(warning);
                }
            }
        }
        told.errors.iter().for_each(|error| console::error(error));
        match &told.summary {
            Some(summary) if !self.quiet && self.stdout_taken => console::say(summary),
            Some(summary) if !self.quiet => console::print_text(&format!("{}\n", plain(summary)))?,
            _ => {}
        }
        Ok(())
    }
}
