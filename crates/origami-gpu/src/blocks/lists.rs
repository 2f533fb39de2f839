//! What one block needs of the sheet, and how it is written for the shaders.

use super::AtNodes;
use crate::layout::{ALONE, CREASE, Face, OWN, RIGHT};
use crate::sheet_arrays::SheetArrays;

/// Words at the beginning for each block.
const HEADER: usize = 16;

/// A flag of a triangle: it has springs at its corners.
const HAS_CORNERS: u32 = 1 << 30;

/// A side: the crease on it or [`CREASE`], and its ends in ascending order. In this order creases come first.
type Side = (u32, u32, u32);

/// The elements of a block, by their indices in the sheet.
#[derive(Clone, Debug)]
pub(super) struct Lists {
    own: usize,
    /// First its own.
    pub(super) nodes: Vec<u32>,
    /// How many of them are its own or on an element with one of those: dampers ask for their velocities.
    pub(super) moving: usize,
    pub(super) sides: Vec<Side>,
    /// How many of the sides are creases.
    pub(super) creases: usize,
    pub(super) faces: Vec<u32>,
    pub(super) loose: Vec<u32>,
    /// The slots of its own nodes, one after the other, and where those of each begin.
    entries: Vec<u32>,
    rows: Vec<usize>,
}

fn side(face: &Face, i: usize) -> Side {
    let (a, b) = (face.nodes[i], face.nodes[(i + 1) % 3]);
    (face.sides[i] & CREASE, a.min(b), a.max(b))
}

fn sorted(mut list: Vec<u32>) -> Vec<u32> {
    list.sort_unstable();
    list.dedup();
    list
}

/// Where an element is in a sorted list that has it.
fn place<T: Ord>(list: &[T], wanted: &T) -> u32 {
    index(list.partition_point(|other| other < wanted))
}

#[expect(clippy::cast_possible_truncation, reason = "elements are counted in u32")]
fn index(i: usize) -> u32 {
    i as u32
}

impl Lists {
    /// All that pulls at the nodes `own`, which ascend.
    pub(super) fn new(arrays: &SheetArrays, at_nodes: &AtNodes, own: Vec<u32>) -> Self {
        let at_own = |csr: &origami_core::csr::Csr<u32>| {
            sorted(own.iter().flat_map(|n| csr.row(*n as usize)).copied().collect())
        };
        let (faces, loose) = (at_own(&at_nodes.faces), at_own(&at_nodes.loose));
        let own_faces = || faces.iter().map(|f| &arrays.faces[*f as usize]);
        let mut sides: Vec<Side> = own_faces().flat_map(|face| [0, 1, 2].map(|i| side(face, i))).collect();
        sides.sort_unstable();
        sides.dedup();
        let creases = sides.partition_point(|side| side.0 != CREASE);
        let apexes = sides[..creases].iter().flat_map(|side| {
            let hinge = &arrays.hinges[side.0 as usize];
            [hinge.apex_one, hinge.apex_two]
        });
        let ends = loose.iter().flat_map(|l| arrays.loose_beams[*l as usize].nodes);
        let moving = sorted(own_faces().flat_map(|face| face.nodes).chain(ends).chain(own.iter().copied()).collect());
        let others = sorted(moving.iter().copied().chain(apexes).collect());
        let mut nodes = own;
        let count = nodes.len();
        let halo: Vec<u32> = others.into_iter().filter(|n| nodes.binary_search(n).is_err()).collect();
        nodes.extend(halo);
        let mut lists = Self {
            own: count,
            nodes,
            moving: moving.len(),
            sides,
            creases,
            faces,
            loose,
            entries: Vec::new(),
            rows: vec![0],
        };
        for n in 0..count {
            let node = lists.nodes[n];
            let faces = at_nodes.faces.row(node as usize).iter().flat_map(|f| {
                let corner = arrays.faces[*f as usize].nodes.iter().position(|other| *other == node);
                corner.map(|corner| 3 * place(&lists.faces, f) + index(corner))
            });
            let first = 3 * index(lists.faces.len());
            let loose = at_nodes.loose.row(node as usize).iter().flat_map(|l| {
                let end = arrays.loose_beams[*l as usize].nodes.iter().position(|other| *other == node);
                end.map(|end| first + 2 * place(&lists.loose, l) + index(end))
            });
            let slots: Vec<u32> = faces.chain(loose).collect();
            lists.entries.extend(slots);
            lists.rows.push(lists.entries.len());
        }
        lists
    }

    /// The nodes of its own.
    pub(super) fn own(mut self) -> Vec<u32> {
        self.nodes.truncate(self.own);
        self.nodes
    }

    /// The creases, in their order.
    pub(super) fn creases(&self) -> impl Iterator<Item = u32> {
        self.sides[..self.creases].iter().map(|side| side.0)
    }

    /// How many forces its own nodes sum.
    pub(super) fn entries(&self) -> usize {
        self.entries.len()
    }
}

