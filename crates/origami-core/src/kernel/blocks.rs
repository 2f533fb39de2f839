//! A sheet cut into blocks of neighbouring springs. All that a block touches fits into the fastest memory, eight bits name a
//! node of it, and what its springs do to a node is summed before it leaves.
//!
//! Where a sheet is cut depends on the sheet alone: so sums have one order, whoever computes them.

use glam::DVec3;

use crate::model::Model;

/// Room for the nodes of a block: as many as eight bits tell apart, so that no index has to be looked at.
pub(super) const NODES: usize = 256;
/// The last ones are not of the sheet: what fills a block up to whole chunks stands on them.
pub(super) const FILLING: usize = NODES - 4;
/// Room for the creases of a block: three for each triangle, and the filling.
pub(super) const CREASES: usize = 1024;
/// Room for the forces in a block: three for each triangle, two for each loose beam, and the filling.
pub(super) const FORCES: usize = 1024;
/// Triangles and loose beams of a block, at most. With more, a compact block has too many nodes and is halved; with fewer, more
/// nodes belong to several blocks.
const ELEMENTS: usize = 320;

/// One block. Nodes and creases are named by their places in its own lists.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Block {
    /// Those on which its springs act, in order; then those that only its creases look at.
    pub(super) nodes: Vec<u32>,
    /// How many its springs act on.
    pub(super) acted_on: usize,
    /// In order.
    pub(super) triangles: Vec<u32>,
    pub(super) corners: Vec<[u8; 3]>,
    /// By triangle: the creases on the sides 0-1, 1-2 and 2-0; [`None`] where there is none.
    pub(super) creases_of_sides: Vec<[Option<u16>; 3]>,
    /// Beams outside any triangle, by their place among these; in order.
    pub(super) loose: Vec<u32>,
    pub(super) loose_ends: Vec<[u8; 2]>,
    /// All creases on its triangles, in order. One between two blocks is in both, and turns in both alike.
    pub(super) creases: Vec<u32>,
    /// Apexes one and two, ends one and two.
    pub(super) hinges: Vec<[u8; 4]>,
}

/// What there is to be cut.
pub(super) struct Cutter<'a> {
    model: &'a Model,
    /// By triangle: the sides 0-1, 1-2 and 2-0.
    sides: &'a [[u32; 3]],
    /// By side.
    crease_of_side: Vec<Option<u32>>,
    /// Ends of the beams outside any triangle.
    loose: &'a [[u32; 2]],
    /// Triangles, then loose beams.
    centres: Vec<DVec3>,
    nodes: Numbering,
    creases: Numbering,
}

impl<'a> Cutter<'a> {
    pub(super) fn new(model: &'a Model, sides: &'a [[u32; 3]], loose: &'a [[u32; 2]]) -> Self {
        let mut crease_of_side = vec![None; model.mesh.sides.len()];
        for (crease, c) in model.creases.iter().zip(0..) {
            crease_of_side[crease.side.index()] = Some(c);
        }
        let triangles =
            model.mesh.triangles.iter().map(|t| t.iter().map(|n| model.rest[n.index()]).sum::<DVec3>() / 3.0);
        let beams = loose.iter().map(|ends| ends.iter().map(|n| model.rest[*n as usize]).sum::<DVec3>() / 2.0);
        let (nodes, creases) = (Numbering::new(model.node_count()), Numbering::new(model.creases.len()));
        Self { model, sides, crease_of_side, loose, centres: triangles.chain(beams).collect(), nodes, creases }
    }

    /// Hands over one block after the other.
    pub(super) fn cut(mut self, mut take: impl FnMut(Block)) {
        let mut elements: Vec<u32> = self.centres.iter().zip(0..).map(|(_, e)| e).collect();
        let parts = elements.len().div_ceil(ELEMENTS);
        if parts > 0 {
            self.halve(&mut elements, parts, &mut take);
        }
    }

