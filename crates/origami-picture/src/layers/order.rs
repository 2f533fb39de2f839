//! Which of each pair is on top, by what folds demand and then by what positions suggest.

use super::pairs::Pairs;

/// A pair's answer as it stands, or turned around.
#[derive(Clone, Copy, Debug)]
pub(super) struct Literal {
    pub(super) pair: usize,
    pub(super) turned: bool,
}

/// Answers by pair: whether its second triangle is above the first.
pub(super) struct Order<'a> {
    pairs: &'a Pairs,
    answers: Vec<Option<bool>>,
    /// Conditions that an even number of these literals is false.
    conditions: Vec<Vec<Literal>>,
    conditions_of: Vec<Vec<u32>>,
    /// Pairs that have been answered and whose consequences have not been drawn.
    open: Vec<usize>,
}

impl<'a> Order<'a> {
    pub(super) fn new(pairs: &'a Pairs) -> Self {
        let count = pairs.triangles.len();
        Self {
            pairs,
            answers: vec![None; count],
            conditions: Vec::new(),
            conditions_of: vec![Vec::new(); count],
            open: Vec::new(),
        }
    }

    /// The literal that `b` is above `a`, if they lie upon each other.
    pub(super) fn is_above(&self, a: u32, b: u32) -> Option<Literal> {
        self.pairs.between(a, b).map(|(pair, second)| Literal { pair, turned: !second })
    }

    /// Demands that the literal holds, unless another demand came first.
    pub(super) fn demand(&mut self, literal: Literal, holds: bool) {
        if self.answers[literal.pair].is_none() {
            self.answers[literal.pair] = Some(holds != literal.turned);
            self.open.push(literal.pair);
        }
    }

    /// Demands that an even number of the literals does not hold: two are equal, four do not interleave.
    pub(super) fn demand_even(&mut self, literals: &[Literal]) {
        let name = self.conditions.len() as u32;
        literals.iter().for_each(|literal| self.conditions_of[literal.pair].push(name));
        self.conditions.push(literals.to_vec());
    }

    /// Answers every pair: what follows from the demands first, then by height, the clearest one next, each with what
    /// follows from it.
    pub(super) fn decide(&mut self) {
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
    pub(super) fn above(&self, pair: usize) -> bool {
        self.answers[pair].unwrap_or_default()
    }

    fn value(&self, literal: Literal) -> Option<bool> {
        self.answers[literal.pair].map(|answer| answer != literal.turned)
    }

    /// Draws all consequences of what has been answered.
    fn follow(&mut self) {
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
        if let Some(literal) = missing {
            self.demand(literal, even);
        }
    }

    /// Above what is above is above.
    fn follow_stack(&mut self, pair: usize) {
        let [i, j] = self.pairs.triangles[pair];
        let (low, high) = if self.above(pair) { (i, j) } else { (j, i) };
        let pairs = self.pairs;
        for (third, _) in pairs.of(low as usize) {
            let third = *third;
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
