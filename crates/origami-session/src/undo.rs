//! What can be gone back to.

use std::collections::VecDeque;

use origami_core::solve::State;

use crate::message::Wishes;

/// Marks that are kept, and bytes that all of them may have.
const MOST: usize = 100;
const MOST_BYTES: usize = 64 << 20;

/// A sheet at some time: what was asked of it, and where it was.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mark {
    pub(crate) wishes: Wishes,
    pub(crate) state: State,
}

impl Mark {
    fn bytes(&self) -> usize {
        48 * self.state.positions.len() + 16 * self.state.fold_angles.len()
    }
}

/// Marks behind and ahead.
#[derive(Debug, Default)]
pub(crate) struct Undo {
    behind: VecDeque<Mark>,
    ahead: Vec<Mark>,
}

impl Undo {
    /// Remembers a mark; what was ahead is forgotten.
    pub(crate) fn mark(&mut self, mark: Mark) {
        self.ahead.clear();
        self.remember(mark);
    }

    /// Goes back from `now`.
    pub(crate) fn back(&mut self, now: Mark) -> Option<Mark> {
        let mark = self.behind.pop_back()?;
        self.ahead.push(now);
        Some(mark)
    }

    /// Goes forward from `now`.
    pub(crate) fn forward(&mut self, now: Mark) -> Option<Mark> {
        let mark = self.ahead.pop()?;
        self.remember(now);
        Some(mark)
    }

    /// Whether there is something behind, and ahead.
    pub(crate) fn can(&self) -> (bool, bool) {
        (!self.behind.is_empty(), !self.ahead.is_empty())
    }

    fn remember(&mut self, mark: Mark) {
        self.behind.push_back(mark);
        while self.behind.len() > 1
            && (self.behind.len() > MOST || self.behind.iter().map(Mark::bytes).sum::<usize>() > MOST_BYTES)
        {
            self.behind.pop_front();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use origami_core::glam::DVec3;

    fn mark(percent: f64, nodes: usize) -> Mark {
        let state = State { positions: vec![DVec3::ZERO; nodes], ..State::default() };
        Mark { wishes: Wishes { percent, ..Wishes::default() }, state }
    }

    #[test]
    fn back_and_forward_return_what_was_there() {
        let mut undo = Undo::default();
        undo.mark(mark(0.0, 1));
        undo.mark(mark(1.0, 1));
        assert_eq!(undo.back(mark(2.0, 1)), Some(mark(1.0, 1)));
        assert_eq!(undo.back(mark(1.0, 1)), Some(mark(0.0, 1)));
        assert_eq!(undo.back(mark(0.0, 1)), None);
        assert_eq!(undo.forward(mark(0.0, 1)), Some(mark(1.0, 1)));
        assert_eq!(undo.can(), (true, true));
        undo.mark(mark(5.0, 1));
        assert_eq!(undo.forward(mark(6.0, 1)), None);
    }

    #[test]
    fn marks_have_bounds() {
        let mut undo = Undo::default();
        (0..300).for_each(|i| undo.mark(mark(f64::from(i), 1)));
        assert_eq!(undo.behind.len(), MOST);
        (0..10).for_each(|i| undo.mark(mark(f64::from(i), 1 << 19)));
        assert!(undo.behind.len() < 4, "{}", undo.behind.len());
    }
}
