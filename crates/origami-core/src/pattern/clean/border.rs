//! A border that does not close: closed by a straight line where there is one way to do so, else refused by name. Half a
//! sheet whose border is open would otherwise be outside, and gone.

use glam::DVec2;

use super::draft::{Draft, DraftEdge, EdgeMap};
use super::letters::Letter;
use super::loops::{OUTSIDE, Regions, regions};
use super::tolerance::TOUCH;
use crate::csr::Csr;
use crate::error::{Error, ErrorCode, Short, WarningCode, rounded};
use crate::pattern::plane::{extent, orient};

/// Gaps up to this, in sizes, are closed wherever they are.
const SMALL: f64 = 0.05;
/// Larger ones, where the border runs on in the same direction to this angle, in radians; or along the hull of the lines.
const STRAIGHT: f64 = 1e-3;
/// A border of more open ends is no border.
const MOST_ENDS: usize = 64;

/// Closes the border of a flat draft whose edges meet at their ends only.
pub(super) fn close(draft: &mut Draft, map: &mut EdgeMap) -> Result<(), Error> {
    if odd_ends(draft).is_empty() {
        return Ok(());
    }
    let open = Open::of(draft, &regions(draft));
    if open.lines.is_empty() || !open.is_damage {
        return Ok(());
    }
    let bridges = bridges(draft, &open);
    for bridge in &bridges {
        let [a, b] = bridge.ends;
        let beside = open.line_at(draft, a).or(open.line_at(draft, b)).unwrap_or(open.lines[0]);
        let line = &draft.edges[beside];
        let distance = draft.points[a as usize].distance(draft.points[b as usize]) / draft.scale;
        let message = format!(
            "the border is open between vertices_coords[{a}] and [{b}], {} apart; closed by a straight line",
            Short(rounded(distance))
        );
        draft.notes.add_one(WarningCode::BorderClosed, line.origin.place("edges_vertices"), message);
        let origin = line.origin;
        for piece in bridge.stops.windows(2) {
            let piece = DraftEdge::new([piece[0], piece[1]], Some(Letter::Boundary), 0);
            draft.edges.push(DraftEdge { origin, ..piece });
        }
    }
    if !bridges.is_empty() {
        *map = EdgeMap::new(draft.points.len(), &draft.edges);
    }
    let still = Open::of(draft, &regions(draft));
    if still.lines.is_empty() || !still.is_damage || !(still.has_paper || still.has_creases) {
        // Without any paper the refusal is another one.
        return Ok(());
    }
    Err(still.refusal(draft))
}

/// Vertices at which an odd number of boundary edges end.
fn odd_ends(draft: &Draft) -> Vec<u32> {
    let mut odd = vec![false; draft.points.len()];
    let boundary = |edge: &&DraftEdge| edge.alias.is_none() && edge.letter == Some(Letter::Boundary);
    for vertex in draft.edges.iter().filter(boundary).flat_map(|edge| edge.ends) {
        odd[vertex as usize] ^= true;
    }
    (0..).zip(odd).filter_map(|(vertex, odd)| odd.then_some(vertex)).collect()
}

/// Where the border is open.
struct Open {
    /// Boundary edges that have the outside on both sides.
    lines: Vec<usize>,
    /// Where the border ends, on the outside.
    ends: Vec<u32>,
    /// Whether creases lie at the outside, or there is no paper at all.
    is_damage: bool,
    has_paper: bool,
    has_creases: bool,
}

impl Open {
    fn of(draft: &Draft, regions: &Regions) -> Self {
        let has_paper = regions.loops.len() > 1;
        let (mut lines, mut is_damage, mut has_creases) = (Vec::new(), !has_paper, false);
        let mut outside = vec![false; draft.points.len()];
        for (index, edge) in draft.edges.iter().enumerate().filter(|(_, edge)| edge.alias.is_none()) {
            let out = [0, 1].map(|side| regions.left_of[2 * index + side] == OUTSIDE);
            if out.contains(&true) {
                edge.ends.iter().for_each(|&v| outside[v as usize] = true);
            }
            match edge.letter {
                Some(Letter::Boundary) if out == [true, true] => lines.push(index),
                Some(Letter::Boundary) => {}
                letter => {
                    is_damage |= out[0] != out[1] || (out[0] && letter.is_some_and(Letter::drives));
                    has_creases = true;
                }
            }
        }
        let ends = odd_ends(draft).into_iter().filter(|&v| outside[v as usize]).collect();
        Self { lines, ends, is_damage, has_paper, has_creases }
    }

    fn line_at(&self, draft: &Draft, vertex: u32) -> Option<usize> {
        self.lines.iter().copied().find(|&line| draft.edges[line].ends.contains(&vertex))
    }

    fn refusal(&self, draft: &Draft) -> Error {
        let dangling: Vec<u32> = self
            .ends
            .iter()
            .copied()
            .filter(|&v| self.line_at(draft, v).is_some())
            .chain(self.ends.iter().copied())
            .collect();
        let first = dangling.first().copied().unwrap_or_default();
        let line = self.line_at(draft, first).or(self.lines.first().copied()).unwrap_or_default();
        let place = draft.edges[line].origin.place("edges_vertices");
        let point = |v: u32| draft.points[v as usize];
        let others = self.ends.iter().copied().filter(|&v| v != first);
        let nearest =
            others.min_by(|&a, &b| point(a).distance(point(first)).total_cmp(&point(b).distance(point(first))));
        let problem = match nearest {
            Some(other) => format!(
                "the border is open: it ends at vertices_coords[{first}], and next at [{other}], {} away, and the paper between is outside",
                Short(rounded(point(first).distance(point(other)) / draft.scale))
            ),
            None => format!("the border is open: it ends at vertices_coords[{first}]"),
        };
        Error::new(
            ErrorCode::BorderOpen,
            place,
            problem,
            "a border that closes, or a longer distance to join lines within",
        )
    }
}