/// The words of all blocks: their headers, then the lists of each.
pub(super) fn words(arrays: &SheetArrays, parts: &[Lists]) -> Vec<u32> {
    let own_stiffness = arrays.hinges.iter().any(|hinge| hinge.kind == OWN);
    let mut words = vec![0; HEADER * parts.len()];
    let mut first_crease = 0;
    for (b, lists) in parts.iter().enumerate() {
        let counts = [lists.own, lists.nodes.len(), lists.creases, lists.faces.len(), lists.loose.len(), first_crease];
        first_crease += lists.creases;
        let writer = Writer::new(arrays, lists);
        let mut starts = Vec::new();
        let mut add = |list: Vec<u32>| {
            starts.push(words.len());
            words.extend(list);
        };
        add(lists.nodes.clone());
        add(writer.sides());
        add(writer.faces());
        add(lists.rows.windows(2).map(|row| index(row[0]) | index(row[1]) << 16).collect());
        add(lists.entries.chunks(2).map(|pair| pair[0] | pair.get(1).map_or(0, |slot| slot << 16)).collect());
        add(writer.loose_beams());
        add(if own_stiffness { writer.stiffness() } else { Vec::new() });
        add(if arrays.rigidities.is_empty() { Vec::new() } else { writer.rigidities() });
        let header = counts.into_iter().chain(starts).map(index);
        words[HEADER * b..].iter_mut().zip(header).for_each(|(word, value)| *word = value);
    }
    words
}

/// What a side is at rest: its square in two parts, the rigidity of its beam.
type Rest = (i32, f32, f32);

struct Writer<'a> {
    arrays: &'a SheetArrays,
    lists: &'a Lists,
    /// By side.
    rest: Vec<Rest>,
}

impl<'a> Writer<'a> {
    fn new(arrays: &'a SheetArrays, lists: &'a Lists) -> Self {
        let mut rest = vec![(0, 0.0, 0.0); lists.sides.len()];
        for f in &lists.faces {
            let face = &arrays.faces[*f as usize];
            for i in 0..3 {
                let rigidity = arrays.rigidities.get(3 * *f as usize + i).copied().unwrap_or(0.0);
                rest[place(&lists.sides, &side(face, i)) as usize] = (face.rest_high[i], face.rest_low[i], rigidity);
            }
        }
        Self { arrays, lists, rest }
    }

    /// Places of the nodes in the block, a byte each.
    fn bytes<const N: usize>(&self, nodes: [u32; N]) -> u32 {
        let (own, others) = self.lists.nodes.split_at(self.lists.own);
        let place = |n: &u32| own.binary_search(n).unwrap_or_else(|_| own.len() + place(others, n) as usize);
        nodes.iter().zip(0..).map(|(n, byte)| index(place(n)) << (8 * byte)).sum()
    }

    fn sides(&self) -> Vec<u32> {
        let words = self.lists.sides.iter().zip(&self.rest).flat_map(|(side, (high, low, _))| {
            let hinge = self.arrays.hinges.get(side.0 as usize).filter(|_| side.0 != CREASE);
            let (nodes, kind) = hinge.map_or((0, 0), |hinge| {
                (self.bytes([hinge.end_one, hinge.end_two, hinge.apex_one, hinge.apex_two]), hinge.kind)
            });
            [nodes, high.cast_unsigned() | kind << 30, low.to_bits()]
        });
        words.collect()
    }

    fn faces(&self) -> Vec<u32> {
        let words = self.lists.faces.iter().flat_map(|f| {
            let face = &self.arrays.faces[*f as usize];
            let corners = self.arrays.corners.get(*f as usize).is_some_and(|corners| *corners != [0.0; 4]);
            let mut nodes = self.bytes(face.nodes) | if corners { HAS_CORNERS } else { 0 };
            let mut sides = 0;
            for i in 0..3 {
                nodes |= u32::from(face.sides[i] & ALONE != 0) << (24 + i)
                    | u32::from(face.sides[i] & RIGHT != 0) << (27 + i);
                sides |= place(&self.lists.sides, &side(face, i)) << (10 * i);
            }
            let [a, b, c] = face.nodes.map(|n| self.arrays.rest[n as usize]);
            [nodes, sides, single((b - a).cross(c - a).length()).to_bits()]
        });
        words.collect()
    }

    fn loose_beams(&self) -> Vec<u32> {
        let words = self.lists.loose.iter().flat_map(|l| {
            let beam = &self.arrays.loose_beams[*l as usize];
            let rest = [beam.rest_high.cast_unsigned(), beam.rest_low.to_bits()];
            [self.bytes(beam.nodes), rest[0], rest[1], beam.rigidity.to_bits()]
        });
        words.collect()
    }

    fn stiffness(&self) -> Vec<u32> {
        self.lists.creases().map(|c| self.arrays.hinges[c as usize].length.to_bits()).collect()
    }

    fn rigidities(&self) -> Vec<u32> {
        self.rest.iter().map(|rest| rest.2.to_bits()).collect()
    }
}

#[expect(clippy::cast_possible_truncation, reason = "to the nearest")]
fn single(x: f64) -> f32 {
    x as f32
}
