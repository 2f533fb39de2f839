//! Raising the target angles continuously. Loosely settled stages end in tangled states more often, since every restart
//! throws the momentum away.

/// Target angles on their way from where they were to where they shall be.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Ramp {
    from: Vec<f64>,
    to: Vec<f64>,
    /// Evaluations that the whole way takes.
    length: u32,
    share: f64,
}

impl Ramp {
    /// From the targets `from` to the targets `to`; `length` 0 is a jump.
    pub(super) fn new(from: &[f64], to: Vec<f64>, length: u32) -> Self {
        let mut ramp = Self { from: from.to_vec(), to, length, share: 0.0 };
        if length == 0 || ramp.to == ramp.from {
            ramp.finish();
        }
        ramp
    }

    /// The targets now, by crease.
    pub(super) fn targets(&self) -> impl ExactSizeIterator<Item = f64> + '_ {
        let (done, share) = (self.done(), self.share);
        let from = if done { &self.to } else { &self.from };
        let between = move |(from, to): (&f64, &f64)| if done { *to } else { from + share * (to - from) };
        from.iter().zip(&self.to).map(between)
    }

    /// The share of the way that has been covered, 0 to 1.
    pub(super) fn share(&self) -> f64 {
        self.share
    }

    pub(super) fn done(&self) -> bool {
        self.share >= 1.0
    }

    /// One evaluation's worth further.
    pub(super) fn advance(&mut self) {
        if self.done() {
            return;
        }
        self.share += 1.0 / f64::from(self.length);
        // The last of many equal parts: rounding must not add another.
        if self.share > 1.0 - 0.5 / f64::from(self.length) {
            self.finish();
        }
    }

    /// The targets at its end, whether it got there or not: what the state is to be measured against.
    pub(super) fn asked(&self) -> &[f64] {
        &self.to
    }

    /// The same, without the ramp.
    pub(super) fn into_asked(self) -> Vec<f64> {
        self.to
    }

    fn finish(&mut self) {
        self.share = 1.0;
        // A jump has no way behind it.
        self.from = Vec::new();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn takes_exactly_its_length_and_ends_exactly() {
        for length in [1, 2, 3, 7, 1000, 3333] {
            let from = [0.1, -3.0];
            let mut ramp = Ramp::new(&from, vec![2.3, 0.7], length);
            assert_eq!(ramp.targets().collect::<Vec<_>>(), from);
            let mut steps = 0;
            while !ramp.done() {
                ramp.advance();
                steps += 1;
            }
            assert_eq!(steps, length);
            assert_eq!(ramp.targets().collect::<Vec<_>>(), vec![2.3, 0.7]);
        }
        assert_eq!(Ramp::new(&[0.0], vec![1.0], 5).into_asked(), [1.0], "before its end too");
        assert!(Ramp::new(&[0.0], vec![1.0], 0).done(), "a jump is over at once");
        assert!(Ramp::new(&[1.0], vec![1.0], 5).done(), "there is no way to go");
    }
}
