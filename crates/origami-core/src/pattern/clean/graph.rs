//! Vertices in the plane, those that touch being one, and where the lines between them meet.

use glam::{DVec2, DVec3};

use super::draft::Draft;
use super::joins::{Meeting, on_line, on_vertex};
use super::near::Near;
use crate::error::{Error, ErrorCode, Place, WarningCode};
use crate::pattern::plane::orient;
use crate::pattern::point_grid::PointGrid;

/// More pieces than this are refused.
pub(super) const MOST_PIECES: usize = 1 << 23;

/// A piece of an edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) ends: [u32; 2],
    pub(super) edge: u32,
    /// Not yet compared with the others.
    pub(super) fresh: bool,
}

/// A vertex on a piece, at a fraction of its length.
pub(super) struct Split {
    pub(super) piece: u32,
    pub(super) at: f64,
    pub(super) vertex: u32,
}

/// Vertices in the plane.
pub(super) struct Graph {
    /// What is nearer than this is one, or on the line.
    touch: f64,
    pub(super) points: Vec<DVec2>,
    /// The vertex that each vertex of the file was merged into.
    merged: Vec<Option<u32>>,
    grid: PointGrid,
    /// The two edges at whose crossing each further point lies.
    crossings: Vec<[u32; 2]>,
}

impl Graph {
    /// The vertices at `points`, those nearer than `touch` to an earlier one merged into it.
    pub(super) fn new(points: &[DVec3], touch: f64) -> Self {
        let points: Vec<_> = points.iter().map(|p| p.truncate()).collect();
        let origin = points.iter().fold(DVec2::INFINITY, |low, &p| low.min(p));
        let mut grid = PointGrid::new(origin, touch, points.len());
        let mut merge = |(index, &point): (usize, &DVec2)| {
            let first = grid.find(point);
            if first.is_none() {
                grid.insert(index as u32, point);
            }
            first
        };
        let merged = points.iter().enumerate().map(&mut merge).collect();
        Self { touch, points, merged, grid, crossings: Vec::new() }
    }

    /// The vertex of the file that stands for this one.
    pub(super) fn alias(&self, vertex: u32) -> Option<u32> {
        self.merged[vertex as usize]
    }

    /// Tells the draft which vertices are one, and how far apart they lie.
    pub(super) fn take_merged(&mut self, draft: &mut Draft) -> Vec<Meeting> {
        let mut meetings = Vec::new();
        for (index, first) in std::mem::take(&mut self.merged).into_iter().enumerate() {
            let Some(first) = first else { continue };
            draft.vertex_alias[index] = Some(first);
            draft.fixed[first as usize] |= draft.fixed[index];
            let distance = self.points[index].distance(self.points[first as usize]);
            meetings.push(on_vertex(index as u32, first, distance));
        }
        meetings
    }

    fn ends(&self, piece: &Piece) -> [DVec2; 2] {
        piece.ends.map(|v| self.points[v as usize])
    }

    /// Where fresh pieces meet any others, in order along each piece.
    pub(super) fn meetings(&mut self, pieces: &[Piece]) -> Result<Vec<Split>, Error> {
        let lines: Vec<[u32; 2]> = pieces.iter().map(|piece| piece.ends).collect();
        let near = Near::new(&self.points, &lines, self.touch);
        let fresh = |index: usize| pieces[index].fresh;
        let meets = |index: usize, other: usize| self.is_meeting(&pieces[index], &pieces[other]);
        // In the tree's order, so that what is looked at next is at hand; few pairs have more to be done.
        let mut pairs = Vec::new();
        for index in near.order() {
            if fresh(index) {
                near.apart(index, |other| {
                    if !(fresh(other) && other < index) && meets(index, other) {
                        pairs.push((index, other));
                    }
                });
            }
            near.along(index, |other| {
                if (fresh(index) || fresh(other)) && meets(index, other) {
                    pairs.push((index.min(other), index.max(other)));
                }
            });
            if pairs.len() > MOST_PIECES {
                return Err(crowded());
            }
        }
        pairs.sort_unstable();
        pairs.dedup();
        let mut splits = Vec::new();
        for (index, other) in pairs {
            self.meet(pieces, index, other, &mut splits);
        }
        splits.sort_by_key(|split| (split.piece, split.vertex));
        splits.dedup_by_key(|split| (split.piece, split.vertex));
        splits.sort_by(|a, b| a.piece.cmp(&b.piece).then(a.at.total_cmp(&b.at)));
        Ok(splits)
    }

