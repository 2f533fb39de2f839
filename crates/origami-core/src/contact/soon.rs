//! The pairs of a long list that may come near soon, close together in memory: the others are not looked at meanwhile.

use super::pairs::Pair;
use crate::ids::NodeId;

/// A pair in few bytes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Brief {
    pub(super) nodes: [NodeId; 4],
    pub(super) eased: f64,
    /// Its place in the list.
    pub(super) number: u32,
    /// Which of [`Soon::widths`] is its.
    pub(super) width: u32,
}

/// Pairs that are due before some bound, in the order of their list.
#[derive(Clone, Debug)]
pub(super) struct Soon {
    pub(super) pairs: Vec<Brief>,
    /// How many of them are of points; these come first.
    pub(super) points: usize,
    /// By pair: as [`super::layers::Layers`] has it of the list, but later.
    pub(super) due: Vec<f64>,
    /// Widths, and the distances that are closed. Most pairs have the same.
    pub(super) widths: Vec<[f64; 2]>,
    /// The bound.
    until: f64,
}

impl Soon {
    /// Nothing is known of any list.
    pub(super) fn new() -> Self {
        Self { pairs: Vec::new(), points: 0, due: Vec::new(), widths: Vec::new(), until: f64::NEG_INFINITY }
    }

    /// The list is another one.
    pub(super) fn forget(&mut self) {
        self.pairs.clear();
        self.due.clear();
        self.widths.clear();
        self.points = 0;
        self.until = f64::NEG_INFINITY;
    }

    /// Sees to it that all pairs are here that are due before `bound`, and those that are so much later.
    pub(super) fn look_ahead(&mut self, bound: f64, later: f64, (pairs, due): (&[Pair], &mut [f64])) {
        if bound <= self.until {
            return;
        }
        for (pair, own) in self.pairs.iter().zip(&self.due) {
            due[pair.number as usize] = *own;
        }
        self.forget();
        self.until = bound + later;
        let mut width = 0;
        for ((number, pair), due) in (0..).zip(pairs).zip(due) {
            if *due < self.until {
                let own = [pair.width, pair.closed];
                if self.widths.last() != Some(&own) {
                    width = u32::try_from(self.widths.len()).unwrap_or(u32::MAX);
                    self.widths.push(own);
                }
                self.points += usize::from(pair.split == 1);
                self.pairs.push(Brief { nodes: pair.nodes, eased: pair.eased, number, width });
                self.due.push(*due);
            }
        }
    }
}
