//! What a sheet's pipelines hold and do without.

use origami_core::model::{Built, Inventory, LeftOut, Model};

use crate::engine::is_by_workgroup;
use crate::plan::Plan;
use crate::purpose::Purpose;
use crate::sheet_arrays::SheetArrays;
use crate::variant::Variant;

/// The model's inventory `inventory`, and what the GPU's pipelines add to it.
pub(crate) fn of(model: &Model, mut inventory: Inventory, purpose: Purpose) -> Inventory {
    let arrays = SheetArrays::new(model);
    let variant = Variant::new(&arrays, purpose.scheme, Some(model.material));
    let mut built = |what, count| inventory.built.push(Built { what, count });
    if is_by_workgroup(&arrays, &variant, purpose) {
        built("passes in one workgroup", 1);
    } else {
        let plan = Plan::new(&variant, purpose.safe);
        built(
            "passes over all elements",
            plan.forces.len() - usize::from(variant.loose_beams > 0) + plan.integration.len(),
        );
    }
    if variant.loose_beams > 0 {
        built("pass of loose beams", variant.loose_beams);
    }
    if variant.rigidities {
        built("buffer of rigidities", arrays.rigidities.len());
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
    without("strain and energy on the GPU", "they are measured on the state that is read");
    inventory
}
