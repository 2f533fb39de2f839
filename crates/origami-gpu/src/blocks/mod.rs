//! A sheet in blocks, each the work of one workgroup: some nodes of its own, and all that pulls at them.

mod lists;
mod partition;

use glam::DVec3;
use origami_core::csr::Csr;

use crate::sheet_arrays::SheetArrays;
use lists::Lists;

/// Workgroup memory that every WebGPU device has, in bytes.
pub(crate) const MEMORY: usize = 16_384;

/// Nodes that a byte tells apart.
const MOST_NODES: usize = 256;

/// Invocations of the workgroup of a block. Not measured on hardware: with these, some twenty words of memory fall to each.
pub(crate) const INVOCATIONS: u32 = 128;

/// Nodes of its own that a block is first tried with, the fewest, and by how many fewer each time.
const NODES: usize = 112;
const FEWEST: usize = 40;
const FEWER: usize = 8;

/// The most of each that any block needs room for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Room {
    /// Nodes that are read, its own among them.
    pub(crate) nodes: usize,
    pub(crate) creases: usize,
    /// Forces on corners of triangles and ends of loose beams.
    pub(crate) slots: usize,
}

impl Room {
    fn of(lists: &Lists) -> Self {
        Self {
            nodes: lists.nodes.len(),
            // An array of no length is not allowed.
            creases: lists.creases.max(1),
            slots: (3 * lists.faces.len() + 2 * lists.loose.len()).max(INVOCATIONS as usize),
        }
    }

    fn or(self, other: Self) -> Self {
        Self {
            nodes: self.nodes.max(other.nodes),
            creases: self.creases.max(other.creases),
            slots: self.slots.max(other.slots),
        }
    }

    /// Bytes of workgroup memory: a position in two parts, a moment, a force, and whether the sheet goes on.
    pub(crate) fn memory(self) -> usize {
        24 * self.nodes + 4 * self.creases + 12 * self.slots + 4
    }

    /// The same of a whole sheet with `words` of lists, each node of which has an invocation: a velocity, a fold angle and two
    /// targets besides, and a sum of four numbers.
    pub(crate) fn memory_of_whole(self, words: usize, invocations: usize) -> usize {
        self.memory() + 12 * self.nodes + 12 * self.creases + 4 * words + 16 * invocations
    }
}

/// The blocks of a sheet as the shaders read them.
#[derive(Clone, Debug)]
pub(crate) struct Blocks {
    /// As `shaders/src/block.wgsl` tells.
    pub(crate) words: Vec<u32>,
    pub(crate) extent: Extent,
    pub(crate) copies: Copies,
}

/// How many blocks there are, and what they take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Extent {
    pub(crate) count: usize,
    pub(crate) room: Room,
    /// Nodes that all of them read together.
    pub(crate) positions: usize,
    /// The same of those whose velocities are read where there is damping.
    pub(crate) velocities: usize,
}

/// Each block has its own copy of the state of a crease: which crease each copy is of.
#[derive(Clone, Debug, Default)]
pub(crate) struct Copies {
    /// By copy.
    pub(crate) of: Vec<u32>,
    /// By crease: one of its copies. All are the same: every block computes the same from the same.
    one: Vec<u32>,
}

impl Copies {
    fn new(of: Vec<u32>, creases: usize) -> Self {
        let mut one = vec![0; creases];
        for (copy, crease) in (0..).zip(&of) {
            one[*crease as usize] = copy;
        }
        Self { of, one }
    }

    /// How many creases there are.
    pub(crate) fn creases(&self) -> usize {
        self.one.len()
    }

    /// From a value for each crease to one for each copy.
    pub(crate) fn spread<T: Copy>(&self, by_crease: &[T]) -> Vec<T> {
        self.of.iter().map(|crease| by_crease[*crease as usize]).collect()
    }

    /// And back.
    pub(crate) fn collect<T: Copy>(&self, by_copy: &[T]) -> Vec<T> {
        self.one.iter().map(|copy| by_copy[*copy as usize]).collect()
    }
}

/// Which elements there are at each node.
pub(crate) struct AtNodes {
    faces: Csr<u32>,
    loose: Csr<u32>,
}

impl AtNodes {
    fn new(arrays: &SheetArrays) -> Self {
        let faces = (0_u32..).zip(&arrays.faces).flat_map(|(f, face)| face.nodes.map(|n| (n as usize, f)));
        let loose = (0_u32..).zip(&arrays.loose_beams).flat_map(|(l, beam)| beam.nodes.map(|n| (n as usize, l)));
        Self { faces: Csr::from_entries(arrays.nodes, faces), loose: Csr::from_entries(arrays.nodes, loose) }
    }
}

impl Blocks {
    /// The blocks of a sheet; `None` where so much pulls at one node that no workgroup holds it.
    pub(crate) fn new(arrays: &SheetArrays) -> Option<Self> {
        let at_nodes = AtNodes::new(arrays);
        let lists = |own: Vec<u32>| {
            let lists = Lists::new(arrays, &at_nodes, own);
            if is_held(&lists) { Ok(lists) } else { Err(lists.own()) }
        };
        let in_parts = |size: usize| partition::parts(&arrays.rest, arrays.nodes.div_ceil(size)).into_iter().map(lists);
        let sizes = (FEWEST..=NODES).rev().step_by(FEWER);
        let held = sizes.into_iter().find_map(|size| in_parts(size).collect::<Result<Vec<Lists>, _>>().ok());
        if let Some(parts) = held {
            return Some(Self::of_lists(arrays, &parts));
        }
        let mut parts = Vec::new();
        for part in in_parts(FEWEST) {
            match part {
                Ok(lists) => parts.push(lists),
                Err(own) => halved(arrays, &at_nodes, own, &mut parts)?,
            }
        }
        Some(Self::of_lists(arrays, &parts))
    }

