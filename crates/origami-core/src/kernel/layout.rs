//! A model laid out for the passes: block after block, elements side by side, as many as a lane is wide, field after field.

use std::iter::{empty, repeat};

use crate::csr::Csr;
use crate::ids::NodeId;
use crate::model::{Beam, Model, Softening};

use super::blocks::{Block, Cutter, FILLING, NODES};
use super::lane::row;
use super::of_triangles::OfTriangles;
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
    /// Which one of the model each triangle is; for the filling a number that none has.
    pub(super) triangles: Vec<u32>,
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
    /// Which of the beams outside any triangle each one is; for the filling a number that none has.
    pub(super) loose: Vec<u32>,
    /// By chunk of beams outside any triangle: their two ends.
    pub(super) loose_ends: Vec<u8>,
    /// By the same chunks: rest length, stiffness, damping.
    pub(super) loose_beams: Vec<R>,
    /// By node of a block on which its springs act: how many forces of the block act on it.
    pub(super) counts: Vec<u16>,
    /// Where they lie among the numbers of all forces of the block: those of triangles in their order, then those of loose
    /// beams.
    pub(super) summands: Vec<u16>,
    /// By node: where the forces on it lie, one for each block. The last slot of a node on which something acts from outside
    /// is for that.
    pub(super) slots: Csr<u32>,
    /// By crease of the model: its place among those of the blocks.
    pub(super) place_of_crease: Vec<u32>,
    /// Creases that are in a second block: their place there, and the first one.
    pub(super) copies: Vec<[u32; 2]>,
    pub(super) k_face: R,
    pub(super) k_area: f64,
    /// What pulls a crease back to flat from the side that its target is not on, in units of its stiffness.
    pub(super) wrong_side: f64,
    pub(super) softening: Option<Softening>,
    pub(super) damped: bool,
}

/// Where the elements of a block begin. Those of triangles, creases and loose beams begin with a whole chunk.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Starts {
    pub(super) nodes: usize,
    pub(super) creases: usize,
    pub(super) triangles: usize,
    pub(super) loose: usize,
    pub(super) sums: usize,
    pub(super) summands: usize,
    /// On how many of its nodes its springs act.
    pub(super) acted_on: usize,
}

impl<R: Real> Layout<R> {
    /// Lays `model` out with `width` elements side by side. Its damping, if it has any, is laid out where the motion is `damped`.
    pub(super) fn new(model: &Model, width: usize, damped: bool) -> Self {
        let mut layout = Self {
            nodes: model.node_count(),
            blocks: vec![Starts::default()],
            block_nodes: Vec::new(),
            hinges: Vec::new(),
            stiffness: Vec::new(),
            triangles: Vec::new(),
            corners: Vec::new(),
            creases: Vec::new(),
            beams: Vec::new(),
            damping: Vec::new(),
            angles: Vec::new(),
            loose: Vec::new(),
            loose_ends: Vec::new(),
            loose_beams: Vec::new(),
            counts: Vec::new(),
            summands: Vec::new(),
            slots: Csr::from_entries(0, empty()),
            place_of_crease: vec![u32::MAX; model.creases.len()],
            copies: Vec::new(),
            k_face: R::of(model.material.k_face),
            k_area: model.k_area(),
            wrong_side: 0.0,
            softening: None,
            damped: damped && model.material.zeta > 0.0,
        };
        let springs = OfTriangles::new(model);
        Cutter::new(model, &springs.sides, &springs.loose_ends(model))
            .cut(|block| layout.take(model, &springs, width, &block));
        layout.set_slots(&[]);
        layout
    }

    /// Lays one more block out.
    fn take(&mut self, model: &Model, springs: &OfTriangles, width: usize, block: &Block) {
        if let Some(own) = self.blocks.last_mut() {
            own.acted_on = block.acted_on;
        }
        self.block_nodes.extend(&block.nodes);
        self.take_creases(model, width, block);
        self.take_triangles(model, springs, width, block);
        self.take_loose_beams(model, springs, width, block);
        self.take_sums(width, block);
        self.blocks.push(Starts {
            nodes: self.block_nodes.len(),
            creases: self.stiffness.len(),
            triangles: self.triangles.len(),
            loose: self.loose.len(),
            sums: self.counts.len(),
            summands: self.summands.len(),
            acted_on: 0,
        });
    }

    fn take_creases(&mut self, model: &Model, width: usize, block: &Block) {
        if model.creases.is_empty() {
            return;
        }
        for (crease, place) in block.creases.iter().zip(self.stiffness.len() as u32..) {
            match &mut self.place_of_crease[*crease as usize] {
                none @ &mut u32::MAX => *none = place,
                first => self.copies.push([place, *first]),
            }
        }
        // At least one place is left over: sides without a crease refer to the first one after the last crease.
        let count = (block.creases.len() + 1).next_multiple_of(width);
        lay(&mut self.hinges, (width, count), block.hinges.iter().copied(), [2, 3, 0, 1].map(filling));
        let stiffness = block.creases.iter().map(|c| R::of(model.creases[*c as usize].stiffness));
        self.stiffness.extend(stiffness.chain(repeat(R::of(0.0))).take(count));
    }

