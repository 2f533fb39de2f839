//! Points where strokes meet curves: both get the same one.

use glam::DVec2;

use super::runs::{Node, Run};

/// A new point in a run.
#[derive(Clone, Copy)]
struct Knot {
    /// After which node.
    piece: usize,
    /// How far along the piece after it, as a fraction.
    part: f64,
    at: DVec2,
    /// How far it is from the piece.
    off: f64,
}

/// Fine pieces that an end may be near to.
const FEW: usize = 256;

/// Gives curves a point where other strokes cross them or end on them. Ends within `tolerance` of a curve are on it: so far
/// may its pieces be from it.
pub(super) fn tie(runs: &mut [Run], tolerance: f64) {
    let mut knots: Vec<Vec<Knot>> = vec![Vec::new(); runs.len()];
    let mut pieces: Vec<(usize, usize)> =
        runs.iter().enumerate().flat_map(|(run, of)| (0..of.nodes.len() - 1).map(move |piece| (run, piece))).collect();
    let ends = |(run, piece): (usize, usize)| [runs[run].nodes[piece].at, runs[run].nodes[piece + 1].at];
    let low = |piece: (usize, usize)| ends(piece)[0].x.min(ends(piece)[1].x) - tolerance;
    pieces.sort_by(|&a, &b| low(a).total_cmp(&low(b)));
    for (index, &one) in pieces.iter().enumerate() {
        let [a, b] = ends(one);
        let (left, right) = (a.x.max(b.x) + tolerance, [a.y.min(b.y) - tolerance, a.y.max(b.y) + tolerance]);
        for &two in pieces[index + 1..].iter().take_while(|&&two| low(two) <= left) {
            let [c, d] = ends(two);
            let apart = c.y.min(d.y) > right[1] || c.y.max(d.y) < right[0];
            let neighbours = one.0 == two.0 && one.1.abs_diff(two.1) <= 1;
            if apart || neighbours || !(runs[one.0].curved || runs[two.0].curved) {
                continue;
            }
            let touching = [(one, two), (two, one)].into_iter().flat_map(|(end, line)| {
                let run = &runs[end.0];
                let is_end =
                    |node: usize| run.nodes[node].kept && (node == 0 || node + 1 == run.nodes.len() || !run.curved);
                [end.1, end.1 + 1]
                    .into_iter()
                    .filter(move |node| is_end(*node))
                    .map(move |node| (run.nodes[node].at, line))
            });
            let mut touched = false;
            for (at, line) in touching.collect::<Vec<_>>() {
                let [from, to] = ends(line);
                let t = ((at - from).dot(to - from) / from.distance_squared(to)).clamp(0.0, 1.0);
                let off = (from + t * (to - from)).distance(at);
                if off <= tolerance {
                    touched = true;
                    if runs[line.0].curved {
                        knots[line.0].push(Knot { piece: line.1, part: t, at, off });
                    }
                }
            }
            if let (false, Some((t, u))) = (touched, crossing([a, b], [c, d])) {
                let at = a + t * (b - a);
                knots[one.0].push(Knot { piece: one.1, part: t, at, off: 0.0 });
                knots[two.0].push(Knot { piece: two.1, part: u, at, off: 0.0 });
            }
        }
    }
    for (run, knots) in runs.iter_mut().zip(knots) {
        if !knots.is_empty() {
            insert(run, knots, tolerance);
        }
    }
}

/// At which fractions of their lengths two pieces cross.
fn crossing([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> Option<(f64, f64)> {
    let (one, two) = (b - a, d - c);
    let turn = one.perp_dot(two);
    let (t, u) = ((c - a).perp_dot(two) / turn, (c - a).perp_dot(one) / turn);
    (turn != 0.0 && (0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&u)).then_some((t, u))
}

/// Puts knots into a run. Those near a kept point are left to it, as the ends of strokes that nearly meet are joined where the
/// pattern is made; fine points near a knot give way to it.
fn insert(run: &mut Run, mut knots: Vec<Knot>, tolerance: f64) {
    let old = std::mem::take(&mut run.nodes);
    // An end near a curve is near several of its fine pieces: the nearest has it.
    knots.sort_by(|a, b| a.off.total_cmp(&b.off));
    let mut nearest: Vec<Knot> = Vec::with_capacity(knots.len());
    for knot in knots {
        let one = |other: &Knot| {
            let apart = other.piece.abs_diff(knot.piece);
            let near = old[other.piece].at.distance(old[knot.piece].at) <= 4.0 * tolerance;
            other.at == knot.at && (apart <= 1 || (apart < FEW && near))
        };
        if !nearest.iter().any(one) {
            nearest.push(knot);
        }
    }
    nearest.sort_by(|a, b| a.piece.cmp(&b.piece).then(a.part.total_cmp(&b.part)));
    let near_kept = |at: DVec2| old.iter().any(|node| node.kept && node.at.distance(at) <= tolerance);
    let mut knots = nearest.into_iter().filter(|knot| !near_kept(knot.at)).peekable();
    for (index, node) in old.iter().enumerate() {
        push(&mut run.nodes, *node, tolerance);
        while let Some(Knot { at, .. }) = knots.next_if(|knot| knot.piece == index) {
            push(&mut run.nodes, Node { at, kept: true }, tolerance);
        }
    }
}

/// Appends a point, unless it is one with the last.
fn push(nodes: &mut Vec<Node>, node: Node, tolerance: f64) {
    let near = |other: &Node| other.at.distance(node.at) <= 0.5 * tolerance;
    while node.kept && nodes.last().is_some_and(|last| !last.kept && near(last)) {
        nodes.pop();
    }
    if !nodes.last().is_some_and(|last| last.kept && near(last)) {
        nodes.push(node);
    }
}
