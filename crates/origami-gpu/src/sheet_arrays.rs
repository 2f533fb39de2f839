//! From models to the arrays that the shaders read: topology and constants, the same for all instances.

use std::sync::Arc;

use glam::DVec3;
use origami_core::csr::Csr;
use origami_core::ids::NodeId;
use origami_core::model::{Beam, Crease, Model, StiffnessSource};

use crate::layout::{ALONE, CREASE, FACET, FOLD, Face, Hinge, LooseBeam, OWN, RIGHT, split_square};
use crate::outside::Outside;

/// What the shaders read of a sheet and never write.
#[derive(Clone, Debug)]
pub(crate) struct SheetArrays {
    /// Nodes of one instance.
    pub(crate) nodes: usize,
    /// Where each node is at rest.
    pub(crate) rest: Vec<DVec3>,
    pub(crate) hinges: Vec<Hinge>,
    pub(crate) faces: Vec<Face>,
    /// By face; empty where no triangle has corner springs.
    pub(crate) corners: Vec<[f32; 4]>,
    /// Three a face, 0 for the material's; empty where no beam has its own.
    pub(crate) rigidities: Vec<f32>,
    pub(crate) loose_beams: Vec<LooseBeam>,
    /// First slot of each node, and the end of the last.
    pub(crate) rows: Vec<u32>,
    /// The nodes that may be loaded, in order, and the slot of each for its load: the last of its row.
    pub(crate) load_slots: Vec<(NodeId, u32)>,
    /// Whether areas of triangles resist.
    pub(crate) areas: bool,
    /// Whether some nodes are held, or may be.
    pub(crate) fixed: bool,
}

impl SheetArrays {
    /// The arrays of a model on which nothing acts from outside.
    pub(crate) fn new(model: &Model) -> Self {
        Self::with_outside(model, &Outside::default())
    }

    /// The arrays of a model, and of all that differ from it in nothing but their material; see [`same_springs`].
    pub(crate) fn with_outside(model: &Model, outside: &Outside) -> Self {
        let Slots { rows, of_faces: face_slots, of_loose: loose_slots, of_loads: load_slots } = slots(model, outside);
        let rigidities: Vec<f32> = model.beams.iter().map(own_rigidity).collect();
        let sides = sides_of_triangles(model);

        let hinges = model.creases.iter().map(|crease| hinge(model, crease)).collect();
        let faces = model.mesh.triangles.iter().zip(&sides).zip(face_slots);
        let faces = faces.map(|((nodes, sides), slots)| {
            let rest = sides.map(|s| split_square(model.beams[s.beam].rest_length));
            Face {
                nodes: nodes.map(|n| n.0),
                slots,
                sides: sides.map(|s| s.flagged),
                rest_high: rest.map(|r| r.0),
                rest_low: rest.map(|r| r.1),
            }
        });
        let faces = faces.collect();
        let mut corners = Vec::new();
        if !model.corner_angles.is_empty() {
            corners.resize(model.mesh.triangles.len(), [0.0; 4]);
            for own in &model.corner_angles {
                let [first, second] = own.rest;
                corners[own.triangle.index()] = [first.0, first.1, second.0, second.1].map(single);
            }
        }
        let loose = model.mesh.sides.iter().enumerate().filter(|(_, side)| side.triangles[0].is_none());
        let loose = loose.zip(loose_slots).map(|((beam, side), slots)| {
            let (rest_high, rest_low) = split_square(model.beams[beam].rest_length);
            LooseBeam { nodes: side.nodes.map(|n| n.0), slots, rest_high, rest_low, rigidity: rigidities[beam] }
        });
        let any_own = rigidities.iter().any(|r| *r > 0.0);
        Self {
            nodes: model.node_count(),
            rest: model.rest.clone(),
            hinges,
            faces,
            corners,
            rigidities: match any_own {
                true => sides.iter().flatten().map(|s| rigidities[s.beam]).collect(),
                false => Vec::new(),
            },
            loose_beams: loose.collect(),
            rows,
            load_slots,
            areas: model.k_area() > 0.0 && !model.mesh.triangles.is_empty(),
            fixed: outside.holds || !model.fixed.is_empty(),
        }
    }

    /// How many slots one instance has.
    pub(crate) fn slot_count(&self) -> usize {
        3 * self.faces.len() + 2 * self.loose_beams.len() + self.load_slots.len()
    }

    /// The most slots of one node.
    pub(crate) fn most_slots(&self) -> usize {
        self.rows.windows(2).map(|row| row[1] - row[0]).max().unwrap_or(0) as usize
    }
}

/// Whether two models have springs in the same places, with the same stiffness where a spring has its own, so that one set
/// of arrays serves both. Models of one pattern can differ in the places only where a stiffness is 0.
pub(crate) fn same_springs(a: &Model, b: &Model) -> bool {
    same_sheet(a, b)
        && a.beams.iter().zip(&b.beams).all(|(one, two)| same_rigidity(one, two))
        && a.fixed == b.fixed
        && a.creases.len() == b.creases.len()
        && a.creases.iter().zip(&b.creases).all(|(one, two)| same_stiffness(one, two))
        && a.corner_angles.len() == b.corner_angles.len()
        && (a.k_area() > 0.0) == (b.k_area() > 0.0)
}

