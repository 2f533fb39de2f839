//! The pattern while it is being built: plain indices, and coordinates scaled to a size near one.

use glam::DVec3;

use super::letters::Letter;
use super::notes::Notes;
use crate::csr::Csr;
use crate::error::{Place, WarningCode};
use crate::pattern::joins::Join;

/// A pattern in the making.
#[derive(Debug)]
pub(super) struct Draft {
    /// Positions, scaled by a power of two (so exactly) to a size between 1/2 and 1.
    pub(super) points: Vec<DVec3>,
    /// What leads from the file's unit to that of the points.
    pub(super) scale: f64,
    /// Within which distance lines are joined, in the unit of the points; `None`: to be found from them.
    pub(super) join: Option<f64>,
    /// All at one height z.
    pub(super) flat: bool,
    /// The vertex that this one was merged into.
    pub(super) vertex_alias: Vec<Option<u32>>,
    /// Vertices that do not move.
    pub(super) fixed: Vec<bool>,
    pub(super) edges: Vec<DraftEdge>,
    pub(super) faces: Vec<Vec<u32>>,
    /// What was joined though it did not touch.
    pub(super) joins: Vec<Join>,
    pub(super) notes: Notes,
}

/// An edge in the making.
#[derive(Clone, Debug)]
pub(super) struct DraftEdge {
    pub(super) ends: [u32; 2],
    /// `None`: the file gives no letters.
    pub(super) letter: Option<Letter>,
    pub(super) given: GivenAngle,
    /// In radians, once settled.
    pub(super) fold_angle: Option<f64>,
    pub(super) k_crease: Option<f64>,
    pub(super) ea: Option<f64>,
    pub(super) alias: Option<u32>,
    pub(super) origin: Origin,
}

/// The entry of an edge in `edges_foldAngle`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum GivenAngle {
    /// There is no such key.
    Absent,
    /// `null`: a free crease.
    Free,
    /// In degrees.
    Degrees(f64),
}

/// The origin of an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Origin {
    /// An edge of the file, or a piece of it.
    File(u32),
    /// A side of a face that `edges_vertices` does not list.
    Face(u32),
}

impl Origin {
    /// Its place under an edge key such as `edges_vertices`.
    pub(super) fn place(self, key: &'static str) -> Place {
        match self {
            Self::File(edge) => Place::entry(key, edge as usize),
            Self::Face(face) => Place::entry("faces_vertices", face as usize),
        }
    }
}

impl DraftEdge {
    /// An edge that the file does not list, between vertices of face `face`.
    pub(super) fn new(ends: [u32; 2], letter: Option<Letter>, face: usize) -> Self {
        Self {
            ends,
            letter,
            given: GivenAngle::Absent,
            fold_angle: None,
            k_crease: None,
            ea: None,
            alias: None,
            origin: Origin::Face(face as u32),
        }
    }
}

/// The live edge between two vertices: rows by the lower vertex, sorted by the upper one.
#[derive(Debug)]
pub(super) struct EdgeMap(Csr<(u32, u32)>);

impl EdgeMap {
    /// The map of `edges`, numbered from 0; of edges with the same ends the first counts.
    pub(super) fn new(vertices: usize, edges: &[DraftEdge]) -> Self {
        let ends = edges.iter().zip(0..).filter(|(edge, _)| edge.alias.is_none());
        let mut rows = Csr::from_entries(
            vertices,
            ends.map(|(edge, index)| {
                let [a, b] = edge.ends;
                (a.min(b) as usize, (a.max(b), index))
            }),
        );
        (0..vertices).for_each(|vertex| rows.row_mut(vertex).sort_unstable());
        Self(rows)
    }

    pub(super) fn get(&self, [a, b]: [u32; 2]) -> Option<usize> {
        let (low, high) = (a.min(b), a.max(b));
        let row = self.0.row(low as usize);
        // A hub has a long row.
        let place = row.partition_point(|(other, _)| *other < high);
        row.get(place).filter(|(other, _)| *other == high).map(|(_, edge)| *edge as usize)
    }
}

impl Draft {
    /// Appends a vertex at `point`.
    pub(super) fn push_vertex(&mut self, point: DVec3, fixed: bool) -> u32 {
        self.points.push(point);
        self.vertex_alias.push(None);
        self.fixed.push(fixed);
        (self.points.len() - 1) as u32
    }

    /// Lets edge `first` stand also for `other`, which has the same ends. Mountain and valley win over letters that do
    /// not drive; otherwise the first letter stays.
    pub(super) fn absorb(&mut self, first: usize, other: &DraftEdge) {
        let edge = &mut self.edges[first];
        if edge.letter != other.letter {
            let (kept, added) = (edge.origin, other.origin);
            let show = |letter: Option<Letter>| letter.map_or("none", Letter::name);
            let (a, b) = (show(edge.letter), show(other.letter));
            let message = "given to one line; a mountain or valley wins, otherwise the first letter";
            self.notes.add_with(WarningCode::EdgeTwiceLetters, message, || {
                (added.place("edges_assignment"), format!("{b}, and {a} at {},", kept.place("edges_assignment")))
            });
        } else {
            let place = other.origin.place("edges_vertices");
            let message = "line given more than once; the first stands for all";
            self.notes.add_with(WarningCode::EdgeTwice, message, || (place, String::new()));
        }
        if other.letter.is_some_and(Letter::drives) && !edge.letter.is_some_and(Letter::wins_over_driving) {
            *edge = DraftEdge { ends: edge.ends, origin: edge.origin, alias: None, ..other.clone() };
        }
    }
}
