//! Which face lies upon which, for files.

use origami::picture::layers::{FaceOrder, face_orders};
use origami::{Model, State};
use serde_json::{Value, json};

/// FOLD's `faceOrders` of a state that is folded flat; `None` of others.
pub(crate) fn orders(model: &Model, state: &State) -> Option<Value> {
    let triple = |order: FaceOrder| json!([order.faces[0].0, order.faces[1].0, order.side]);
    face_orders(model, state).map(|orders| orders.into_iter().map(triple).collect())
}
