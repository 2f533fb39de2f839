//! Lines of a flat pattern made into a planar graph: vertices merged, lines split where they cross or touch.

use super::draft::{Draft, DraftEdge, EdgeMap};
use super::graph::{Graph, MOST_PIECES, Piece, Split, crowded};
use super::joins;
use super::paper::no_paper;
use super::tolerance::{Lines, TOUCH, last_digit};
use crate::csr::Csr;
use crate::error::{Error, WarningCode};
use crate::pattern::plane::extent;

/// Splitting a line moves it by as much, so that it may meet others: then there is another round.
const ROUNDS: usize = 32;
/// Nothing is joined by less than this, in sizes: coordinates are not known better.
const LEAST: f64 = 1e-12;

/// Merges vertices, and splits edges where they meet. The first piece of an edge keeps its number; the others are
/// appended. Edges that fall on another, or vanish, become aliases.
pub(super) fn arrange(draft: &mut Draft) -> Result<EdgeMap, Error> {
    let rounding = TOUCH * extent(&draft.points).max_element();
    let mut graph = graph(draft, rounding);
    let mut meetings = graph.take_merged(draft);
    let mut pieces = pieces(draft, |v| draft.vertex_alias[v as usize].unwrap_or(v));
    if pieces.is_empty() {
        return Err(no_paper());
    }
    for _ in 0..ROUNDS {
        let (lines, line_of) = different(&pieces);
        let splits = graph.meetings(&lines)?;
        meetings.extend(graph.touching(draft.points.len(), &lines, &splits));
        if splits.is_empty() {
            joins::note(draft, &meetings, rounding);
            graph.append_crossings(draft);
            rebuild_edges(draft, &pieces, &line_of);
            return Ok(EdgeMap::new(draft.points.len(), &draft.edges));
        }
        pieces = cut_at(&pieces, &lines, &line_of, &splits)?;
    }
    Err(crowded())
}

/// The vertices, merged within the distance that was asked for, or else that the lines themselves speak for.
fn graph(draft: &Draft, rounding: f64) -> Graph {
    if let Some(join) = draft.join {
        return Graph::new(&draft.points, join.max(LEAST * rounding / TOUCH));
    }
    let graph = Graph::new(&draft.points, rounding);
    let (lines, _) = different(&pieces(draft, |v| graph.alias(v).unwrap_or(v)));
    let lines: Vec<[u32; 2]> = lines.iter().map(|line| line.ends).collect();
    let digit = draft.scale * last_digit(draft.points.iter().flat_map(|p| [p.x, p.y]).map(|x| x / draft.scale));
    let tolerance = Lines { points: &graph.points, lines: &lines, touch: rounding, digit }.tolerance();
    if tolerance > rounding { Graph::new(&draft.points, tolerance) } else { graph }
}

/// The edges that have a length between the vertices that stand for their ends.
fn pieces(draft: &Draft, stands_for: impl Fn(u32) -> u32) -> Vec<Piece> {
    let pieces =
        draft.edges.iter().zip(0..).map(|(line, edge)| Piece { ends: line.ends.map(&stands_for), edge, fresh: true });
    pieces.filter(|piece| piece.ends[0] != piece.ends[1]).collect()
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