    /// Cuts `elements` into about so many parts of one size: each time in two, across where they extend farthest.
    fn halve(&mut self, elements: &mut [u32], parts: usize, take: &mut impl FnMut(Block)) {
        if parts < 2 {
            elements.sort_unstable();
            match self.block(elements) {
                Some(block) => return take(block),
                // A single element always fits.
                None => return self.halve(elements, 2, take),
            }
        }
        let first = parts / 2;
        let at = (elements.len() * first / parts).max(1);
        let axis = widest(elements.iter().map(|e| self.centres[*e as usize]));
        let place = |e: &u32| self.centres[*e as usize][axis];
        elements.select_nth_unstable_by(at, |a, b| place(a).total_cmp(&place(b)).then(a.cmp(b)));
        let (one, other) = elements.split_at_mut(at);
        self.halve(one, first, take);
        self.halve(other, parts - first, take);
    }

    /// The block of `elements`, which are in order; none where it would have too many nodes or creases.
    fn block(&mut self, elements: &[u32]) -> Option<Block> {
        let Self { model, sides, crease_of_side, loose, nodes, creases, .. } = self;
        let of_triangles = elements.partition_point(|e| (*e as usize) < sides.len());
        let (triangles, beams) = elements.split_at(of_triangles);
        let beams: Vec<u32> = beams.iter().map(|e| e - sides.len() as u32).collect();
        let corners = |t: &u32| model.mesh.triangles[*t as usize].map(|n| n.0);

        nodes.begin();
        triangles.iter().flat_map(corners).for_each(|n| nodes.add(n));
        beams.iter().flat_map(|b| loose[*b as usize]).for_each(|n| nodes.add(n));
        let acted_on = nodes.number();
        creases.begin();
        let on_sides = |t: &u32| sides[*t as usize].map(|side| crease_of_side[side as usize]);
        triangles.iter().flat_map(on_sides).flatten().for_each(|c| creases.add(c));
        creases.number();
        let hinge = |c: &u32| model.creases[*c as usize].nodes.map(|n| n.0);
        creases.list.iter().flat_map(hinge).for_each(|n| nodes.add(n));
        // Filled up to whole chunks, with at least one place left over.
        if nodes.number() > FILLING || creases.list.len() + 16 > CREASES {
            return None;
        }
        let node = |n: u32| u8::try_from(nodes.place(n)).unwrap_or(u8::MAX);
        Some(Block {
            acted_on,
            corners: triangles.iter().map(|t| corners(t).map(node)).collect(),
            creases_of_sides: triangles.iter().map(|t| on_sides(t).map(|c| c.map(|c| creases.place(c)))).collect(),
            loose_ends: beams.iter().map(|b| loose[*b as usize].map(node)).collect(),
            hinges: creases.list.iter().map(|c| hinge(c).map(node)).collect(),
            nodes: nodes.list.clone(),
            triangles: triangles.to_vec(),
            loose: beams,
            creases: creases.list.clone(),
        })
    }
}

/// The axis along which points extend farthest.
fn widest(points: impl Iterator<Item = DVec3>) -> usize {
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    points.for_each(|p| (low, high) = (low.min(p), high.max(p)));
    (high - low).max_position()
}

/// Numbers things in the order in which they are asked for, again and again, without looking at all of them each time.
struct Numbering {
    list: Vec<u32>,
    /// By thing: the block in which it was last listed, and its place there.
    places: Vec<(u32, u16)>,
    block: u32,
    numbered: usize,
}

impl Numbering {
    fn new(things: usize) -> Self {
        Self { list: Vec::new(), places: vec![(0, 0); things], block: 0, numbered: 0 }
    }

    fn begin(&mut self) {
        self.list.clear();
        (self.block, self.numbered) = (self.block + 1, 0);
    }

    /// Lists a thing, if it is not listed yet.
    fn add(&mut self, thing: u32) {
        let place = &mut self.places[thing as usize];
        if place.0 != self.block {
            place.0 = self.block;
            self.list.push(thing);
        }
    }