/// Whether both are of one sheet, or of two that are alike: models that were not made together.
fn same_sheet(a: &Model, b: &Model) -> bool {
    Arc::ptr_eq(&a.sheet, &b.sheet)
        || a.rest == b.rest
            && a.mesh.triangles == b.mesh.triangles
            && a.beams.len() == b.beams.len()
            && a.beams.iter().zip(&b.beams).all(|(one, two)| one.nodes == two.nodes)
}

fn same_rigidity(one: &Beam, two: &Beam) -> bool {
    one.own == two.own && (!one.own || one.stiffness == two.stiffness)
}

fn same_stiffness(one: &Crease, two: &Crease) -> bool {
    one.nodes == two.nodes
        && one.source == two.source
        && (one.source != StiffnessSource::Own || one.stiffness == two.stiffness)
}

/// The rigidity of a beam that has its own; 0 for the material's.
fn own_rigidity(beam: &Beam) -> f32 {
    if beam.own { single(beam.stiffness * beam.rest_length) } else { 0.0 }
}

/// A crease, with the material's number that its stiffness comes from.
fn hinge(model: &Model, crease: &Crease) -> Hinge {
    let [apex_one, apex_two, end_one, end_two] = crease.nodes.map(|n| n.0);
    let (kind, length) = match crease.source {
        StiffnessSource::Fold => (FOLD, length(model, crease)),
        StiffnessSource::Facet => (FACET, length(model, crease)),
        _ => (OWN, crease.stiffness),
    };
    Hinge { apex_one, apex_two, end_one, end_two, length: single(length), kind }
}

fn length(model: &Model, crease: &Crease) -> f64 {
    let [end_one, end_two] = [crease.nodes[2], crease.nodes[3]].map(|n| model.rest[n.index()]);
    end_two.distance(end_one)
}

/// A side of a triangle.
#[derive(Clone, Copy)]
struct SideOf {
    /// The crease on it, with flags.
    flagged: u32,
    beam: usize,
}

/// The sides of every triangle, from each corner to the next.
fn sides_of_triangles(model: &Model) -> Vec<[SideOf; 3]> {
    let mut crease_on = vec![CREASE; model.mesh.sides.len()];
    for (c, crease) in (0..).zip(&model.creases) {
        crease_on[crease.side.index()] = c;
    }
    let mut sides = vec![[SideOf { flagged: CREASE, beam: 0 }; 3]; model.mesh.triangles.len()];
    for (s, side) in model.mesh.sides.iter().enumerate() {
        let alone = if side.triangles[1].is_none() { ALONE } else { 0 };
        for (which, triangle) in side.triangles.iter().enumerate() {
            let Some(triangle) = triangle else { continue };
            // To the left of a side its triangle runs with it, to the right against it.
            let (start, right) = if which == 0 { (side.nodes[0], 0) } else { (side.nodes[1], RIGHT) };
            let nodes = &model.mesh.triangles[triangle.index()];
            let Some(corner) = nodes.iter().position(|n| *n == start) else { continue };
            sides[triangle.index()][corner] = SideOf { flagged: crease_on[s] | alone | right, beam: s };
        }
    }
    sides
}

/// Where the forces on the nodes lie.
struct Slots {
    /// First slot of each node, and the end of the last.
    rows: Vec<u32>,
    of_faces: Vec<[u32; 3]>,
    /// Of beams outside any face.
    of_loose: Vec<[u32; 2]>,
    of_loads: Vec<(NodeId, u32)>,
}

/// Slots numbered by node, so that each node reads one after the other: those of its faces, of its beams outside any face,
/// and of its load.
fn slots(model: &Model, outside: &Outside) -> Slots {
    let loose: Vec<[usize; 2]> = model
        .mesh
        .sides
        .iter()
        .filter(|side| side.triangles[0].is_none())
        .map(|side| side.nodes.map(|n| n.index()))
        .collect();
    let triangles = || model.mesh.triangles.iter().map(|t| t.map(|n| n.index()));
    // Scenes are checked later.
    let loaded = || outside.loaded.iter().filter(|node| node.index() < model.node_count());
    let ends = triangles().flatten().chain(loose.iter().flatten().copied()).chain(loaded().map(|node| node.index()));
    let (rows, entries) = Csr::from_entries(model.node_count(), ends.zip(0_u32..)).into_parts();
    let mut slot_of_entry = vec![0_u32; entries.len()];
    (0..).zip(&entries).for_each(|(slot, entry)| slot_of_entry[*entry as usize] = slot);
    let mut slots = slot_of_entry.into_iter();
    let mut take = || slots.next().expect("one slot for each entry");
    let of_faces = triangles().map(|t| t.map(|_| take())).collect();
    let of_loose = loose.iter().map(|ends| ends.map(|_| take())).collect();
    let of_loads = loaded().map(|node| (*node, take())).collect();
    Slots { rows, of_faces, of_loose, of_loads }
}

#[expect(clippy::cast_possible_truncation, reason = "to the nearest")]
fn single(x: f64) -> f32 {
    x as f32
}
