//! Which face lies upon which, for files.

use origami::picture::layers::face_orders;
use origami::{Model, State};
use serde_json::Value;

use super::listed;

/// FOLD's `faceOrders` of a state that is folded flat; `None` of others.
pub(crate) fn orders(model: &Model, state: &State) -> Option<Value> {
    face_orders(model, state).map(|orders| listed(&orders))
}
