//! A model laid out for the passes: block after block, elements side by side, as many as a lane is wide, field after field.

use std::iter::{empty, repeat};

use crate::csr::Csr;
use crate::forces::damping;
use crate::ids::NodeId;
use crate::model::Model;

use super::blocks::{Block, Cutter, FILLING, NODES};
use super::real::Real;

/// Everything about a model that the passes need and that never changes. A list is empty where the model has nothing of its
/// kind.
///
/// The elements of a block are filled up to whole chunks with ones on nodes of their own, which form a sound hinge and pull at
/// nothing.
#[derive(Clone, Debug)]
pub(super) struct Layout<R> {
    pub(super) nodes: usize,
    /// Where the elements of each block begin, and where those of the last one end.
    pub(super) blocks: Vec<Starts>,
    /// The nodes of each block, those first on which its springs act.
    pub(super) block_nodes: Vec<u32>,
    /// By chunk of creases: apexes one and two, ends one and two.
    pub(super) hinges: Vec<u8>,
    /// By crease.
    pub(super) stiffness: Vec<R>,
    /// By chunk of triangles: the three corners.
    pub(super) corners: Vec<u8>,
    /// By chunk of triangles: the block's creases on the sides 0-1, 1-2 and 2-0.
    pub(super) creases: Vec<u16>,
    /// By chunk of triangles: the rest lengths of the sides, then the stiffness of each one's share of the beam.
    pub(super) beams: Vec<R>,
    /// By chunk of triangles: each side's share of the damping.
    pub(super) damping: Vec<R>,
    /// By chunk of triangles: the product of the two sides at the first corner at rest, the same at the second, and the
    /// doubled area; or numbers in their proportion.
    pub(super) angles: Vec<R>,
    /// By chunk of beams outside any triangle: their two ends.
    pub(super) loose_ends: Vec<u8>,
    /// By the same chunks: rest length, stiffness, damping.
    pub(super) loose_beams: Vec<R>,
    /// By node of a block on which its springs act: how many forces of the block these are.
    pub(super) counts: Vec<u16>,
    /// Where they lie among those of the block: those of triangles in their order, then those of loose beams.
    pub(super) forces_of_nodes: Vec<u16>,
    /// By node: where the forces on it lie, one for each block. The last slot of a node on which something acts from outside
    /// is for that.
    pub(super) slots: Csr<u32>,
    /// By crease of the model: its place among those of the blocks.
    pub(super) place_of_crease: Vec<u32>,
    /// Creases that are in a second block: their place there, and the first one.
    pub(super) copies: Vec<[u32; 2]>,
    pub(super) k_face: f64,
    pub(super) damped: bool,
}

/// Where the elements of a block begin. Those of triangles, creases and loose beams begin with a whole chunk.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Starts {
    pub(super) nodes: usize,
    pub(super) creases: usize,
    pub(super) triangles: usize,
    pub(super) loose: usize,
    pub(super) forces: usize,
    /// On how many nodes the springs of all blocks before it act.
    pub(super) acted_on_before: usize,
    /// On how many of its nodes its springs act.
    pub(super) acted_on: usize,
}

/// A hinge and its nodes: ends, then apexes.
pub(super) const DUMMY: [[f64; 4]; 4] =
    [[0.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.5, 1.0, 0.0, 0.0], [0.5, -1.0, 0.0, 0.0]];

impl<R: Real> Layout<R> {
    /// Lays `model` out with `width` elements side by side. Its damping, if it has any, is laid out where the motion is `damped`.
    pub(super) fn new(model: &Model, width: usize, damped: bool) -> Self {
        let mut layout = Self {
            nodes: model.node_count(),
            blocks: vec![Starts::default()],
            block_nodes: Vec::new(),
            hinges: Vec::new(),
            stiffness: Vec::new(),
            corners: Vec::new(),
            creases: Vec::new(),
            beams: Vec::new(),
            damping: Vec::new(),
            angles: Vec::new(),
            loose_ends: Vec::new(),
            loose_beams: Vec::new(),
            counts: Vec::new(),
            forces_of_nodes: Vec::new(),
            slots: Csr::from_entries(0, empty()),
            place_of_crease: vec![u32::MAX; model.creases.len()],
            copies: Vec::new(),
            k_face: model.material.k_face,
            damped: damped && model.material.zeta > 0.0,
        };
        let springs = Springs::new(model);
        let ends: Vec<[u32; 2]> =
            springs.loose.iter().map(|side| model.mesh.sides[*side as usize].nodes.map(|n| n.0)).collect();
        Cutter::new(model, &springs.sides, &ends).cut(|block| layout.take(model, &springs, width, &block));
        layout.set_slots(&[]);
        layout
    }

