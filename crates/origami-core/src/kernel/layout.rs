//! A model laid out for the passes: elements side by side, as many as a lane is wide, field after field.

use std::iter::{empty, repeat, repeat_n};

use crate::csr::Csr;
use crate::forces::damping;
use crate::ids::{NodeId, SideId};
use crate::model::{Beam, Model, Softening};

use super::lookup::fill;
use super::real::{Quad64, Real};

/// Everything about a model that the passes need and that never changes. A list is empty where the model has nothing of its
/// kind.
///
/// Elements are filled up to whole chunks with ones on nodes of their own, which form a sound hinge and pull at nothing.
#[derive(Clone, Debug)]
pub(super) struct Layout<R> {
    pub(super) nodes: usize,
    /// By chunk of creases: apexes one and two, ends one and two.
    pub(super) hinges: Vec<u32>,
    /// By crease.
    pub(super) stiffness: Vec<R>,
    /// By chunk of triangles: the three corners.
    pub(super) corners: Vec<u32>,
    /// By chunk of triangles: the creases on the sides 0-1, 1-2 and 2-0.
    pub(super) creases: Vec<u32>,
    /// By chunk of triangles: the rest lengths of the sides, then the stiffness of each one's share of the beam.
    pub(super) beams: Vec<R>,
    /// By chunk of triangles: each side's share of the damping.
    pub(super) damping: Vec<R>,
    /// By chunk of triangles: cosine and sine of the first angle at rest and of the second.
    pub(super) angles: Vec<R>,
    /// By chunk of beams outside any triangle: their two ends.
    pub(super) loose_ends: Vec<u32>,
    /// By the same chunks: rest length, stiffness, damping.
    pub(super) loose_beams: Vec<R>,
    /// By node: where the forces on it lie. The last slot of a node on which something acts from outside is for that.
    pub(super) slots: Csr<u32>,
    pub(super) k_face: f64,
    pub(super) k_area: f64,
    pub(super) softening: Option<Softening>,
    pub(super) damped: bool,
}

/// A hinge and its nodes: ends, then apexes.
const DUMMY: [[f64; 4]; 4] = [[0.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.5, 1.0, 0.0, 0.0], [0.5, -1.0, 0.0, 0.0]];

