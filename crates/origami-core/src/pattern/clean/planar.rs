//! Lines of a flat pattern made into a planar graph: vertices merged, lines split where they cross or touch.

use glam::{DVec2, DVec3};

use super::draft::{Draft, DraftEdge, EdgeMap};
use super::near::Near;
use super::notes::Notes;
use super::paper::no_paper;
use crate::csr::Csr;
use crate::error::{Error, ErrorCode, Place, WarningCode};
use crate::pattern::plane::{extent, orient};
use crate::pattern::point_grid::PointGrid;

/// Points and lines nearer than this, in sizes of the pattern, touch. Files with six digits are off by as much.
const TOUCH: f64 = 2e-6;
/// Splitting a line moves it by as much, so that it may meet others: then there is another round.
const ROUNDS: usize = 32;
/// More pieces than this are refused.
const MOST_PIECES: usize = 1 << 23;

/// A piece of an edge.
#[derive(Clone, Copy, Debug)]
struct Piece {
    ends: [u32; 2],
    edge: u32,
    /// Not yet compared with the others.
    fresh: bool,
}

/// A vertex on a piece, at a fraction of its length.
struct Split {
    piece: u32,
    at: f64,
    vertex: u32,
}

/// Merges vertices, and splits edges where they meet. The first piece of an edge keeps its number; the others are
/// appended. Edges that fall on another, or vanish, become aliases.
pub(super) fn arrange(draft: &mut Draft) -> Result<EdgeMap, Error> {
    let mut graph = Graph::new(draft);
    let in_file = draft.points.len();
    let mut pieces = Vec::with_capacity(draft.edges.len());
    for (index, edge) in draft.edges.iter().enumerate() {
        let ends = edge.ends.map(|v| draft.vertex_alias[v as usize].unwrap_or(v));
        if ends[0] != ends[1] {
            pieces.push(Piece { ends, edge: index as u32, fresh: true });
        }
    }
    if pieces.is_empty() {
        return Err(no_paper());
    }
    for _ in 0..ROUNDS {
        let (lines, line_of) = different(&pieces);
        let splits = graph.meetings(&lines)?;
        note_touching(&mut draft.notes, in_file, &lines, &splits);
        if splits.is_empty() {
            graph.append_crossings(draft);
            rebuild_edges(draft, &pieces, &line_of);
            return Ok(EdgeMap::new(draft.points.len(), &draft.edges));
        }
        pieces = cut_at(&pieces, &lines, &line_of, &splits)?;
    }
    Err(crowded())
}

fn crowded() -> Error {
    let problem = "lines cross too densely to be told apart";
    let place = Place::key("edges_vertices");
    Error::new(ErrorCode::LinesTooDense, place, problem, "a crease pattern, or faces_vertices")
}

/// Vertices in the plane.
struct Graph {
    /// `TOUCH` in the unit of the points.
    touch: f64,
    points: Vec<DVec2>,
    grid: PointGrid,
    /// The two edges at whose crossing each further point lies.
    crossings: Vec<[u32; 2]>,
}

impl Graph {
    fn new(draft: &mut Draft) -> Self {
        let points: Vec<_> = draft.points.iter().map(|p| p.truncate()).collect();
        let origin = points.iter().fold(DVec2::INFINITY, |low, &p| low.min(p));
        let touch = TOUCH * extent(&draft.points).max_element();
        let mut grid = PointGrid::new(origin, touch, points.len());
        for (index, &point) in points.iter().enumerate() {
            if let Some(first) = grid.find(point) {
                draft.vertex_alias[index] = Some(first);
                draft.fixed[first as usize] |= draft.fixed[index];
                let message = "lies on another vertex; the two are one";
                draft.notes.add(WarningCode::VerticesMerged, "vertices_coords", index, message);
            } else {
                grid.insert(index as u32, point);
            }
        }
        Self { touch, points, grid, crossings: Vec::new() }
    }

    fn ends(&self, piece: &Piece) -> [DVec2; 2] {
        piece.ends.map(|v| self.points[v as usize])
    }