/// A line that closes a gap.
struct Bridge {
    ends: [u32; 2],
    /// The vertices on it, from end to end.
    stops: Vec<u32>,
}

/// The lines that close the gaps, the shortest first; each end gets one.
fn bridges(draft: &Draft, open: &Open) -> Vec<Bridge> {
    if open.ends.len() > MOST_ENDS {
        return Vec::new();
    }
    let plane = Flat::of(draft);
    let mut pairs: Vec<(f64, [u32; 2])> = Vec::new();
    for (index, &a) in open.ends.iter().enumerate() {
        for &b in &open.ends[index + 1..] {
            if open.line_at(draft, a).or(open.line_at(draft, b)).is_some() {
                pairs.push((plane.length([a, b]), [a, b]));
            }
        }
    }
    pairs.sort_by(|one, two| one.0.total_cmp(&two.0).then(one.1.cmp(&two.1)));
    let mut bridges: Vec<Bridge> = Vec::new();
    for (length, pair) in pairs {
        let taken = bridges.iter().flat_map(|bridge| bridge.ends).any(|v| pair.contains(&v));
        let sensible = length <= SMALL * plane.size
            || plane.runs_on(pair)
            || ((open.has_paper || open.has_creases) && plane.is_on_hull(pair));
        if !taken && sensible {
            bridges.extend(plane.stops(pair).map(|stops| Bridge { ends: pair, stops }));
        }
    }
    bridges
}

/// The lines of a draft in the plane.
struct Flat {
    points: Vec<DVec2>,
    lines: Vec<[u32; 2]>,
    /// The other ends of the boundary edges at each vertex.
    border: Csr<u32>,
    size: f64,
}

impl Flat {
    fn of(draft: &Draft) -> Self {
        let live = || draft.edges.iter().filter(|edge| edge.alias.is_none());
        let boundary = live().filter(|edge| edge.letter == Some(Letter::Boundary));
        let both = boundary.flat_map(|edge| {
            let [a, b] = edge.ends;
            [(a as usize, b), (b as usize, a)]
        });
        Self {
            points: draft.points.iter().map(|point| point.truncate()).collect(),
            lines: live().map(|edge| edge.ends).collect(),
            border: Csr::from_entries(draft.points.len(), both),
            size: extent(&draft.points).max_element(),
        }
    }

    fn at(&self, vertex: u32) -> DVec2 {
        self.points[vertex as usize]
    }

    fn length(&self, [a, b]: [u32; 2]) -> f64 {
        self.at(a).distance(self.at(b))
    }

    /// Whether a boundary edge at either end has the direction of the line between them.
    fn runs_on(&self, [a, b]: [u32; 2]) -> bool {
        let on = |from: u32, to: u32| {
            let ahead = self.at(to) - self.at(from);
            self.border
                .row(from as usize)
                .iter()
                .any(|&v| (self.at(from) - self.at(v)).angle_to(ahead).abs() < STRAIGHT)
        };
        on(a, b) || on(b, a)
    }

    /// Whether all lines lie on one side of it.
    fn is_on_hull(&self, [a, b]: [u32; 2]) -> bool {
        let slack = TOUCH * self.size * self.length([a, b]);
        let sides = self.lines.iter().flatten().map(|&v| orient(self.at(a), self.at(b), self.at(v)));
        let (low, high) = sides.fold((0.0, 0.0), |(low, high), side| (f64::min(low, side), f64::max(high, side)));
        low > -slack || high < slack
    }

    /// The vertices on the line between two, in order; `None` where another line crosses it or runs along it.
    fn stops(&self, pair: [u32; 2]) -> Option<Vec<u32>> {
        let [a, b] = pair.map(|v| self.at(v));
        let share = |v: u32| {
            let point = self.at(v);
            let share = ((point - a).dot(b - a) / a.distance_squared(b)).clamp(0.0, 1.0);
            ((a + share * (b - a)).distance(point) <= TOUCH * self.size).then_some(share)
        };
        let mut stops = vec![(0.0, pair[0]), (1.0, pair[1])];
        for line in &self.lines {
            let on = line.map(|v| if pair.contains(&v) { Some(0.0) } else { share(v) });
            if on[0].is_some() && on[1].is_some() {
                return None;
            }
            let [c, d] = line.map(|v| self.at(v));
            let apart = |p: DVec2, q: DVec2, r: DVec2, s: DVec2| (orient(p, q, r) > 0.0) == (orient(p, q, s) > 0.0);
            if on == [None, None] && !apart(a, b, c, d) && !apart(c, d, a, b) {
                return None;
            }
            let between = line.iter().zip(on).filter(|(v, _)| !pair.contains(v));
            stops.extend(between.filter_map(|(v, share)| Some((share?, *v))));
        }
        stops.sort_by(|one, two| one.0.total_cmp(&two.0).then(one.1.cmp(&two.1)));
        stops.dedup_by_key(|stop| stop.1);
        Some(stops.into_iter().map(|stop| stop.1).collect())
    }
}