    /// The whole sheet as one block; `None` where there are more elements than the widths of indices hold.
    pub(crate) fn whole(arrays: &SheetArrays) -> Option<Self> {
        let all = (0..).take(arrays.nodes).collect();
        // More would not be held: no need to list them.
        let lists = (arrays.nodes <= MOST_NODES).then(|| Lists::new(arrays, &AtNodes::new(arrays), all))?;
        fits_indices(&lists).then(|| Self::of_lists(arrays, &[lists]))
    }

    fn of_lists(arrays: &SheetArrays, parts: &[Lists]) -> Self {
        let copies: Vec<u32> = parts.iter().flat_map(Lists::creases).collect();
        Self {
            words: lists::words(arrays, parts),
            extent: Extent {
                count: parts.len(),
                room: parts.iter().map(Room::of).fold(Room::default(), Room::or),
                positions: parts.iter().map(|lists| lists.nodes.len()).sum(),
                velocities: parts.iter().map(|lists| lists.moving).sum(),
            },
            copies: Copies::new(copies, arrays.hinges.len()),
        }
    }
}

/// Whether a workgroup's memory and the widths of its indices hold a block.
fn is_held(lists: &Lists) -> bool {
    Room::of(lists).memory() <= MEMORY && fits_indices(lists)
}

fn fits_indices(lists: &Lists) -> bool {
    lists.nodes.len() <= MOST_NODES && lists.sides.len() < 1024 && lists.entries() < 65_536
}

/// Parts of one that is not held, each half of what it is of.
fn halved(arrays: &SheetArrays, at_nodes: &AtNodes, own: Vec<u32>, parts: &mut Vec<Lists>) -> Option<()> {
    if own.len() < 2 {
        return None;
    }
    let places: Vec<DVec3> = own.iter().map(|n| arrays.rest[*n as usize]).collect();
    for half in partition::parts(&places, 2) {
        let lists = Lists::new(arrays, at_nodes, half.iter().map(|i| own[*i as usize]).collect());
        if is_held(&lists) {
            parts.push(lists);
        } else {
            halved(arrays, at_nodes, lists.own(), parts)?;
        }
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use origami_core::generate::{Fan, miura};
    use origami_core::{Material, Model};

    use super::*;
    use crate::testing::{cases, sheets};

    fn arrays(model: &Model) -> SheetArrays {
        SheetArrays::new(model)
    }

    fn sheet(side: usize) -> SheetArrays {
        arrays(&Model::new(&miura(side, side).expect("valid"), &Material::default()).expect("a generated pattern"))
    }

    /// The header of a block: how many there are of each, and where its lists begin.
    fn header(blocks: &Blocks, b: usize) -> Vec<usize> {
        blocks.words[16 * b..16 * (b + 1)].iter().map(|word| *word as usize).collect()
    }

    #[test]
    fn every_node_is_the_own_of_one_block_which_has_all_that_pulls_at_it() {
        let all = cases::cases().into_iter().chain(sheets::special());
        for arrays in all.map(|case| arrays(&case.model)).chain([sheet(30)]) {
            let blocks = Blocks::new(&arrays).expect("small enough");
            let mut owned = BTreeSet::new();
            for b in 0..blocks.extent.count {
                let header = header(&blocks, b);
                let nodes = &blocks.words[header[6]..][..header[1]];
                let read: BTreeSet<u32> = nodes.iter().copied().collect();
                assert_eq!(read.len(), nodes.len(), "each is read once");
                let own: BTreeSet<u32> = nodes[..header[0]].iter().copied().collect();
                let touched = |nodes: &[u32]| nodes.iter().any(|n| own.contains(n));
                let faces = arrays.faces.iter().filter(|face| touched(&face.nodes));
                assert_eq!(faces.count(), header[3]);
                assert_eq!(arrays.loose_beams.iter().filter(|beam| touched(&beam.nodes)).count(), header[4]);
                for hinge in &arrays.hinges {
                    let nodes = [hinge.apex_one, hinge.apex_two, hinge.end_one, hinge.end_two];
                    assert!(!touched(&nodes) || nodes.iter().all(|n| read.contains(n)), "the whole crease");
                }
                assert!(own.iter().all(|n| owned.insert(*n)), "nobody else's");
            }
            assert_eq!(owned.len(), arrays.nodes);
            assert!(blocks.extent.room.memory() <= MEMORY);
        }
    }

    #[test]
    fn what_creases_are_is_found_again_in_their_copies() {
        let arrays = sheet(30);
        let copies = Blocks::new(&arrays).expect("small enough").copies;
        let (creases, values) = (arrays.hinges.len(), (0..arrays.hinges.len()).collect::<Vec<_>>());
        assert_eq!((copies.creases(), copies.collect(&copies.spread(&values))), (creases, values));
        assert!(copies.of.len() > creases, "some lie on the border of blocks");
    }

    #[test]
    fn a_node_at_which_too_much_pulls_has_no_block() {
        let fan = |valence| {
            let pattern = Fan { valence, ..Fan::default() }.pattern().expect("a pattern");
            arrays(&Model::new(&pattern, &Material::default()).expect("a model"))
        };
        assert!(Blocks::new(&fan(100)).is_some());
        assert!(Blocks::new(&fan(400)).is_none() && Blocks::whole(&fan(400)).is_none());
    }
}
