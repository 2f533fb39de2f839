//! The fold angles that creases are asked for.

use std::sync::Arc;

use super::Refusal;
use crate::model::Model;

/// The fold angle asked of each crease. A percentage of the pattern's angles is one way to say it.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Targets(Asked);

#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
enum Asked {
    /// The angles of the sheet as the file gives it.
    #[default]
    AtRest,
    Percent(f64),
    /// By crease, in radians.
    Angles(Arc<[f64]>, Option<f64>),
}

impl Targets {
    /// The angles that the sheet has as the file gives it: 0 on a flat pattern.
    #[must_use]
    pub fn at_rest() -> Self {
        Self(Asked::AtRest)
    }

    /// A percentage of the pattern's fold angles: 0 flat, 100 all of them, negative the other way.
    #[must_use]
    pub fn percent(percent: f64) -> Self {
        Self(Asked::Percent(percent))
    }

    /// An angle for each crease of [`Model::creases`], in radians, valleys positive.
    #[must_use]
    pub fn angles(angles: impl Into<Arc<[f64]>>) -> Self {
        Self(Asked::Angles(angles.into(), None))
    }

    /// The same angles with a percentage to be shown for them.
    #[must_use]
    pub fn labelled(self, model: &Model, percent: f64) -> Self {
        match self.of(model) {
            Ok(angles) => Self(Asked::Angles(angles.into(), Some(percent))),
            Err(_) => self,
        }
    }

    /// The percentage that these angles are, or are called by; `None` for angles that are none.
    #[must_use]
    pub fn label(&self) -> Option<f64> {
        match &self.0 {
            Asked::AtRest => None,
            Asked::Percent(percent) => Some(*percent),
            Asked::Angles(_, label) => *label,
        }
    }

    /// The angles asked of the creases of `model`, in their order, in radians.
    ///
    /// # Errors
    /// [`Refusal`] where there are not as many angles as creases, or one is not finite.
    pub fn of(&self, model: &Model) -> Result<Vec<f64>, Refusal> {
        let angles = match &self.0 {
            Asked::AtRest => return Ok(model.creases.iter().map(|crease| crease.rest_angle).collect()),
            Asked::Percent(percent) if !percent.is_finite() => return Err(Refusal::Percent(*percent)),
            Asked::Percent(percent) => return Ok(model.targets(*percent)),
            Asked::Angles(angles, _) => angles,
        };
        if angles.len() != model.creases.len() {
            return Err(Refusal::TargetCount { given: angles.len(), creases: model.creases.len() });
        }
        match angles.iter().position(|angle| !angle.is_finite()) {
            Some(crease) => Err(Refusal::Target { crease, angle: angles[crease] }),
            None => Ok(angles.to_vec()),
        }
    }
}
