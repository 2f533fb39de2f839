//! A folding order: each crease has its own way from one angle to the next.

use crate::ids::{CreaseId, EdgeId};
use crate::model::Model;

use super::Targets;

/// Target angles over a share of time, 0 to 1: for each crease keys (share, angle), straight between them, and constant
/// before the first and after the last. A crease without keys of its own goes straight from its angle at rest, at 0, to its
/// target at 100 %, at 1.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Timeline {
    /// By crease: (share, angle in radians), shares ascending, never empty.
    keys: Vec<Vec<(f64, f64)>>,
    /// By edge of the pattern.
    crease_of_edge: Vec<Option<CreaseId>>,
}

/// Why a key cannot be set.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum KeyRefused {
    /// The edge has no crease with a spring.
    #[error("edge {}: it has no crease spring; expected a mountain, a valley or a flat crease", .0.0)]
    NoCrease(EdgeId),
    /// There are no keys.
    #[error("keys of edge {}: there are none; expected at least one (share, angle)", .0.0)]
    Empty(EdgeId),
    /// A key is out of order or not finite.
    #[error("keys[{index}] of edge {}: ({share}, {angle}); expected a share of 0 to 1, no less than that before it, and a finite angle", edge.0)]
    Key {
        /// The edge.
        edge: EdgeId,
        /// The key's index.
        index: usize,
        /// Its share of time.
        share: f64,
        /// Its angle, in radians.
        angle: f64,
    },
}

impl Timeline {
    /// All creases at once, from rest to their targets at 100 %.
    #[must_use]
    pub fn new(model: &Model) -> Self {
        let keys = model.creases.iter().map(|c| vec![(0.0, c.rest_angle), (1.0, c.full_target)]).collect();
        let edges = 0..model.mesh.side_of_edge.len();
        Self { keys, crease_of_edge: edges.map(|edge| model.crease_of(EdgeId::new(edge))).collect() }
    }

    /// The keys of one edge's crease: (share of time from 0 to 1, angle in radians, valleys positive), shares ascending.
    ///
    /// # Errors
    /// [`KeyRefused`] where the edge has no crease spring, or a key is out of order or not finite.
    pub fn set(&mut self, edge: EdgeId, keys: impl Into<Vec<(f64, f64)>>) -> Result<&mut Self, KeyRefused> {
        let crease = self.crease_of_edge.get(edge.index()).copied().flatten().ok_or(KeyRefused::NoCrease(edge))?;
        let keys = keys.into();
        if keys.is_empty() {
            return Err(KeyRefused::Empty(edge));
        }
        let mut before = 0.0;
        for (index, &(share, angle)) in keys.iter().enumerate() {
            if !(before..=1.0).contains(&share) || !angle.is_finite() {
                return Err(KeyRefused::Key { edge, index, share, angle });
            }
            before = share;
        }
        self.keys[crease.index()] = keys;
        Ok(self)
    }

    /// The angle of a crease at a share of time.
    fn angle(keys: &[(f64, f64)], share: f64) -> f64 {
        let next = keys.partition_point(|(at, _)| *at <= share);
        match (next.checked_sub(1).map(|i| keys[i]), keys.get(next)) {
            (Some((from, a)), Some(&(to, b))) => a + (b - a) * (share - from) / (to - from),
            (Some((_, angle)), None) | (None, Some(&(_, angle))) => angle,
            (None, None) => 0.0,
        }
    }

    /// The targets at a share of time, 0 to 1.
    #[must_use]
    pub fn at(&self, share: f64) -> Targets {
        Targets::angles(self.keys.iter().map(|keys| Self::angle(keys, share)).collect::<Vec<_>>())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::catalog;
    use crate::model::Material;

    #[test]
    fn keys_are_straight_between_and_constant_outside() {
        let keys = [(0.2, 1.0), (0.4, 3.0), (0.4, -1.0), (0.8, 0.0)];
        let angles = [0.0, 0.2, 0.3, 0.4, 0.6, 0.8, 1.0].map(|share| Timeline::angle(&keys, share));
        let wanted = [1.0, 1.0, 2.0, -1.0, -0.5, 0.0, 0.0];
        assert!(angles.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-12), "{angles:?}");
    }

    #[test]
    fn without_keys_it_is_the_percentage() {
        let pattern = catalog::generate("bird-base", &[]).expect("a pattern");
        let model = Model::new(&pattern, &Material::default()).expect("a model");
        let (timeline, percent) = (Timeline::new(&model).at(0.6), Targets::percent(60.0));
        let (a, b) = (timeline.of(&model).expect("targets"), percent.of(&model).expect("targets"));
        assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-15));
        assert!(a.iter().any(|angle| angle.abs() > 1.0), "something is compared");
    }

    #[test]
    fn keys_that_cannot_be_are_refused_with_their_place() {
        let pattern = catalog::generate("single-crease", &[]).expect("a pattern");
        let model = Model::new(&pattern, &Material::default()).expect("a model");
        let mut timeline = Timeline::new(&model);
        let crease = (0..).map(EdgeId).find(|e| model.crease_of(*e).is_some()).expect("one crease");
        let border = (0..).map(EdgeId).find(|e| model.crease_of(*e).is_none()).expect("a border");
        assert_eq!(timeline.set(border, [(0.0, 1.0)]), Err(KeyRefused::NoCrease(border)));
        assert_eq!(timeline.set(crease, []), Err(KeyRefused::Empty(crease)));
        for (keys, index) in
            [([(0.5, 0.0), (0.4, 0.0)], 1), ([(-0.1, 0.0), (0.4, 0.0)], 0), ([(0.0, 0.0), (1.0, f64::NAN)], 1)]
        {
            let refused = timeline.set(crease, keys).expect_err("a bad key").to_string();
            assert!(refused.starts_with(&format!("keys[{index}] of edge {}", crease.0)), "{refused}");
        }
        assert!(timeline.set(crease, [(0.0, 0.0), (1.0, 1.0)]).is_ok());
    }
}