    fn take_triangles(&mut self, model: &Model, springs: &OfTriangles, width: usize, block: &Block) {
        let count = block.triangles.len().next_multiple_of(width);
        self.triangles.extend(block.triangles.iter().copied().chain(repeat(u32::MAX)).take(count));
        lay(&mut self.corners, (width, count), block.corners.iter().copied(), [0, 1, 2].map(filling));
        if !model.creases.is_empty() {
            let none = block.creases.len() as u16;
            let on_sides = block.creases_of_sides.iter().map(|sides| sides.map(|crease| crease.unwrap_or(none)));
            lay(&mut self.creases, (width, count), on_sides, [none; 3]);
        }
        let sides = block.triangles.iter().map(|t| springs.sides[*t as usize]);
        let beams = sides.clone().map(|sides| {
            let [[a, k_a], [b, k_b], [c, k_c]] = sides.map(|s| springs.beam(model, s).map(R::of));
            [a, b, c, k_a, k_b, k_c]
        });
        lay(&mut self.beams, (width, count), beams, [1.0, 1.0, 1.0, 0.0, 0.0, 0.0].map(R::of));
        if self.damped {
            let share = |s: u32| R::of(springs.share_of(model, s) * springs.damping[s as usize]);
            lay(&mut self.damping, (width, count), sides.map(|sides| sides.map(share)), [R::of(0.0); 3]);
        }
        if !model.corner_angles.is_empty() {
            let angles = block.triangles.iter().map(|t| springs.angles[*t as usize].map(R::of));
            lay(&mut self.angles, (width, count), angles, [0.5, 0.5, 1.0].map(R::of));
        }
    }

    fn take_loose_beams(&mut self, model: &Model, springs: &OfTriangles, width: usize, block: &Block) {
        let count = block.loose.len().next_multiple_of(width);
        self.loose.extend(block.loose.iter().copied().chain(repeat(u32::MAX)).take(count));
        lay(&mut self.loose_ends, (width, count), block.loose_ends.iter().copied(), [0, 1].map(filling));
        let beams = block.loose.iter().map(|b| {
            let side = springs.loose[*b as usize];
            let [rest, stiffness] = springs.beam(model, side);
            [rest, stiffness, springs.damping[side as usize]].map(R::of)
        });
        lay(&mut self.loose_beams, (width, count), beams, [1.0, 0.0, 0.0].map(R::of));
    }

    fn take_sums(&mut self, width: usize, block: &Block) {
        let of_corners = (0..).zip(&block.corners).flat_map(|(t, corners)| {
            (0..3).zip(corners).map(move |(i, node)| (usize::from(*node), scattered(width, t, (i, 3))))
        });
        let first_loose = 3 * block.triangles.len().next_multiple_of(width);
        let of_ends = (0..).zip(&block.loose_ends).flat_map(|(b, ends)| {
            (0..2).zip(ends).map(move |(i, node)| (usize::from(*node), first_loose + scattered(width, b, (i, 2))))
        });
        // By where the first of its four numbers lies.
        let summands = of_corners.chain(of_ends).map(|(node, place)| (node, 4 * place as u16));
        let summands = Csr::from_entries(block.acted_on, summands);
        self.counts.extend(summands.iter().map(|own| own.len() as u16));
        self.summands.extend(summands.items());
    }

    /// Makes the springs so soft, whatever they were before; they are exactly the model's without.
    pub(super) fn soften(&mut self, model: &Model, width: usize, softening: Option<Softening>) {
        self.softening = softening;
        self.wrong_side = softening.map_or(0.0, |soft| soft.wrong_side);
        self.k_face = R::of(softening.map_or(1.0, |soft| soft.corner_angles) * model.material.k_face);
        let stiffness = |beam: &Beam| softening.map_or(beam.stiffness, |soft| soft.of_beam(model, beam));
        let springs = OfTriangles::new(model);
        let own = |side: u32| R::of(springs.share_of(model, side) * stiffness(&model.beams[side as usize]));
        for (place, triangle) in self.triangles.iter().enumerate() {
            // None for the filling.
            for (i, side) in springs.sides.get(*triangle as usize).into_iter().flatten().enumerate() {
                self.beams[at(width, place, (3 + i, 6))] = own(*side);
            }
        }
        for (place, loose) in self.loose.iter().enumerate() {
            if let Some(side) = springs.loose.get(*loose as usize) {
                self.loose_beams[at(width, place, (1, 3))] = own(*side);
            }
        }
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

/// The place of a node of the filling in its block.
fn filling(i: usize) -> u8 {
    (FILLING + i) as u8
}

/// Where a field, given as one of so many, of element `e` lies: field after field, chunk by chunk.
fn at(width: usize, e: usize, (field, fields): (usize, usize)) -> usize {
    (e / width * fields + field) * width + e % width
}

/// Where the force of element `e` on its node `i` of so many lies.
fn scattered(width: usize, e: usize, (i, nodes): (usize, usize)) -> usize {
    (e / width * nodes + i) * width + row(width, e % width)
}

/// Adds `count` elements in this layout to a list: `elements`, then as many copies of `filling` as there is room for.
fn lay<T: Copy, const FIELDS: usize>(
    list: &mut Vec<T>,
    (width, count): (usize, usize),
    elements: impl Iterator<Item = [T; FIELDS]>,
    filling: [T; FIELDS],
) {
    let (first, mut elements) = (list.len(), elements.chain(repeat(filling)));
    list.resize(first + count * FIELDS, filling[0]);
    for chunk in list[first..].chunks_exact_mut(width * FIELDS) {
        for (side_by_side, element) in elements.by_ref().take(width).enumerate() {
            for (field, value) in element.into_iter().enumerate() {
                chunk[field * width + side_by_side] = value;
            }
        }
    }
}