    /// Lays one more block out.
    fn take(&mut self, model: &Model, springs: &Springs, width: usize, block: &Block) {
        let dummy = |i: usize| (FILLING + i) as u8;
        let (no_hinge, no_face) = ([2, 3, 0, 1].map(dummy), [0, 1, 2].map(dummy));
        let first = self.blocks.last().copied().unwrap_or_default();

        // At least one place is left over: sides without a crease refer to the first one after the last crease.
        let creases = if model.creases.is_empty() { 0 } else { (block.creases.len() + 1).next_multiple_of(width) };
        self.hinges.extend(chunks(width, creases, block.hinges.iter().copied(), no_hinge));
        let stiffness = block.creases.iter().map(|c| R::of(model.creases[*c as usize].stiffness));
        self.stiffness.extend(stiffness.chain(repeat(R::of(0.0))).take(creases));
        for (crease, place) in block.creases.iter().zip(first.creases as u32..) {
            match &mut self.place_of_crease[*crease as usize] {
                none @ &mut u32::MAX => *none = place,
                own => self.copies.push([place, *own]),
            }
        }

        let faces = block.triangles.len().next_multiple_of(width);
        self.corners.extend(chunks(width, faces, block.corners.iter().copied(), no_face));
        let none = block.creases.len() as u16;
        let on_sides = block.creases_of_sides.iter().map(|sides| sides.map(|crease| crease.unwrap_or(none)));
        self.creases.extend(chunks(width, if creases > 0 { faces } else { 0 }, on_sides, [none; 3]));
        let sides = block.triangles.iter().map(|t| springs.sides[*t as usize]);
        let beams = sides.clone().map(|sides| {
            let [[a, k_a], [b, k_b], [c, k_c]] = sides.map(|s| springs.beam(model, s).map(R::of));
            [a, b, c, k_a, k_b, k_c]
        });
        self.beams.extend(chunks(width, faces, beams, [1.0, 1.0, 1.0, 0.0, 0.0, 0.0].map(R::of)));
        let damping = sides.map(|sides| sides.map(|s| R::of(springs.share_of(model, s) * springs.damping[s as usize])));
        self.damping.extend(chunks(width, if self.damped { faces } else { 0 }, damping, [R::of(0.0); 3]));
        let angles = block.triangles.iter().map(|t| springs.angles[*t as usize].map(R::of));
        let with_angles = if model.corner_angles.is_empty() { 0 } else { faces };
        self.angles.extend(chunks(width, with_angles, angles, [0.5, 0.5, 1.0].map(R::of)));

        let loose = block.loose.len().next_multiple_of(width);
        self.loose_ends.extend(chunks(width, loose, block.loose_ends.iter().copied(), [dummy(0), dummy(1)]));
        let beams = block.loose.iter().map(|b| {
            let side = springs.loose[*b as usize];
            let [rest, stiffness] = springs.beam(model, side);
            [rest, stiffness, springs.damping[side as usize]].map(R::of)
        });
        self.loose_beams.extend(chunks(width, loose, beams, [1.0, 0.0, 0.0].map(R::of)));

        let of_faces = block
            .corners
            .iter()
            .enumerate()
            .flat_map(|(t, corners)| (0..3).map(move |i| (corners[i], at(width, t, (i, 3)))));
        let of_loose = block
            .loose_ends
            .iter()
            .enumerate()
            .flat_map(|(b, ends)| (0..2).map(move |i| (ends[i], 3 * faces + at(width, b, (i, 2)))));
        let forces = of_faces.chain(of_loose).map(|(node, place)| (usize::from(node), place as u16));
        let forces = Csr::from_entries(block.acted_on, forces);
        self.counts.extend(forces.iter().map(|own| own.len() as u16));
        self.forces_of_nodes.extend(forces.items());

        self.block_nodes.extend(&block.nodes);
        if let Some(own) = self.blocks.last_mut() {
            own.acted_on = block.acted_on;
        }
        self.blocks.push(Starts {
            nodes: self.block_nodes.len(),
            creases: first.creases + creases,
            triangles: first.triangles + faces,
            loose: first.loose + loose,
            forces: self.forces_of_nodes.len(),
            acted_on_before: self.counts.len(),
            acted_on: 0,
        });
    }

