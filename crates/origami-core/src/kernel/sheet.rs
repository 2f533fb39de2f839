//! A model laid out for the passes: elements side by side, as many as a lane is wide, field after field.

use crate::forces::damping;
use crate::ids::{NodeId, SideId};
use crate::model::Model;

use super::real::{Quad64, Real};

/// All about a model that the passes need and that never changes. What the model does not have is an empty list.
///
/// Elements are filled up to whole chunks with ones on nodes of their own, which form a sound hinge and pull at nothing.
#[derive(Clone, Debug)]
pub(super) struct Sheet<R> {
    pub(super) nodes: usize,
    /// By chunk of creases: apexes one and two, ends one and two.
    pub(super) hinges: Vec<u32>,
    /// By crease.
    pub(super) stiffness: Vec<R>,
    /// By chunk of faces: the three corners.
    pub(super) corners: Vec<u32>,
    /// By chunk of faces: the creases on the sides 0-1, 1-2 and 2-0.
    pub(super) creases: Vec<u32>,
    /// By chunk of faces: the rest lengths of the sides, then the stiffness of each one's share of the beam.
    pub(super) beams: Vec<R>,
    /// By chunk of faces: each side's share of the damping.
    pub(super) damping: Vec<R>,
    /// By chunk of faces: cosine and sine of the first angle at rest and of the second.
    pub(super) angles: Vec<R>,
    /// By chunk of beams outside any face: their two ends.
    pub(super) loose_ends: Vec<u32>,
    /// The same: rest length, stiffness, damping.
    pub(super) loose_beams: Vec<R>,
    /// The first slot of each node in `slots`, and the end of the last.
    pub(super) rows: Vec<u32>,
    /// Where the forces on each node lie; nothing is gathered for one that is fixed.
    pub(super) slots: Vec<u32>,
    pub(super) k_face: f64,
    pub(super) damped: bool,
}

/// A hinge and its nodes: ends, then apexes.
const DUMMY: [[f64; 4]; 4] = [[0.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.5, 1.0, 0.0, 0.0], [0.5, -1.0, 0.0, 0.0]];

/// One triangle before it is laid out.
#[derive(Clone, Copy)]
struct Face {
    corners: [u32; 3],
    creases: [u32; 3],
    rest_lengths: [f64; 3],
    stiffness: [f64; 3],
    damping: [f64; 3],
    angles: [f64; 4],
}

impl<R: Real> Sheet<R> {
    /// Of `model`, `width` elements side by side.
    pub(super) fn new(model: &Model, width: usize) -> Self {
        let nodes = model.node_count();
        // Of the nodes after the sheet's own.
        let dummy = |i: usize| NodeId::new(nodes + i).0;
        let no_hinge = [dummy(2), dummy(3), dummy(0), dummy(1)];
        // At least one of them is no crease: the one of sides that have none.
        let creases = if model.creases.is_empty() { 0 } else { (model.creases.len() + 1).next_multiple_of(width) };
        let mut hinges: Vec<[u32; 4]> = model.creases.iter().map(|crease| crease.nodes.map(|n| n.0)).collect();
        hinges.resize(creases, no_hinge);
        let mut stiffness: Vec<R> = model.creases.iter().map(|crease| R::of(crease.stiffness)).collect();
        stiffness.resize(creases, R::of(0.0));

        let (faces, loose) = elements(model);
        let no_face = Face {
            corners: [dummy(0), dummy(1), dummy(2)],
            creases: [SideId::new(model.creases.len()).0; 3],
            rest_lengths: [1.0; 3],
            stiffness: [0.0; 3],
            damping: [0.0; 3],
            angles: [1.0, 0.0, 1.0, 0.0],
        };
        let damped = model.material.zeta > 0.0;
        let has_corners = !model.corner_angles.is_empty();
        let (rows, slots) = slots(model, width, &faces, &loose);
        let no_loose = ([dummy(0), dummy(1)], [1.0, 0.0, 0.0]);
        Self {
            nodes,
            hinges: chunks(&hinges, no_hinge, width, |nodes| *nodes),
            stiffness,
            corners: chunks(&faces, no_face, width, |face| face.corners),
            creases: if creases > 0 { chunks(&faces, no_face, width, |face| face.creases) } else { Vec::new() },
            beams: chunks(&faces, no_face, width, |face| {
                let ([a, b, c], [k_a, k_b, k_c]) = (face.rest_lengths, face.stiffness);
                [a, b, c, k_a, k_b, k_c].map(R::of)
            }),
            damping: if damped { chunks(&faces, no_face, width, |face| face.damping.map(R::of)) } else { Vec::new() },
            angles: if has_corners {
                chunks(&faces, no_face, width, |face| face.angles.map(R::of))
            } else {
                Vec::new()
            },
            loose_ends: chunks(&loose, no_loose, width, |(ends, _)| *ends),
            loose_beams: chunks(&loose, no_loose, width, |(_, beam)| beam.map(R::of)),
            rows,
            slots,
            k_face: model.material.k_face,
            damped,
        }
    }

