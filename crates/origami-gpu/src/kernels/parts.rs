//! The parts of shaders that several kernels are made of.

use origami_shaders as wgsl;

use crate::variant::Variant;

/// The parts of kernels that work on blocks of a sheet.
pub(super) fn in_blocks(variant: &Variant) -> Vec<&'static str> {
    [springs_of_block(variant), vec![wgsl::BLOCK_WORDS, wgsl::BLOCK_NODES, wgsl::BLOCK_CREASES]].concat()
}

/// The parts of kernels that have a whole sheet.
pub(super) fn whole_sheet(variant: &Variant) -> Vec<&'static str> {
    let own = vec![wgsl::RAMP, wgsl::SMALL_SHEET, soft_creases(variant), wgsl::ROW_SUMS, wgsl::BLOCK_ROW_SUMS];
    [springs_of_block(variant), own, vec![wgsl::REDUCE, wgsl::WINDOWS, wgsl::SETTLING]].concat()
}

/// The springs of a block, wherever it is.
pub(super) fn springs_of_block(variant: &Variant) -> Vec<&'static str> {
    let mut parts = vec![variant.material(), variant.soft(), wgsl::ANGLE, wgsl::HINGE, wgsl::FACE, wgsl::LOOSE_BEAM];
    parts.extend([wgsl::BLOCK, wgsl::BLOCK_ANGLES]);
    parts.extend(match variant.corners {
        true => &[wgsl::CORNER_ANGLES, wgsl::BLOCK_CORNERS][..],
        false => &[wgsl::CORNER_ANGLES_NONE],
    });
    parts.extend(if variant.areas { &[wgsl::AREAS, wgsl::BLOCK_AREAS][..] } else { &[wgsl::AREAS_NONE] });
    parts.push(if variant.rigidities { wgsl::BLOCK_RIGIDITY_OWN } else { wgsl::RIGIDITY_UNIFORM });
    parts.push(if variant.loads { wgsl::LOADS } else { wgsl::LOADS_NONE });
    parts.extend([wgsl::FOLD_ANGLES, wgsl::TRIANGLE_FORCES, wgsl::CLOCK, wgsl::BLOCK_SPRINGS]);
    parts
}

/// The part that tells what creases on the wrong side add to the row sums.
pub(super) fn soft_creases(variant: &Variant) -> &'static str {
    if variant.softens { wgsl::SOFT_CREASES } else { wgsl::SOFT_CREASES_NONE }
}

/// The parts of FIRE.
pub(super) fn fire(variant: &Variant) -> Vec<&'static str> {
    vec![variant.soft(), wgsl::FIRE]
}

/// The parts that sum the forces on a node.
pub(super) fn gather(variant: &Variant) -> Vec<&'static str> {
    if variant.blocks.is_some() { vec![wgsl::BLOCK_GATHER] } else { vec![wgsl::SLOTS, wgsl::GATHER] }
}

/// The parts that tell the force on a node.
pub(super) fn force_on(variant: &Variant) -> Vec<&'static str> {
    let mut parts = gather(variant);
    parts.extend(match variant.contact {
        Some(_) => &[wgsl::PAIR_ROWS, wgsl::PUSHES, wgsl::FORCE_IN_CONTACT][..],
        None => &[wgsl::FORCE_OF_SPRINGS],
    });
    parts
}

/// The parts of kernels that work on pairs.
pub(super) fn pairs(variant: &Variant) -> Vec<&'static str> {
    let thick = variant.contact.is_some_and(|contact| contact.thick);
    vec![wgsl::PAIR_ROWS, wgsl::PAIRS, if thick { wgsl::THICK } else { wgsl::THICK_NONE }]
}

/// The parts that tell how stiff a crease is.
pub(super) fn creases(variant: &Variant) -> Vec<&'static str> {
    let mut parts = vec![variant.material(), variant.soft(), wgsl::ANGLE, wgsl::RAMP, wgsl::HINGE, wgsl::FACE];
    parts.extend([wgsl::WHOLE_NODES, wgsl::WHOLE_CREASES, wgsl::WHOLE_LISTS]);
    parts
}

/// The parts that the triangles' forces and row sums have in common.
pub(super) fn springs(variant: &Variant) -> Vec<&'static str> {
    let mut parts = creases(variant);
    parts.push(wgsl::SLOTS);
    parts.extend(if variant.corners {
        &[wgsl::CORNER_ANGLES, wgsl::WHOLE_CORNERS][..]
    } else {
        &[wgsl::CORNER_ANGLES_NONE]
    });
    parts.extend(if variant.areas { &[wgsl::AREAS, wgsl::WHOLE_AREAS][..] } else { &[wgsl::AREAS_NONE] });
    parts.push(if variant.rigidities { wgsl::RIGIDITY_OWN } else { wgsl::RIGIDITY_UNIFORM });
    parts
}
