//! How solvers begin under contact: what they refuse, and the layers of a sheet that nothing goes through.

use glam::DVec3;

use super::Precision;
use crate::contact::{Contact, Crossings, Layers};
use crate::model::Model;
use crate::scene::{Refusal, Scene};

/// Whether a sheet can be folded so in a scene, in numbers of that precision.
pub(super) fn check_contact(contact: Contact, precision: Precision, scene: &Scene) -> Result<(), Refusal> {
    let Contact { gap, stiffness, thickness } = contact;
    for (what, value) in [("gap", gap), ("stiffness", stiffness)] {
        if !(value.is_finite() && value > 0.0) {
            return Err(Refusal::Contact { what, value });
        }
    }
    if !(thickness.is_finite() && thickness >= 0.0) {
        return Err(Refusal::Contact { what: "thickness", value: thickness });
    }
    let unsupported = |what, expected| Err(Refusal::Unsupported { what, backend: "contact", expected });
    match precision {
        Precision::Mixed => unsupported("numbers of mixed precision", "f64"),
        Precision::F64 if !scene.forces.is_empty() => unsupported("forces", "a scene without forces of one's own"),
        Precision::F64 => Ok(()),
    }
}

/// The layers of a sheet that begins at `positions`, measured there; `shared` as for [`Layers::new`]. Refused where it begins
/// crossed or closed.
pub(super) fn first_layers(
    model: &Model,
    positions: &[DVec3],
    contact: Contact,
    shared: bool,
) -> Result<Layers, Refusal> {
    let crossings = Crossings::of(&model.mesh, positions);
    if let Some([one, other]) = crossings.faces.first() {
        return Err(Refusal::Crossed { faces: [*one, *other] });
    }
    let mut layers = Layers::new(&model.mesh, &model.rest, contact, shared);
    layers.measure(positions);
    if layers.least_gap() > 0.0 { Ok(layers) } else { Err(Refusal::Closed { gap: layers.least_gap() }) }
}
