//! The lines of a pattern, each once.

use std::collections::BTreeMap;

use glam::DVec2;
use origami_core::CreasePattern;
use origami_core::error::{Error, ErrorCode, Place};
use origami_core::pattern::{Assignment, PatternEdge};

/// What a line is, where lines are all there is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Kind {
    /// The edge of the paper.
    Boundary,
    /// Two edges of the paper that lie upon each other: a cut.
    Cut,
    /// Folds away from the viewer.
    Mountain,
    /// Folds towards the viewer.
    Valley,
    /// Stays flat.
    Flat,
    /// A hinge that nothing drives.
    Undriven,
}

impl Kind {
    /// All of them, in the order in which they are drawn over each other.
    pub const ALL: [Self; 6] = [Self::Flat, Self::Undriven, Self::Valley, Self::Mountain, Self::Boundary, Self::Cut];

    /// The name of its layer.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Boundary => "boundary",
            Self::Cut => "cut",
            Self::Mountain => "mountain",
            Self::Valley => "valley",
            Self::Flat => "flat",
            Self::Undriven => "undriven",
        }
    }

    fn of(assignment: Assignment) -> Self {
        match assignment {
            Assignment::Mountain => Self::Mountain,
            Assignment::Valley => Self::Valley,
            Assignment::Unassigned => Self::Undriven,
            Assignment::Boundary => Self::Boundary,
            _ => Self::Flat,
        }
    }
}

/// One line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its ends, in the file's unit.
    pub ends: [DVec2; 2],
    /// What it is.
    pub kind: Kind,
    /// Its fold angle in degrees, valley positive; `None` where nothing drives it.
    pub angle: Option<f64>,
}

/// The lines of a flat pattern, in its order: edges that stand for others and both lips of a cut once. With `straight`,
/// pieces that follow each other in one line and are of one kind and angle are one; their joints are no farther from it than
/// this share of the pattern's size.
///
/// # Errors
/// [`Error::Invalid`] for a pattern that is not flat.
pub fn strokes(pattern: &CreasePattern, straight: Option<f64>) -> Result<Vec<Stroke>, Error> {
    if !pattern.is_flat() {
        let problem = "the sheet is not flat, and this format holds flat patterns only";
        return Err(Error::new(ErrorCode::WrongValue, Place::key("vertices_coords"), problem, "a flat one, or FOLD"));
    }
    let pieces = pieces(pattern);
    Ok(match straight {
        Some(share) => joined(&pieces, share * pattern.size()),
        None => pieces,
    })
}

/// What the bits of a place are; -0 and 0 are one.
fn bits(place: DVec2) -> [u64; 2] {
    (place + DVec2::ZERO).to_array().map(f64::to_bits)
}

fn pieces(pattern: &CreasePattern) -> Vec<Stroke> {
    let mut lips: BTreeMap<[[u64; 2]; 2], usize> = BTreeMap::new();
    let mut strokes: Vec<Stroke> = Vec::with_capacity(pattern.edges.len());
    for edge in pattern.edges.iter().filter(|edge| edge.alias_of.is_none()) {
        let Some(ends) = ends(pattern, edge) else { continue };
        let kind = Kind::of(edge.assignment);
        if kind == Kind::Boundary {
            let mut key = ends.map(bits);
            key.sort_unstable();
            if let Some(other) = lips.insert(key, strokes.len()) {
                strokes[other].kind = Kind::Cut;
                lips.insert(key, other);
                continue;
            }
        }
        let angle = edge.fold_angle.filter(|_| kind != Kind::Boundary).map(degrees);
        strokes.push(Stroke { ends, kind, angle });
    }
    strokes
}

/// The places of an edge's ends, or of what stands for them; `None` for an edge of vertices that are not there.
fn ends(pattern: &CreasePattern, edge: &PatternEdge) -> Option<[DVec2; 2]> {
    let place = |vertex: usize| {
        let alias = pattern.alias_of.get(vertex).copied().flatten();
        pattern.vertices.get(alias.map_or(vertex, |alias| alias.index())).map(|place| place.truncate())
    };
    let [a, b] = edge.vertices.map(|vertex| place(vertex.index()));
    Some([a?, b?])
}

/// Without the last digits where they come from the way to radians and back.
fn degrees(radians: f64) -> f64 {
    let degrees = radians.to_degrees();
    let rounded = (degrees * 1e9).round() / 1e9;
    if (degrees - rounded).abs() <= 4.0 * f64::EPSILON * degrees.abs() { rounded } else { degrees }
}

/// One line for each row of pieces, where its first piece was.
fn joined(pieces: &[Stroke], tolerance: f64) -> Vec<Stroke> {
    let mut at: BTreeMap<[u64; 2], Vec<usize>> = BTreeMap::new();
    for (i, piece) in pieces.iter().enumerate() {
        piece.ends.iter().for_each(|end| at.entry(bits(*end)).or_default().push(i));
    }
    let mut used = vec![false; pieces.len()];
    let mut strokes = Vec::new();
    for (i, piece) in pieces.iter().enumerate() {
        if std::mem::replace(&mut used[i], true) {
            continue;
        }
        let mut row = vec![piece.ends[0], piece.ends[1]];
        for _ in 0..2 {
            while let Some((next, end)) = following(pieces, &at, &used, piece, &row, tolerance) {
                used[next] = true;
                row.push(end);
            }
            row.reverse();
        }
        strokes.push(Stroke { ends: [row[0], row[row.len() - 1]], ..*piece });
    }
    strokes
}

/// The piece that goes on in a line from the end of a row, and where to: the straightest of those that are of the row's kind
/// and keep all joints within the tolerance.
fn following(
    pieces: &[Stroke],
    at: &BTreeMap<[u64; 2], Vec<usize>>,
    used: &[bool],
    like: &Stroke,
    row: &[DVec2],
    tolerance: f64,
) -> Option<(usize, DVec2)> {
    let [.., before, last] = row else { return None };
    let along = *last - *before;
    let candidates = at.get(&bits(*last))?.iter().copied().filter(|next| !used[*next]);
    let candidates = candidates.filter_map(|next| {
        let piece = &pieces[next];
        let end = if bits(piece.ends[0]) == bits(*last) { piece.ends[1] } else { piece.ends[0] };
        let onwards = end - *last;
        let alike = piece.kind == like.kind && piece.angle == like.angle;
        let turn = along.perp_dot(onwards).abs() / (along.length() * onwards.length());
        (alike && along.dot(onwards) > 0.0 && fits(row, end, tolerance)).then_some((turn, next, end))
    });
    candidates.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, next, end)| (next, end))
}

/// Whether the line from a row's first point to `end` comes near all its joints.
fn fits(row: &[DVec2], end: DVec2, tolerance: f64) -> bool {
    let line = end - row[0];
    let length = line.length();
    length > 0.0 && row[1..].iter().all(|joint| line.perp_dot(*joint - row[0]).abs() <= tolerance * length)
}
