//! The team of a build without the feature `parallel`: one thread, which needs no clock.

/// How the passes of one sheet are shared out: not at all.
#[derive(Clone, Debug)]
pub(super) struct Team;

impl Team {
    pub(super) fn new(_threads: usize) -> Self {
        Self
    }

    /// In one part.
    pub(super) fn parts(&self) -> usize {
        1
    }

    /// Before each step.
    pub(super) fn step(&mut self) {}
}