    /// Whether one has an end on the other, or they cross.
    fn is_meeting(&self, one: &Piece, two: &Piece) -> bool {
        let touching = |end: &Piece, line: &Piece| {
            end.ends.iter().any(|v| !line.ends.contains(v) && self.touches(*v, line).is_some())
        };
        let share = one.ends.iter().any(|v| two.ends.contains(v));
        touching(one, two) || touching(two, one) || (!share && self.crossing(one, two).is_some())
    }

    /// At which fractions of their lengths the two cross.
    fn crossing(&self, one: &Piece, two: &Piece) -> Option<(f64, f64)> {
        let ([a, b], [c, d]) = (self.ends(one), self.ends(two));
        let (at_a, at_b) = (orient(c, d, a), orient(c, d, b));
        let (at_c, at_d) = (orient(a, b, c), orient(a, b, d));
        let crosses = (at_a > 0.0) != (at_b > 0.0) && (at_c > 0.0) != (at_d > 0.0);
        crosses.then(|| (at_a / (at_a - at_b), at_c / (at_c - at_d)))
    }

    /// Splits for pieces `i` and `j`: at ends that lie on the other one, else where they cross.
    fn meet(&mut self, pieces: &[Piece], i: usize, j: usize, splits: &mut Vec<Split>) {
        let before = splits.len();
        for (end, line) in [(i, j), (j, i)] {
            for vertex in pieces[end].ends {
                if !pieces[line].ends.contains(&vertex) {
                    let at = self.touches(vertex, &pieces[line]);
                    splits.extend(at.map(|at| Split { piece: line as u32, at, vertex }));
                }
            }
        }
        let share = pieces[i].ends.iter().any(|v| pieces[j].ends.contains(v));
        if share || splits.len() > before {
            return;
        }
        let Some((t, u)) = self.crossing(&pieces[i], &pieces[j]) else { return };
        let [a, b] = self.ends(&pieces[i]);
        let vertex = self.vertex_at(a + t * (b - a), [pieces[i].edge, pieces[j].edge]);
        for (piece, at) in [(i, t), (j, u)] {
            if !pieces[piece].ends.contains(&vertex) {
                splits.push(Split { piece: piece as u32, at, vertex });
            }
        }
    }

    /// At which fraction of the line the vertex lies, if it lies on it and between its ends.
    fn touches(&self, vertex: u32, line: &Piece) -> Option<f64> {
        let point = self.points[vertex as usize];
        let [a, b] = self.ends(line);
        let along = b - a;
        let at = (point - a).dot(along) / along.length_squared();
        let inside = at > 0.0 && at < 1.0 && (a + at * along).distance(point) <= self.touch;
        inside.then_some(at)
    }

    fn vertex_at(&mut self, point: DVec2, crossing: [u32; 2]) -> u32 {
        self.grid.find(point).unwrap_or_else(|| {
            let id = self.points.len() as u32;
            self.grid.insert(id, point);
            self.points.push(point);
            self.crossings.push(crossing);
            id
        })
    }

    pub(super) fn append_crossings(&self, draft: &mut Draft) {
        let z = draft.points.first().map_or(0.0, |point| point.z);
        let in_file = self.points.len() - self.crossings.len();
        for (point, [one, two]) in self.points[in_file..].iter().zip(&self.crossings) {
            draft.notes.add_with(WarningCode::EdgesCross, "both get a vertex there", || {
                (
                    Place::entry("edges_vertices", *one.min(two) as usize),
                    format!("crosses edges_vertices[{}];", one.max(two)),
                )
            });
            draft.push_vertex(DVec3::new(point.x, point.y, z), false);
        }
    }

    /// The vertices of the file, numbered below `in_file`, at which lines are split, and how far from the line they lie.
    pub(super) fn touching(&self, in_file: usize, pieces: &[Piece], splits: &[Split]) -> impl Iterator<Item = Meeting> {
        splits.iter().filter(move |split| (split.vertex as usize) < in_file).map(|split| {
            let piece = &pieces[split.piece as usize];
            let [a, b] = self.ends(piece);
            let foot = a + split.at * (b - a);
            on_line(split.vertex, piece.edge, foot.distance(self.points[split.vertex as usize]))
        })
    }
}

/// The refusal of lines that cannot be told apart.
pub(super) fn crowded() -> Error {
    let problem = "lines cross too densely to be told apart";
    let place = Place::key("edges_vertices");
    Error::new(ErrorCode::LinesTooDense, place, problem, "a crease pattern, or faces_vertices")
}
