//! Which of each pair is on top, by what folds demand and then by what positions suggest.

use super::pairs::Pairs;

/// A pair's answer as it stands, or turned around.
#[derive(Clone, Copy, Debug)]
pub struct Literal {
    pub pair: usize,
    pub turned: bool,
}

/// Answers by pair: whether its second triangle is above the first.
pub struct Order<'a> {
    pairs: &'a Pairs,
    answers: Vec<Option<bool>>,
    /// Conditions that an even number of these literals is false.
    conditions: Vec<Vec<Literal>>,
    conditions_of: Vec<Vec<u32>>,
    /// Pairs that have been answered and whose consequences have not been drawn.
    open: Vec<usize>,
    /// Pairs in the order in which they were answered.
    trail: Vec<usize>,
    /// Whether two demands have asked for different answers, or a condition does not hold.
    contradicted: bool,
    /// By pair the triangles for which above what is above is above; empty: all that lie upon both.
    thirds: Vec<Vec<u32>>,
}

impl<'a> Order<'a> {
    pub fn new(pairs: &'a Pairs) -> Self {
        let count = pairs.triangles.len();
        Self {
            pairs,
            answers: vec![None; count],
            conditions: Vec::new(),
            conditions_of: vec![Vec::new(); count],
            open: Vec::new(),
            trail: Vec::new(),
            contradicted: false,
            thirds: Vec::new(),
        }
    }

    /// The literal that `b` is above `a`, if they lie upon each other.
    pub fn is_above(&self, a: u32, b: u32) -> Option<Literal> {
        self.pairs.between(a, b).map(|(pair, second)| Literal { pair, turned: !second })
    }

    /// Demands that the literal holds, unless another demand came first.
    pub fn demand(&mut self, literal: Literal, holds: bool) {
        let wanted = holds != literal.turned;
        match self.answers[literal.pair] {
            Some(answer) => self.contradicted |= answer != wanted,
            None => {
                self.answers[literal.pair] = Some(wanted);
                self.trail.push(literal.pair);
                self.open.push(literal.pair);
            }
        }
    }

    /// Demands that an even number of the literals does not hold: two are equal, four do not interleave.
    pub fn demand_even(&mut self, literals: &[Literal]) {
        let name = self.conditions.len() as u32;
        literals.iter().for_each(|literal| self.conditions_of[literal.pair].push(name));
        self.conditions.push(literals.to_vec());
    }

    /// Answers every pair: what follows from the demands first, then by height, the clearest one next, each with what
    /// follows from it.
    pub fn decide(&mut self) {
        self.follow();
        let heights = &self.pairs.heights;
        let mut rest: Vec<usize> = (0..heights.len()).collect();
        rest.sort_by(|a, b| heights[*b].abs().total_cmp(&heights[*a].abs()).then(a.cmp(b)));
        for pair in rest {
            self.demand(Literal { pair, turned: false }, self.pairs.heights[pair] >= 0.0);
            self.follow();
        }
    }

    /// Whether the second of the pair is above the first.
    pub fn above(&self, pair: usize) -> bool {
        self.answers[pair].unwrap_or_default()
    }

    pub(super) fn pairs(&self) -> &'a Pairs {
        self.pairs
    }

    /// Pairs that a condition links to this one.
    pub(super) fn linked(&self, pair: usize) -> impl Iterator<Item = usize> {
        let conditions = self.conditions_of[pair].iter().map(|name| &self.conditions[*name as usize]);
        conditions.flatten().map(|literal| literal.pair)
    }

    /// By pair the triangles for which above what is above is above, in place of all that lie upon both.
    pub(super) fn limit_to(&mut self, thirds: Vec<Vec<u32>>) {
        self.thirds = thirds;
    }

    pub(super) fn is_answered(&self, pair: usize) -> bool {
        self.answers[pair].is_some()
    }

    /// How many pairs are answered.
    pub(super) fn answered(&self) -> usize {
        self.trail.len()
    }

    /// Takes back all answers but the first so many.
    pub(super) fn take_back(&mut self, to: usize) {
        for pair in self.trail.drain(to..) {
            self.answers[pair] = None;
        }
        self.open.clear();
    }

    pub(super) fn contradict(&mut self) {
        self.contradicted = true;
    }

    /// Whether there was a contradiction; from here on there is none.
    pub(super) fn take_contradiction(&mut self) -> bool {
        std::mem::take(&mut self.contradicted)
    }

    fn value(&self, literal: Literal) -> Option<bool> {
        self.answers[literal.pair].map(|answer| answer != literal.turned)
    }

    /// Draws all consequences of what has been answered.
    pub(super) fn follow(&mut self) {
        while let Some(pair) = self.open.pop() {
            for condition in 0..self.conditions_of[pair].len() {
                self.follow_condition(self.conditions_of[pair][condition] as usize);
            }
            self.follow_stack(pair);
        }
    }

    fn follow_condition(&mut self, condition: usize) {
        let (mut missing, mut even) = (None, true);
        for literal in &self.conditions[condition] {
            match self.value(*literal) {
                Some(holds) => even ^= !holds,
                None if missing.is_some() => return,
                None => missing = Some(*literal),
            }
        }
        match missing {
            Some(literal) => self.demand(literal, even),
            None => self.contradicted |= !even,
        }
    }

    /// Above what is above is above.
    fn follow_stack(&mut self, pair: usize) {
        let [i, j] = self.pairs.triangles[pair];
        let (low, high) = if self.above(pair) { (i, j) } else { (j, i) };
        let pairs = self.pairs;
        let listed = self.thirds.get(pair).map_or(0, Vec::len);
        let all = if self.thirds.is_empty() { pairs.of(low as usize).len() } else { listed };
        for place in 0..all {
            let third = match self.thirds.get(pair) {
                Some(thirds) => thirds[place],
                None => pairs.of(low as usize)[place].0,
            };
            let [Some(on_low), Some(on_high)] = [low, high].map(|t| self.is_above(t, third)) else { continue };
            if self.value(on_high) == Some(true) {
                self.demand(on_low, true);
            }
            if self.value(on_low) == Some(false) {
                self.demand(on_high, false);
            }
        }
    }
}
