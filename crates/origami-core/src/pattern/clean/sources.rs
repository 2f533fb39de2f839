//! Where edges were written before there was a FOLD file: a line's number, an element's id.

use serde_json::Value;

use crate::error::{Error, Place};
use crate::fold::Frame;
use crate::pattern::keys;

/// What the frame has under [`keys::SOURCE`].
pub(super) struct Sources<'a>(&'a [Value]);

impl<'a> Sources<'a> {
    pub(super) fn of(frame: &'a Frame) -> Self {
        Self(frame.extra.get(keys::SOURCE).and_then(Value::as_array).map_or(&[], Vec::as_slice))
    }

    /// `place` with the source of its edge, where there is one.
    pub(super) fn of_place(&self, place: Place) -> Place {
        let edge = place.edge().and_then(|edge| self.0.get(edge.index()));
        match edge.and_then(Value::as_str) {
            Some(source) => place.written_at(source),
            None => place,
        }
    }

    /// `error` with the source of its edge, where there is one.
    pub(super) fn of_error(&self, mut error: Error) -> Error {
        if let Error::Invalid(invalid) = &mut error {
            invalid.place = self.of_place(invalid.place.clone());
        }
        error
    }
}
