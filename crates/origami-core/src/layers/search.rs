//! An order of layers that obeys all conditions, by trying.

use glam::DVec2;

use super::order::{Literal, Order};
use super::overlap::{clipped, overlap, width};
use super::pairs::Pairs;

/// What three triangles have in common is rounding if it is narrower than this (in radii, area over perimeter).
const NARROW: f64 = 1e-3;
/// Answers that may be taken back before the search is given up.
const MOST: usize = 100_000;

/// Why there is no order of layers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NoOrder {
    /// The conditions contradict each other: the pattern cannot lie flat.
    Contradiction,
    /// None was found in the time that it may take.
    GivenUp,
}

/// An answer that was tried.
struct Tried {
    pair: usize,
    /// Answers before it.
    before: usize,
    /// Whether it is the second of the two.
    turned: bool,
}

impl Order<'_> {
    /// Answers every pair so that all conditions hold, and above what is above is above where three layers have a place in common;
    /// `seen` has the corners of all triangles in the plane.
    ///
    /// What follows from an answer is drawn before the next is tried, and pairs that no condition links are tried apart.
    ///
    /// # Errors
    /// [`NoOrder`] where there is none, or none is found.
    pub fn search(&mut self, seen: &[[DVec2; 3]]) -> Result<(), NoOrder> {
        let thirds = thirds(self.pairs(), seen);
        let (pairs, part) = self.parts(&thirds);
        self.begin(thirds)?;
        let mut place = vec![0; pairs.len()];
        pairs.iter().enumerate().for_each(|(i, pair)| place[*pair] = i);
        let (mut tried, mut at, mut left): (Vec<Tried>, usize, usize) = (Vec::new(), 0, MOST);
        while let Some(&pair) = pairs.get(at) {
            at += 1;
            if self.is_answered(pair) {
                continue;
            }
            tried.push(Tried { pair, before: self.answered(), turned: false });
            self.answer(pair, true);
            while self.take_contradiction() {
                left = left.checked_sub(1).ok_or(NoOrder::GivenUp)?;
                let last = tried.pop().filter(|last| part[last.pair] == part[pair]).ok_or(NoOrder::Contradiction)?;
                self.take_back(last.before);
                at = at.min(place[last.pair]);
                if last.turned {
                    // Neither answer: the one before it is to blame.
                    self.contradict();
                } else {
                    tried.push(Tried { turned: true, ..last });
                    self.answer(last.pair, false);
                }
            }
        }
        Ok(())
    }

    /// Answers the pairs whose order follows from the conditions alone; `seen` as for [`Order::search`].
    ///
    /// # Errors
    /// [`NoOrder::Contradiction`] where there is none.
    pub(super) fn force(&mut self, seen: &[[DVec2; 3]]) -> Result<(), NoOrder> {
        self.begin(thirds(self.pairs(), seen))
    }

    fn begin(&mut self, thirds: Vec<Vec<u32>>) -> Result<(), NoOrder> {
        self.limit_to(thirds);
        self.follow();
        if self.take_contradiction() { Err(NoOrder::Contradiction) } else { Ok(()) }
    }

    fn answer(&mut self, pair: usize, above: bool) {
        self.demand(Literal { pair, turned: false }, above);
        self.follow();
    }

    /// All pairs, those that conditions link one after the other; and the part that each belongs to.
    fn parts(&self, thirds: &[Vec<u32>]) -> (Vec<usize>, Vec<usize>) {
        let count = thirds.len();
        let (mut part, mut pairs) = (vec![usize::MAX; count], Vec::with_capacity(count));
        for seed in 0..count {
            if part[seed] != usize::MAX {
                continue;
            }
            part[seed] = seed;
            let mut next = pairs.len();
            pairs.push(seed);
            while let Some(&pair) = pairs.get(next) {
                next += 1;
                let triangles = self.pairs().triangles[pair];
                let beside = |third: &u32| triangles.map(|t| self.pairs().between(t, *third).map(|(pair, _)| pair));
                let linked = self.linked(pair).chain(thirds[pair].iter().flat_map(beside).flatten());
                for other in linked.collect::<Vec<_>>() {
                    if part[other] == usize::MAX {
                        part[other] = seed;
                        pairs.push(other);
                    }
                }
            }
        }
        (pairs, part)
    }
}

/// By pair: the triangles that have a place in common with both of its own.
fn thirds(pairs: &Pairs, seen: &[[DVec2; 3]]) -> Vec<Vec<u32>> {
    let of_pair = |[i, j]: &[u32; 2]| {
        let common = overlap(&seen[*i as usize], &seen[*j as usize]);
        let meets = |third: &u32| {
            *third != *j
                && pairs.between(*j, *third).is_some()
                && width(&clipped(common.clone(), &seen[*third as usize])) > NARROW
        };
        pairs.of(*i as usize).iter().map(|(third, _)| *third).filter(meets).collect()
    };
    pairs.triangles.iter().map(of_pair).collect()
}
