//! The parallelism of a build without the feature `parallel`: one thread, which needs no clock.

/// How the passes of one sheet are shared out: not at all.
#[derive(Clone, Debug)]
pub(super) struct Parallelism;

impl Parallelism {
    pub(super) fn new(_threads: usize) -> Self {
        Self
    }

    /// In one task.
    pub(super) fn tasks(&self) -> usize {
        1
    }

    /// Before each step.
    pub(super) fn step(&mut self) {}
}
