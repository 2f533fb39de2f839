//! Ways to build the kernels.

use origami_core::Material;

use crate::blocks::{Extent, Room};
use crate::variant::{InContact, Scheme, Small, Variant};

/// A relaxation with everything that a plain sheet has.
pub(crate) fn plain() -> Variant {
    Variant {
        scheme: Scheme::Relax,
        corners: true,
        rigidities: false,
        areas: false,
        softens: false,
        fixed: false,
        material: Some(Material::default()),
        nodes: 100,
        creases: 200,
        faces: 150,
        loose_beams: 0,
        slots: 450,
        loads: false,
        blocks: None,
        workgroup: 64,
        small: Small { steps: 20, words: 900, renewal: 10 },
        contact: None,
    }
}

/// Some blocks.
pub(crate) fn extent() -> Extent {
    Extent { count: 2, room: Room { nodes: 70, creases: 120, slots: 250 }, positions: 130, velocities: 120 }
}

/// A sheet whose layers push each other away, thick or not.
pub(crate) fn in_contact(thick: bool) -> Variant {
    let contact = InContact { stiffness: 50.0, thick, longest_move: 2e-3, patience: 4000 };
    Variant { contact: Some(contact), fixed: thick, ..plain() }
}

/// All that differ in their text, with every motion and both sizes of workgroups among them.
pub(crate) fn of_texts() -> Vec<Variant> {
    let dynamics = |verlet, damped| Scheme::Dynamics { verlet, damped };
    let motions =
        [Scheme::Relax, dynamics(false, true), dynamics(true, true), dynamics(false, false), dynamics(true, false)];
    (0..32_usize)
        .map(|bits| {
            let is = |bit: usize| bits >> bit & 1 == 1;
            Variant {
                scheme: motions[bits % motions.len()],
                corners: is(0),
                rigidities: is(1),
                areas: is(0) != is(3),
                softens: bits % motions.len() == 0,
                material: is(2).then(Material::default),
                loose_beams: if is(3) { 4 } else { 0 },
                loads: is(4) && is(1),
                blocks: is(4).then_some(extent()),
                fixed: bits % 3 == 0,
                workgroup: if bits % 2 == 0 { 64 } else { 256 },
                ..plain()
            }
        })
        .chain([false, true].map(in_contact))
        .collect()
}
