//! An order of layers that obeys all conditions, by trying.

use glam::DVec2;

use super::order::{Literal, Order};
use super::overlap::{clipped, overlap, width};
use super::pairs::Pairs;

/// What three triangles have in common is rounding if it is narrower than this (in radii, area over perimeter).
const NARROW: f64 = 1e-3;
/// Answers that may be taken back before the search is given up.
const MOST: usize = 100_000;
/// The same while one pair is asked for its other answer.
const FEW: usize = 1000;
/// Pairs that are looked at for all their other answers.
const MOST_LOOKS: usize = 10_000_000;

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
    /// `seen` has the corners of all triangles in the plane. By pair: whether it may be answered the other way too.
    ///
    /// What follows from an answer is drawn before the next is tried, and pairs that no condition links are tried apart.
    ///
    /// # Errors
    /// [`NoOrder`] where there is none, or none is found.
    pub fn search(&mut self, seen: &[[DVec2; 3]]) -> Result<Vec<bool>, NoOrder> {
        let thirds = thirds(self.pairs(), seen);
        let parts = self.parts(&thirds);
        self.begin(thirds)?;
        let demanded = self.answered();
        let mut left = MOST;
        for part in &parts {
            self.complete(part, None, &mut left)?;
        }
        Ok(self.free(&parts, demanded))
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

    /// Answers all pairs of a part, each as `wanted` if that can be, taking back no more than `left` of its own answers.
    fn complete(&mut self, part: &[usize], wanted: Option<&[bool]>, left: &mut usize) -> Result<(), NoOrder> {
        let (mut tried, mut at): (Vec<Tried>, usize) = (Vec::new(), 0);
        let first = |pair: usize| wanted.is_none_or(|wanted| wanted[pair]);
        while let Some(&pair) = part.get(at) {
            at += 1;
            if self.is_answered(pair) {
                continue;
            }
            tried.push(Tried { pair, before: self.answered(), turned: false });
            self.answer(pair, first(pair));
            while self.take_contradiction() {
                *left = left.checked_sub(1).ok_or(NoOrder::GivenUp)?;
                let last = tried.pop().ok_or(NoOrder::Contradiction)?;
                self.take_back(last.before);
                at = part.iter().take(at).position(|pair| *pair == last.pair).unwrap_or(at);
                if last.turned {
                    // Neither answer: the one before it is to blame.
                    self.contradict();
                } else {
                    tried.push(Tried { turned: true, ..last });
                    self.answer(last.pair, !first(last.pair));
                }
            }
        }
        Ok(())
    }

    /// By pair, of an order that is found: whether another order has it the other way round, or that was not ruled out in the
    /// time that it may take. The first so many answers were demanded.
    fn free(&mut self, parts: &[Vec<usize>], mut demanded: usize) -> Vec<bool> {
        let found: Vec<bool> = (0..self.pairs().triangles.len()).map(|pair| self.above(pair)).collect();
        let (mut free, mut left) = (vec![false; found.len()], MOST_LOOKS);
        self.take_back(demanded);
        for part in parts {
            for &pair in part {
                if self.is_answered(pair) || free[pair] {
                    continue;
                }
                let Some(rest) = left.checked_sub(part.len()) else {
                    free[pair] = true;
                    continue;
                };
                left = rest;
                self.answer(pair, !found[pair]);
                let other = match self.take_contradiction() {
                    true => Err(NoOrder::Contradiction),
                    false => self.complete(part, Some(&found), &mut { FEW }),
                };
                match other {
                    Ok(()) => part.iter().for_each(|other| free[*other] |= self.above(*other) != found[*other]),
                    Err(NoOrder::GivenUp) => free[pair] = true,
                    Err(NoOrder::Contradiction) => {
                        self.take_back(demanded);
                        self.answer(pair, found[pair]);
                        demanded = self.answered();
                    }
                }
                self.take_back(demanded);
            }
        }
        found.iter().enumerate().for_each(|(pair, above)| self.answer(pair, *above));
        free
    }

    /// The pairs that conditions link, directly or not: one part after the other.
    fn parts(&self, thirds: &[Vec<u32>]) -> Vec<Vec<usize>> {
        let (mut seen, mut parts) = (vec![false; thirds.len()], Vec::new());
        for seed in 0..thirds.len() {
            if std::mem::replace(&mut seen[seed], true) {
                continue;
            }
            let (mut part, mut next) = (vec![seed], 0);
            while let Some(&pair) = part.get(next) {
                next += 1;
                let triangles = self.pairs().triangles[pair];
                let beside = |third: &u32| triangles.map(|t| self.pairs().between(t, *third).map(|(pair, _)| pair));
                let linked = self.linked(pair).chain(thirds[pair].iter().flat_map(beside).flatten());
                part.extend(linked.filter(|other| !std::mem::replace(&mut seen[*other], true)));
            }
            parts.push(part);
        }
        parts
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