impl<R: Real> Layout<R> {
    /// Lays `model` out with `width` elements side by side. Its damping, if it has any, is laid out where the motion is `damped`.
    pub(super) fn new(model: &Model, width: usize, damped: bool) -> Self {
        let nodes = model.node_count();
        // The nodes of the filling come after those of the sheet.
        let dummy = |i: usize| NodeId::new(nodes + i).0;
        let no_hinge = [dummy(2), dummy(3), dummy(0), dummy(1)];
        // At least one place is left over: sides without a crease refer to the first one after the last crease.
        let creases = if model.creases.is_empty() { 0 } else { (model.creases.len() + 1).next_multiple_of(width) };
        let hinges = model.creases.iter().map(|crease| crease.nodes.map(|n| n.0));
        let mut stiffness: Vec<R> = model.creases.iter().map(|crease| R::of(crease.stiffness)).collect();
        stiffness.resize(creases, R::of(0.0));

        let damped = damped && model.material.zeta > 0.0;
        let faces = model.mesh.triangles.len().next_multiple_of(width);
        let corners = model.mesh.triangles.iter().map(|corners| corners.map(|n| n.0));
        let no_face = [dummy(0), dummy(1), dummy(2)];
        let no_creases = [SideId::new(model.creases.len()).0; 3];
        let no_beams = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0].map(R::of);
        let loose: Vec<Loose> = loose(model).collect();
        let loose_beams = loose.len().next_multiple_of(width);
        let ends = loose.iter().map(|(ends, _)| *ends);
        let beams = loose.iter().map(|(_, beam)| beam.map(R::of));
        let slots = slots(model, width, &loose, &[]);
        let mut layout = Self {
            nodes,
            hinges: chunks(width, creases, hinges, no_hinge),
            stiffness,
            corners: chunks(width, faces, corners, no_face),
            creases: chunks(width, if creases > 0 { faces } else { 0 }, empty(), no_creases),
            beams: chunks(width, faces, empty(), no_beams),
            damping: chunks(width, if damped { faces } else { 0 }, empty(), [R::of(0.0); 3]),
            angles: angles(model, width),
            loose_ends: chunks(width, loose_beams, ends, [dummy(0), dummy(1)]),
            loose_beams: chunks(width, loose_beams, beams, [1.0, 0.0, 0.0].map(R::of)),
            slots,
            k_face: model.material.k_face,
            k_area: model.k_area(),
            softening: None,
            damped,
        };
        layout.take_sides(model, width);
        layout
    }

    /// Fills in the beams, creases and damping on the sides of the triangles.
    fn take_sides(&mut self, model: &Model, width: usize) {
        let mut crease_of_side = vec![SideId::new(model.creases.len()).0; model.beams.len()];
        for (c, crease) in model.creases.iter().enumerate() {
            crease_of_side[crease.side.index()] = SideId::new(c).0;
        }
        let beams = model.beams.iter().zip(damping::coefficients(model)).zip(crease_of_side);
        for (side, ((beam, damping), crease)) in model.mesh.sides.iter().zip(beams) {
            let triangles = side.triangles.iter().flatten();
            // Each of two triangles does half of the beam between them.
            let part = 1.0 / triangles.clone().count() as f64;
            for triangle in triangles {
                let t = triangle.index();
                let corner = corner_of(&model.mesh.triangles[t], side.nodes);
                self.beams[at(width, t, (corner, 6))] = R::of(beam.rest_length);
                self.beams[at(width, t, (3 + corner, 6))] = R::of(part * beam.stiffness);
                if !self.creases.is_empty() {
                    self.creases[at(width, t, (corner, 3))] = crease;
                }
                if !self.damping.is_empty() {
                    self.damping[at(width, t, (corner, 3))] = R::of(part * damping);
                }
            }
        }
    }

    /// Makes the springs so soft, whatever they were before; they are exactly the model's without softening.
    pub(super) fn soften(&mut self, model: &Model, width: usize, softening: Option<Softening>) {
        self.softening = softening;
        self.k_face = softening.map_or(1.0, |soft| soft.corner_angles) * model.material.k_face;
        let own = |beam: &Beam| softening.map_or(beam.stiffness, |soft| soft.of_beam(model, beam));
        for (side, beam) in model.mesh.sides.iter().zip(&model.beams) {
            let triangles = side.triangles.iter().flatten();
            let stiffness = own(beam) / triangles.clone().count() as f64;
            for triangle in triangles {
                let field = 3 + corner_of(&model.mesh.triangles[triangle.index()], side.nodes);
                self.beams[at(width, triangle.index(), (field, 6))] = R::of(stiffness);
            }
        }
        for (b, (beam, _)) in loose_sides(model).enumerate() {
            self.loose_beams[at(width, b, (1, 3))] = R::of(own(beam));
        }
    }

    /// The positions of all nodes, then those of the filling: as many as [`lookup::item`](super::lookup::item) needs.
    pub(super) fn padded_positions(&self, positions: &[glam::DVec3]) -> Vec<Quad64> {
        let mut padded: Vec<Quad64> = positions.iter().map(|p| f64::quad_of(*p)).chain(DUMMY.map(Quad64)).collect();
        fill(&mut padded);
        padded
    }

    /// Gives each of these nodes, which are in order, one more slot, beyond those of triangles and loose beams.
    pub(super) fn add_slots(&mut self, model: &Model, width: usize, outside: &[u32]) {
        let loose: Vec<Loose> = loose(model).collect();
        self.slots = slots(model, width, &loose, outside);
    }

    /// How many vectors triangles and loose beams write.
    pub(super) fn slot_count(&self) -> usize {
        self.corners.len() + self.loose_ends.len()
    }
}

