//! The states without load on a path: equilibria of their own, and what lies between them.

use super::{Event, Trace};

/// A state on a path in which nothing acts.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Equilibrium {
    /// Which of the path's points it is.
    pub point: usize,
    /// What is stored in it.
    pub energy: f64,
    /// Independent directions in which the energy falls from it: 0 where it is stable.
    pub index: usize,
    /// What a stable state must be given so that it passes to the next one on the path: the energy of the saddle between them
    /// above its own. None for states that are not stable, where no stable one follows, or where what lies between is no
    /// saddle of index 1: the way over such a state is no lowest one, and another leads lower.
    pub barrier: Option<f64>,
}

impl Trace {
    /// The states without load, in order; where the path begins without load, its start is the first.
    #[must_use]
    pub fn equilibria(&self) -> Vec<Equilibrium> {
        let without_load = |(i, point): (usize, &super::Point)| {
            let is = point.event == Event::ZeroLoad || i == 0 && point.load_factor == 0.0;
            is.then(|| Equilibrium { point: i, energy: point.energies.total(), index: point.negative, barrier: None })
        };
        let mut found: Vec<Equilibrium> = self.points.iter().enumerate().filter_map(without_load).collect();
        for i in 0..found.len() {
            if let Some([saddle, next]) = found.get(i + 1..i + 3)
                && (found[i].index, saddle.index, next.index) == (0, 1, 0)
            {
                found[i].barrier = Some(saddle.energy - found[i].energy);
            }
        }
        found
    }
}