    /// Gives what was listed since the last time its places, in order; the result is how many there are in all.
    fn number(&mut self) -> usize {
        self.list[self.numbered..].sort_unstable();
        for (thing, place) in self.list.iter().zip(0..=u16::MAX).skip(self.numbered) {
            self.places[*thing as usize].1 = place;
        }
        self.numbered = self.list.len();
        self.numbered
    }

    fn place(&self, thing: u32) -> u16 {
        self.places[thing as usize].1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::{catalog, miura};
    use crate::kernel::of_triangles::OfTriangles;
    use crate::model::Material;

    fn blocks(model: &Model) -> Vec<Block> {
        let springs = OfTriangles::new(model);
        let mut blocks = Vec::new();
        Cutter::new(model, &springs.sides, &springs.loose_ends(model)).cut(|block| blocks.push(block));
        blocks
    }

    /// Each block says of its triangles and creases what the mesh says of them, and has room for all.
    fn check(model: &Model, blocks: &[Block]) {
        let mut triangles: Vec<u32> = blocks.iter().flat_map(|block| block.triangles.clone()).collect();
        triangles.sort_unstable();
        assert!(triangles.iter().copied().eq(0..model.mesh.triangles.len() as u32), "each triangle once");
        for block in blocks {
            let node = |place: u8| block.nodes[usize::from(place)];
            assert!(block.nodes.len() <= FILLING && block.creases.len() + 16 <= CREASES);
            assert!(
                3 * block.triangles.len().next_multiple_of(16) + 2 * block.loose.len().next_multiple_of(16) <= FORCES
            );
            assert!(block.corners.iter().flatten().all(|place| usize::from(*place) < block.acted_on));
            for (t, corners) in block.triangles.iter().zip(&block.corners) {
                assert_eq!(corners.map(node), model.mesh.triangles[*t as usize].map(|n| n.0));
            }
            for (c, hinge) in block.creases.iter().zip(&block.hinges) {
                assert_eq!(hinge.map(node), model.creases[*c as usize].nodes.map(|n| n.0));
            }
            for (corners, creases) in block.corners.iter().zip(&block.creases_of_sides) {
                for (i, crease) in creases.iter().enumerate() {
                    let Some(crease) = crease else { continue };
                    let ends = &block.hinges[usize::from(*crease)][2..];
                    assert!(ends.contains(&corners[i]) && ends.contains(&corners[(i + 1) % 3]));
                }
            }
        }
    }

    #[test]
    fn every_triangle_is_in_one_block_that_has_room_for_it() {
        for name in catalog::names() {
            let pattern = catalog::generate(name, &[]).expect("default parameters");
            let model = Model::new(&pattern, &Material::default()).expect("a model");
            check(&model, &blocks(&model));
        }
        let model = Model::new(&miura(60, 40).expect("valid"), &Material::default()).expect("a model");
        let all = blocks(&model);
        check(&model, &all);
        let acted_on: usize = all.iter().map(|block| block.acted_on).sum();
        assert!(all.len() > 14 && acted_on < model.node_count() * 5 / 4, "{} blocks, {acted_on} nodes", all.len());
    }

    #[test]
    fn a_wheel_of_many_spokes_is_cut_into_blocks_that_share_its_hub() {
        let spokes = 2_000;
        let angle = |i: usize| std::f64::consts::TAU * i as f64 / spokes as f64;
        let mut pattern = crate::pattern::CreasePattern::default();
        pattern.vertices.push(DVec3::ZERO);
        pattern.vertices.extend((0..spokes).map(|i| DVec3::new(angle(i).cos(), angle(i).sin(), 0.0)));
        let vertex = crate::ids::VertexId::new;
        let face = |i: usize| vec![vertex(0), vertex(1 + i), vertex(1 + (i + 1) % spokes)];
        pattern.faces = (0..spokes).map(face).collect();
        let model = Model::new(&pattern, &Material::default()).expect("a model");
        let all = blocks(&model);
        check(&model, &all);
        let hub = model.node(vertex(0)).expect("a corner of all faces").0;
        assert!(all.len() >= 8 && all.iter().all(|block| block.nodes.contains(&hub)), "{} blocks", all.len());
    }
}