/// The place among a triangle's corners of the first one on a side.
fn corner_of(corners: &[NodeId; 3], side: [NodeId; 2]) -> usize {
    let corner = (0..3).find(|i| side.contains(&corners[*i]) && side.contains(&corners[(i + 1) % 3]));
    corner.expect("a side of a triangle joins two of its corners")
}

/// Where a field, given as one of so many, of element `e` lies: field after field, chunk by chunk.
fn at(width: usize, e: usize, (field, fields): (usize, usize)) -> usize {
    (e / width * fields + field) * width + e % width
}

/// `count` elements in this layout: `elements`, then as many copies of `filling` as there is room for.
fn chunks<T: Copy, const FIELDS: usize>(
    width: usize,
    count: usize,
    elements: impl Iterator<Item = [T; FIELDS]>,
    filling: [T; FIELDS],
) -> Vec<T> {
    let mut laid_out = vec![filling[0]; count * FIELDS];
    for (e, element) in elements.chain(repeat(filling)).take(count).enumerate() {
        for (field, value) in element.into_iter().enumerate() {
            laid_out[at(width, e, (field, FIELDS))] = value;
        }
    }
    laid_out
}

/// Cosine and sine of the first angle of each triangle and of the second; none where no triangle has springs there.
fn angles<R: Real>(model: &Model, width: usize) -> Vec<R> {
    let faces = if model.corner_angles.is_empty() { 0 } else { model.mesh.triangles.len() };
    let without = repeat_n([R::of(0.0); 4], faces);
    let mut angles = chunks(width, faces.next_multiple_of(width), without, [1.0, 0.0, 1.0, 0.0].map(R::of));
    for own in &model.corner_angles {
        let [(cos, sin), (next_cos, next_sin)] = own.rest;
        for (field, value) in [cos, sin, next_cos, next_sin].into_iter().enumerate() {
            angles[at(width, own.triangle.index(), (field, 4))] = R::of(value);
        }
    }
    angles
}

/// A beam outside any triangle: its ends; rest length, stiffness and damping.
type Loose = ([u32; 2], [f64; 3]);

fn loose(model: &Model) -> impl Iterator<Item = Loose> {
    let damping = damping::coefficients(model);
    let numbers = move |(beam, side): (&Beam, usize)| [beam.rest_length, beam.stiffness, damping[side]];
    loose_sides(model).map(move |(beam, side)| (beam.nodes.map(|n| n.0), numbers((beam, side))))
}

/// Beams outside any triangle, each with the number of its side.
fn loose_sides(model: &Model) -> impl Iterator<Item = (&Beam, usize)> {
    let sides = model.mesh.sides.iter().zip(&model.beams).enumerate();
    sides.filter(|(_, (side, _))| side.triangles == [None; 2]).map(|(s, (_, beam))| (beam, s))
}

/// For each node the slots of its forces: those of triangles in their order, then those of loose beams, then one for each of
/// the nodes in `outside`.
fn slots(model: &Model, width: usize, loose: &[Loose], outside: &[u32]) -> Csr<u32> {
    let nodes = model.node_count();
    let triangles = model.mesh.triangles.iter().enumerate();
    let first_loose = triangles.len().next_multiple_of(width) * 3;
    let first_outside = first_loose + loose.len().next_multiple_of(width) * 2;
    let of_faces = triangles.flat_map(|(t, corners)| (0..3).map(move |i| (corners[i].index(), at(width, t, (i, 3)))));
    let of_loose = loose
        .iter()
        .enumerate()
        .flat_map(|(b, (ends, _))| (0..2).map(move |i| (ends[i] as usize, first_loose + at(width, b, (i, 2)))));
    let of_outside = outside.iter().enumerate().map(|(i, node)| (*node as usize, first_outside + i));
    let all = of_faces.chain(of_loose).chain(of_outside);
    Csr::from_entries(nodes, all.map(|(n, slot)| (n, NodeId::new(slot).0)))
}