    /// Gives each node a slot in each of its blocks, then each of those `outside`, which are in order, one more.
    pub(super) fn set_slots(&mut self, outside: &[u32]) {
        let block_nodes = &self.block_nodes;
        let of_block = |(b, block): (usize, &Starts)| {
            let own = &block_nodes[block.nodes..][..block.acted_on];
            own.iter().zip(b * NODES..).map(|(node, slot)| (*node, slot))
        };
        let of_blocks = self.blocks.iter().enumerate().flat_map(of_block);
        let of_outside = outside.iter().copied().zip(self.slot_count()..);
        let all = of_blocks.chain(of_outside).map(|(node, slot)| (node as usize, NodeId::new(slot).0));
        self.slots = Csr::from_entries(self.nodes, all);
    }

    /// Writes a number of each crease of the model to its place in each of its blocks.
    pub(super) fn by_crease(&self, numbers: impl Iterator<Item = f64>, to: &mut [R]) {
        for (number, place) in numbers.zip(&self.place_of_crease) {
            to[*place as usize] = R::of(number);
        }
        for [copy, first] in &self.copies {
            to[*copy as usize] = to[*first as usize];
        }
    }

    /// How many vectors the blocks have room for.
    pub(super) fn slot_count(&self) -> usize {
        NODES * (self.blocks.len() - 1)
    }
}

/// The springs of a model by triangle and side.
struct Springs {
    /// By triangle: the sides 0-1, 1-2 and 2-0.
    sides: Vec<[u32; 3]>,
    /// Sides outside any triangle.
    loose: Vec<u32>,
    /// By side.
    damping: Vec<f64>,
    /// By triangle: cotangents of the first angle at rest and of the second, and 1; zeros where it has no springs there.
    angles: Vec<[f64; 3]>,
}

impl Springs {
    fn new(model: &Model) -> Self {
        let triangles = &model.mesh.triangles;
        let (mut sides, mut loose) = (vec![[0; 3]; triangles.len()], Vec::new());
        for (side, s) in model.mesh.sides.iter().zip(0_u32..) {
            if side.triangles == [None; 2] {
                loose.push(s);
            }
            for triangle in side.triangles.iter().flatten() {
                let corners = &triangles[triangle.index()];
                let is_here =
                    |i: &usize| side.nodes.contains(&corners[*i]) && side.nodes.contains(&corners[(i + 1) % 3]);
                let corner = (0..3).find(is_here).expect("a side of a triangle joins two of its corners");
                sides[triangle.index()][corner] = s;
            }
        }
        let mut angles = vec![[0.0; 3]; if model.corner_angles.is_empty() { 0 } else { triangles.len() }];
        for own in &model.corner_angles {
            let [a, b] = own.rest.map(|(cos, sin)| cos / sin);
            angles[own.triangle.index()] = [a, b, 1.0];
        }
        Self { sides, loose, damping: damping::coefficients(model), angles }
    }

    /// The part of a beam that each triangle at it does: each of two does half.
    fn share_of(&self, model: &Model, side: u32) -> f64 {
        1.0 / model.mesh.sides[side as usize].triangles.iter().flatten().count().max(1) as f64
    }

    /// Rest length, and the stiffness of each triangle's share.
    fn beam(&self, model: &Model, side: u32) -> [f64; 2] {
        let beam = &model.beams[side as usize];
        [beam.rest_length, self.share_of(model, side) * beam.stiffness]
    }
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