    /// The places of all nodes, and of those of the filling.
    pub(super) fn places(&self, positions: &[glam::DVec3]) -> Vec<Quad64> {
        positions.iter().map(|p| f64::quad_of(*p)).chain(DUMMY.map(Quad64)).collect()
    }

    /// How many vectors faces and loose beams write.
    pub(super) fn slot_count(&self) -> usize {
        self.corners.len() + self.loose_ends.len()
    }
}

/// A list field after field, chunk by chunk, filled up with `filling`.
fn chunks<E, T: Copy, const FIELDS: usize>(
    list: &[E],
    filling: E,
    width: usize,
    fields: impl Fn(&E) -> [T; FIELDS],
) -> Vec<T> {
    let mut laid_out = Vec::with_capacity(list.len().next_multiple_of(width) * FIELDS);
    for chunk in list.chunks(width) {
        let filled = || chunk.iter().chain(std::iter::repeat(&filling)).take(width);
        for field in 0..FIELDS {
            laid_out.extend(filled().map(|element| fields(element)[field]));
        }
    }
    laid_out
}

/// A beam outside any face: its ends; rest length, stiffness and damping.
type Loose = ([u32; 2], [f64; 3]);

/// The triangles with what lies on their sides, and the beams outside any.
fn elements(model: &Model) -> (Vec<Face>, Vec<Loose>) {
    let none = SideId::new(model.creases.len()).0;
    let mut crease_of_side = vec![none; model.beams.len()];
    for (c, crease) in model.creases.iter().enumerate() {
        crease_of_side[crease.side.index()] = SideId::new(c).0;
    }
    let faces = model.mesh.triangles.iter().map(|corners| Face {
        corners: corners.map(|n| n.0),
        creases: [none; 3],
        rest_lengths: [1.0; 3],
        stiffness: [0.0; 3],
        damping: [0.0; 3],
        angles: [0.0; 4],
    });
    let mut faces: Vec<Face> = faces.collect();
    for own in &model.corner_angles {
        let [(cos, sin), (next_cos, next_sin)] = own.rest;
        faces[own.triangle.index()].angles = [cos, sin, next_cos, next_sin];
    }
    let mut loose = Vec::new();
    let beams = model.mesh.sides.iter().zip(&model.beams).zip(damping::coefficients(model)).enumerate();
    for (s, ((side, beam), damping)) in beams {
        let triangles = side.triangles.iter().flatten();
        // Two faces do half of a beam each.
        let part = 1.0 / triangles.clone().count() as f64;
        if part.is_infinite() {
            loose.push((beam.nodes.map(|n| n.0), [beam.rest_length, beam.stiffness, damping]));
        }
        for triangle in triangles {
            let face = &mut faces[triangle.index()];
            let ends = side.nodes.map(|n| n.0);
            let place = (0..3).find(|i| ends.contains(&face.corners[*i]) && ends.contains(&face.corners[(i + 1) % 3]));
            let place = place.expect("a side of a triangle joins two of its corners");
            face.creases[place] = crease_of_side[s];
            face.rest_lengths[place] = beam.rest_length;
            face.stiffness[place] = part * beam.stiffness;
            face.damping[place] = part * damping;
        }
    }
    (faces, loose)
}

/// For each node the slots of its forces: those of faces in their order, then those of loose beams.
fn slots(model: &Model, width: usize, faces: &[Face], loose: &[Loose]) -> (Vec<u32>, Vec<u32>) {
    let nodes = model.node_count();
    // Written side by side, so that threads can share the list out.
    let slot = |e: usize, fields: usize, field: usize| (e / width * fields + field) * width + e % width;
    let first_loose = faces.len().next_multiple_of(width) * 3;
    let of_faces = faces.iter().enumerate().flat_map(|(f, face)| (0..3).map(move |i| (face.corners[i], slot(f, 3, i))));
    let of_loose = loose.iter().enumerate();
    let of_loose = of_loose.flat_map(|(b, (ends, _))| (0..2).map(move |i| (ends[i], first_loose + slot(b, 2, i))));
    let mut free = vec![true; nodes];
    for node in &model.fixed {
        free[node.index()] = false;
    }
    let all: Vec<(u32, usize)> = of_faces.chain(of_loose).filter(|(n, _)| free[*n as usize]).collect();
    let mut rows = vec![0_u32; nodes + 1];
    for (n, _) in &all {
        rows[*n as usize + 1] += 1;
    }
    for n in 0..nodes {
        rows[n + 1] += rows[n];
    }
    let mut next = rows.clone();
    let mut slots = vec![0; all.len()];
    for (n, slot) in all {
        let place = &mut next[n as usize];
        slots[*place as usize] = NodeId::new(slot).0;
        *place += 1;
    }
    (rows, slots)
}
