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

/// Where groups have taken more than one of so many pairs, those are left out.
const TAKEN: usize = 4;

/// Pairs of one kind, and when each is due: as [`super::layers::Layers`] has it of the list, but later. What a group has taken is
/// never due.
#[derive(Clone, Debug, Default)]
pub(super) struct Kind {
    pub(super) pairs: Vec<Brief>,
    pub(super) due: Vec<f64>,
}

impl Kind {
    pub(super) fn push(&mut self, pair: Brief, due: f64) {
        self.pairs.push(pair);
        self.due.push(due);
    }

    pub(super) fn append(&mut self, other: &mut Self) {
        self.pairs.append(&mut other.pairs);
        self.due.append(&mut other.due);
    }

    pub(super) fn clear(&mut self) {
        self.pairs.clear();
        self.due.clear();
    }
}

/// Pairs that are due before some bound.
#[derive(Clone, Debug)]
pub(super) struct Soon {
    /// Those of points, and those of edges; in the order of their list, and then those that groups have given back.
    pub(super) kinds: [Kind; 2],
    /// Widths, and the distances that are closed. Most pairs have the first.
    pub(super) widths: Vec<[f64; 2]>,
    /// The bound.
    until: f64,
    /// How many of them groups have taken.
    taken: usize,
}

impl Soon {
    /// Nothing is known of any list; most of its pairs have this width and are closed at no distance.
    pub(super) fn new(width: f64) -> Self {
        Self { kinds: Default::default(), widths: vec![[width, 0.0]], until: f64::NEG_INFINITY, taken: 0 }
    }

    /// The list is another one.
    pub(super) fn forget(&mut self) {
        self.kinds.iter_mut().for_each(Kind::clear);
        self.widths.truncate(1);
        self.until = f64::NEG_INFINITY;
        self.taken = 0;
    }

    /// How many pairs there are.
    pub(super) fn len(&self) -> usize {
        self.kinds.iter().map(|kind| kind.pairs.len()).sum()
    }

    /// All pairs, and when each is due.
    pub(super) fn iter_mut(&mut self) -> impl Iterator<Item = (&Brief, &mut f64)> {
        self.kinds.iter_mut().flat_map(|kind| kind.pairs.iter().zip(&mut kind.due))
    }

    /// Whether any pair is due before `bound`.
    pub(super) fn is_due(&self, bound: f64) -> bool {
        self.kinds.iter().any(|kind| kind.due.iter().any(|due| *due < bound))
    }

    /// Tells the list when its pairs are due.
    pub(super) fn tell(&self, due: &mut [f64]) {
        for kind in &self.kinds {
            for (pair, own) in kind.pairs.iter().zip(&kind.due) {
                due[pair.number as usize] = *own;
            }
        }
    }

    /// Takes note that groups have taken so many more: where they are many, they are left out the next time.
    pub(super) fn note_taken(&mut self, count: usize) {
        self.taken += count;
        if TAKEN * self.taken > self.len() {
            self.until = f64::NEG_INFINITY;
        }
    }

    /// Sees to it that all pairs are here that are due before `bound`, and those that are so much later.
    pub(super) fn look_ahead(&mut self, bound: f64, later: f64, (pairs, due): (&[Pair], &mut [f64])) {
        if bound <= self.until {
            return;
        }
        self.tell(due);
        self.forget();
        self.until = bound + later;
        let mut width = 0;
        for ((number, pair), due) in (0..).zip(pairs).zip(due) {
            if *due < self.until {
                let own = [pair.width, pair.closed];
                if self.widths[0] == own {
                    width = 0;
                } else if self.widths[width as usize] != own {
                    width = u32::try_from(self.widths.len()).unwrap_or(u32::MAX);
                    self.widths.push(own);
                }
                let brief = Brief { nodes: pair.nodes, eased: pair.eased, number, width };
                self.kinds[usize::from(pair.split == 2)].push(brief, *due);
            }
        }
    }
}
