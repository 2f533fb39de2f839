//! A folded sheet as a FOLD document, as `origami fold` writes it.

use origami::export::Pose;
use origami::fold::Document;
use origami::{Error, Folded};

use crate::model::Sheet;

/// The order of faces that lie on each other, a key of FOLD.
const FACE_ORDERS: &str = "faceOrders";

/// The folded form, which says how far it is from the equilibrium, and in which order faces lie, where that can be told.
pub(crate) fn folded_form(sheet: &Sheet, folded: &Folded) -> Result<Document, Error> {
    let pose = Pose::of(&sheet.model, sheet.pattern(), folded);
    let mut document = sheet.read.template.folded_form(sheet.pattern(), &pose)?;
    let extra = &mut document.key_frame.extra;
    extra.insert("origami:converged".into(), folded.converged().into());
    extra.insert("origami:distance".into(), folded.distance.into());
    // That of the file was of another state.
    extra.shift_remove(FACE_ORDERS);
    #[cfg(feature = "render")]
    if let Some(orders) = origami::picture::layers::face_orders(&sheet.model, &folded.state) {
        let triple = orders.iter().map(|order| serde_json::json!([order.faces[0].0, order.faces[1].0, order.side]));
        extra.insert(FACE_ORDERS.into(), triple.collect());
    }
    Ok(document)
}