    /// Where fresh pieces meet any others, in order along each piece.
    fn meetings(&mut self, pieces: &[Piece]) -> Result<Vec<Split>, Error> {
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

    fn append_crossings(&self, draft: &mut Draft) {
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
}

/// Warns of vertices of the file that lie on a line of it.
fn note_touching(notes: &mut Notes, in_file: usize, pieces: &[Piece], splits: &[Split]) {
    for split in splits.iter().filter(|split| (split.vertex as usize) < in_file) {
        notes.add_with(WarningCode::VertexOnEdge, "lies on it; the line is split there", || {
            let edge = pieces[split.piece as usize].edge as usize;
            (Place::entry("edges_vertices", edge), format!("vertex {}", split.vertex))
        });
    }
}

/// The first of all pieces that have the same ends, and which of these stands for each piece. Pieces on each other meet
/// others at the same points: they need not be looked at one by one, let alone be compared.
fn different(pieces: &[Piece]) -> (Vec<Piece>, Vec<u32>) {
    let ends = |i: u32| {
        let [a, b] = pieces[i as usize].ends;
        [a.min(b), a.max(b)]
    };
    let mut order: Vec<u32> = (0..pieces.len() as u32).collect();
    order.sort_unstable_by_key(|&i| (ends(i), i));
    let mut first = order.clone();
    for group in order.chunk_by(|&i, &j| ends(i) == ends(j)) {
        group.iter().for_each(|&i| first[i as usize] = group[0]);
    }
    let mut lines: Vec<Piece> = Vec::with_capacity(pieces.len());
    let mut line_of = vec![0; pieces.len()];
    for (index, (piece, &first)) in pieces.iter().zip(&first).enumerate() {
        if first as usize == index {
            line_of[index] = lines.len() as u32;
            lines.push(*piece);
        } else {
            line_of[index] = line_of[first as usize];
            lines[line_of[index] as usize].fresh &= piece.fresh;
        }
    }
    (lines, line_of)
}

/// The pieces that remain when each is cut where its line is split, in order along its edge.
fn cut_at(pieces: &[Piece], lines: &[Piece], line_of: &[u32], splits: &[Split]) -> Result<Vec<Piece>, Error> {
    let of_line = Csr::from_entries(lines.len(), splits.iter().map(|split| (split.piece as usize, split.vertex)));
    let count = line_of.iter().map(|&line| 1 + of_line.row(line as usize).len()).sum();
    if count > MOST_PIECES {
        return Err(crowded());
    }
    let mut result = Vec::with_capacity(count);
    for (piece, &line) in pieces.iter().zip(line_of) {
        let cuts = of_line.row(line as usize);
        let mut from = piece.ends[0];
        let mut cut = |to: u32| {
            let fresh = !cuts.is_empty();
            result.push(Piece { ends: [std::mem::replace(&mut from, to), to], edge: piece.edge, fresh });
        };
        if piece.ends == lines[line as usize].ends {
            cuts.iter().for_each(|&vertex| cut(vertex));
        } else {
            cuts.iter().rev().for_each(|&vertex| cut(vertex));
        }
        cut(piece.ends[1]);
    }
    Ok(result)
}

/// Edges from pieces; of those on one line the first stands for all.
fn rebuild_edges(draft: &mut Draft, pieces: &[Piece], line_of: &[u32]) {
    let mut at = pieces.iter().zip(line_of).peekable();
    let mut edge_of_line: Vec<Option<usize>> = vec![None; pieces.len()];
    let mut vanished = Vec::new();
    for index in 0..draft.edges.len() {
        let whole = draft.edges[index].clone();
        let mut first = true;
        while let Some((piece, &line)) = at.next_if(|(piece, _)| piece.edge as usize == index) {
            let part = DraftEdge { ends: piece.ends, ..whole.clone() };
            let number = if first { index } else { draft.edges.len() };
            let standing = edge_of_line[line as usize];
            match standing {
                Some(standing) => draft.absorb(standing, &part),
                None if first => draft.edges[index] = part,
                None => draft.edges.push(part),
            }
            edge_of_line[line as usize] = standing.or(Some(number));
            if first {
                draft.edges[index].alias = standing.map(|edge| edge as u32);
            }
            first = false;
        }
        if first {
            vanished.push(index);
        }
    }
    replace_vanished(draft, &vanished);
}

/// Lets an edge at the same vertex, or any edge, stand for each of those whose ends were merged.
fn replace_vanished(draft: &mut Draft, vanished: &[usize]) {
    if vanished.is_empty() {
        return;
    }
    let mut edge_at: Vec<Option<u32>> = vec![None; draft.points.len()];
    let mut gone = vanished.iter().copied().peekable();
    let mut any = None;
    for (index, edge) in draft.edges.iter().enumerate() {
        if gone.next_if_eq(&index).is_none() && edge.alias.is_none() {
            any = any.or(Some(index as u32));
            edge.ends.iter().for_each(|&v| edge_at[v as usize] = edge_at[v as usize].or(Some(index as u32)));
        }
    }
    for &index in vanished {
        let vertex = draft.edges[index].ends[0];
        let vertex = draft.vertex_alias[vertex as usize].unwrap_or(vertex);
        draft.edges[index].alias = edge_at[vertex as usize].or(any);
        draft.notes.add(WarningCode::EdgeWithoutLength, "edges_vertices", index, "edge without length; left out");
    }
}
