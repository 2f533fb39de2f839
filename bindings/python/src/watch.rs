//! What a fold looks for while it goes on: Ctrl-C, and whoever wants to know how far it has come.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use origami::solve::Progress;
use pyo3::prelude::*;

/// Python is asked so often: a person does not wait for less, and the fold is not slowed by more.
const EVERY: Duration = Duration::from_millis(50);

/// Watches a fold.
pub(crate) struct Watch {
    /// Called with the step, the share of the way to the targets, and the distance from the equilibrium.
    progress: Option<Py<PyAny>>,
    stop: Option<Arc<AtomicBool>>,
    asked: Instant,
    raised: Option<PyErr>,
}

impl Watch {
    pub(crate) fn new(progress: Option<Py<PyAny>>) -> Self {
        Self { progress, stop: None, asked: Instant::now(), raised: None }
    }

    /// One that ends the fold as soon as `stop` is set.
    pub(crate) fn until(stop: Option<Arc<AtomicBool>>) -> Self {
        Self { stop, ..Self::new(None) }
    }

    /// What a solver tells; breaks where it is to stop.
    pub(crate) fn observe(&mut self, progress: Progress) -> ControlFlow<()> {
        self.ask(|py, watcher| {
            let Progress { step, ramp, distance } = progress;
            watcher.call1(py, (step, ramp, distance)).map(|_| ())
        })
    }

    /// What the follower of a path tells: the number of a point, and its load factor.
    #[cfg(feature = "analysis")]
    pub(crate) fn point(&mut self, number: u64, load_factor: f64) -> ControlFlow<()> {
        self.ask(|py, watcher| watcher.call1(py, (number, load_factor)).map(|_| ()))
    }

    /// The same where there is nothing to be told.
    pub(crate) fn ask_python(&mut self) -> ControlFlow<()> {
        self.ask(|_, _| Ok(()))
    }

    fn ask(&mut self, tell: impl FnOnce(Python<'_>, &Py<PyAny>) -> PyResult<()>) -> ControlFlow<()> {
        if self.is_stopped() {
            return ControlFlow::Break(());
        }
        if self.asked.elapsed() < EVERY {
            return ControlFlow::Continue(());
        }
        let asked = Python::attach(|py| {
            py.check_signals()?;
            self.progress.as_ref().map_or(Ok(()), |watcher| tell(py, watcher))
        });
        self.asked = Instant::now();
        self.raised = asked.err();
        if self.raised.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Whether it was told to stop, or Python was.
    pub(crate) fn is_stopped(&self) -> bool {
        self.raised.is_some() || self.stop.as_ref().is_some_and(|stop| stop.load(Ordering::Relaxed))
    }

    /// Raises what was raised meanwhile.
    pub(crate) fn finish(self) -> PyResult<()> {
        self.raised.map_or(Ok(()), Err)
    }
}
