//! The order of folding that a file has.

use origami_core::fold::Frame;
use origami_core::sequence::{Sequence, Stage};
use origami_core::{CreasePattern, Error, Model};

/// A sequence, and the frame that its numbers are of.
pub(crate) struct Order {
    sequence: Sequence,
    frame: Frame,
    names: Vec<String>,
}

impl Order {
    /// The steps in a frame, or its timeline to 100 %; `None` where it has neither.
    pub(crate) fn of(frame: Frame, pattern: &CreasePattern, model: &Model) -> Result<Option<Self>, Error> {
        let own = Sequence::in_frame(&frame)?;
        let own = own.map_or_else(|| Sequence::of_timeline(&frame, 100.0), |own| Ok(Some(own)))?;
        let Some(sequence) = own else { return Ok(None) };
        let mut order = Self { sequence, frame, names: Vec::new() };
        order.names = order.stages(pattern, model)?.into_iter().map(|stage| stage.name).collect();
        Ok(Some(order))
    }

    /// What its stages are called.
    pub(crate) fn names(&self) -> Vec<String> {
        self.names.clone()
    }

    /// Its stages for a model of the pattern.
    pub(crate) fn stages(&self, pattern: &CreasePattern, model: &Model) -> Result<Vec<Stage>, Error> {
        self.sequence.stages(&self.frame, pattern, model)
    }
}
