//! What a sheet's pipelines hold and do without.

use origami_core::contact::Contact;
use origami_core::model::{Built, Inventory, LeftOut, Model};

use crate::device::Abilities;
use crate::plan::Plan;
use crate::purpose::{Dispatch, Purpose};
use crate::route::Route;
use crate::sheet_arrays::SheetArrays;
use crate::variant::Scheme;

/// The same of a sheet under contact, which goes by passes.
pub(crate) fn in_contact(model: &Model, mut inventory: Inventory, contact: Contact) -> Inventory {
    let purpose = Purpose { scheme: Scheme::Relax, safe: false, softens: false, dispatch: Dispatch::Passes };
    // Neither has a say in passes.
    let abilities = Abilities { hardware: false, workgroup_storage: 0 };
    inventory = of(model, inventory, purpose, abilities);
    // What FIRE moves by itself is moved here by what layers leave of it.
    inventory.built.push(Built { what: "passes over pairs that may touch", count: 2 });
    if contact.thickness == 0.0 {
        inventory.left_out.push(LeftOut { what: "thickness of pairs", count: 0, why: "the paper has none" });
    }
    inventory
}

/// The model's inventory `inventory`, and what the GPU's pipelines add to it.
pub(crate) fn of(model: &Model, mut inventory: Inventory, purpose: Purpose, abilities: Abilities) -> Inventory {
    let arrays = SheetArrays::new(model);
    let plain = purpose.variant(&arrays, Some(model.material));
    let route = Route::new(&arrays, purpose, abilities);
    let variant = route.variant(&plain);
    let plan = Plan::new(&variant, purpose.safe);
    let mut built = |what, count| inventory.built.push(Built { what, count });
    let by_blocks = route.blocks().is_some();
    match &route {
        Route::Workgroup(_) => built("passes in one workgroup", 1),
        Route::Blocks(blocks) => built("blocks of nodes, a workgroup each", blocks.extent.count),
        // Fold angles, forces of triangles and what follows.
        Route::Passes => built("passes over all elements", 2 + plan.integration.len()),
    }
    if variant.loose_beams > 0 {
        built(if by_blocks { "loose beams in blocks" } else { "pass of loose beams" }, variant.loose_beams);
    }
    if variant.rigidities {
        built(if by_blocks { "rigidities in blocks" } else { "buffer of rigidities" }, arrays.rigidities.len());
    }
    let mut without = |what, why| inventory.left_out.push(LeftOut { what, count: 0, why });
    if variant.loose_beams == 0 {
        without("pass of loose beams", "every beam lies on a face");
    }
    if !variant.rigidities {
        without("buffer of rigidities", "all beams have the material's: a constant");
    }
    if !variant.corners {
        without("buffer of corner angles", "there are none");
    }
    if matches!(purpose.scheme, Scheme::Relax) {
        without(
            "lighter masses of near nodes, handing over to Newton's method, search for saddles",
            "shaders have none",
        );
    }
    without("strain and energy on the GPU", "they are measured on the state that is read");
    inventory
}
