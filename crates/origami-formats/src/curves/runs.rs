//! Strokes as points, one after the other.

use glam::DVec2;
use kurbo::{ParamCurve, PathSeg, Point};
use origami_core::error::{Error, ErrorCode, Place};

use super::Stroke;

/// Curves are first cut this much finer than the tolerance, in each direction across them.
const FINER: f64 = 64.0;
/// A curve has at least so many fine pieces, and at most.
const PIECES: [usize; 2] = [12, 4096];
/// More fine pieces than this are refused.
const MOST: usize = 1 << 22;

/// A point of a run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) at: DVec2,
    /// It stays: an end, a corner, where another stroke meets this one, or chosen.
    pub(super) kept: bool,
}

/// Connected pieces of a stroke, all of them straight ones as drawn or all of curves.
#[derive(Clone, Debug)]
pub(super) struct Run {
    /// Which stroke it is a part of.
    pub(super) stroke: usize,
    pub(super) curved: bool,
    pub(super) nodes: Vec<Node>,
}

impl Run {
    pub(super) fn is_curved(&self) -> bool {
        self.curved
    }

    /// Drops the points that are not kept.
    pub(super) fn thin(&mut self) {
        self.nodes.retain(|node| node.kept);
    }
}

pub(super) fn vector(point: Point) -> DVec2 {
    DVec2::new(point.x, point.y)
}

/// The longer side of the box around all ends and control points.
pub(super) fn size(strokes: &[Stroke]) -> f64 {
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let mut hold = |points: &[Point]| {
        for point in points.iter().copied().map(vector) {
            (low, high) = (low.min(point), high.max(point));
        }
    };
    for segment in strokes.iter().flat_map(|stroke| &stroke.path) {
        match segment {
            PathSeg::Line(line) => hold(&[line.p0, line.p1]),
            PathSeg::Quad(quad) => hold(&[quad.p0, quad.p1, quad.p2]),
            PathSeg::Cubic(cubic) => hold(&[cubic.p0, cubic.p1, cubic.p2, cubic.p3]),
        }
    }
    (high - low).max_element()
}

/// All strokes as runs of fine pieces.
///
/// # Errors
/// [`Error::Invalid`] if these are too many: the tolerance is too small.
pub(super) fn of(strokes: &[Stroke], tolerance: f64) -> Result<Vec<Run>, Error> {
    let mut runs: Vec<Run> = Vec::new();
    let mut total = 0;
    for (stroke, drawn) in strokes.iter().enumerate() {
        let mut end = None;
        for segment in &drawn.path {
            let start = vector(ends(segment)[0]);
            let count = pieces(segment, tolerance);
            let curved = count > 1;
            let goes_on =
                end == Some(start) && runs.last().is_some_and(|run| run.stroke == stroke && run.curved == curved);
            if !goes_on {
                runs.push(Run { stroke, curved, nodes: vec![Node { at: start, kept: true }] });
            }
            let Some(run) = runs.last_mut() else { continue };
            if curved && goes_on {
                // Two curves that go on in one direction are one.
                let smooth = run.nodes.len() > 1 && {
                    let before = run.nodes[run.nodes.len() - 2].at;
                    let after = vector(segment.eval(1.0 / count as f64));
                    (start - before).normalize_or_zero().dot((after - start).normalize_or_zero()) > SMOOTH
                };
                if let (true, Some(last)) = (smooth, run.nodes.last_mut()) {
                    last.kept = false;
                }
            }
            run.nodes.extend((1..=count).map(|i| Node {
                at: vector(if i == count { ends(segment)[1] } else { segment.eval(i as f64 / count as f64) }),
                kept: i == count,
            }));
            run.nodes.dedup_by(|next, before| {
                let same = next.at == before.at;
                before.kept |= same && next.kept;
                same
            });
            end = Some(vector(ends(segment)[1]));
            total += count;
            if total > MOST {
                let problem = format!("needs more than {MOST} pieces of the curves");
                let place = Place::from("curve-tolerance");
                return Err(Error::new(ErrorCode::TooManyEntries, place, problem, "a larger tolerance"));
            }
        }
    }
    runs.retain(|run| run.nodes.len() > 1);
    Ok(runs)
}

/// The cosine of the turn between fine pieces above which they are one curve: 10 degrees.
const SMOOTH: f64 = 0.985;

/// Where a segment begins and ends, as it is written: to evaluate it there rounds.
fn ends(segment: &PathSeg) -> [Point; 2] {
    match segment {
        PathSeg::Line(line) => [line.p0, line.p1],
        PathSeg::Quad(quad) => [quad.p0, quad.p2],
        PathSeg::Cubic(cubic) => [cubic.p0, cubic.p3],
    }
}

/// Fine pieces of a segment; 1 if it is as good as straight.
fn pieces(segment: &PathSeg, tolerance: f64) -> usize {
    let (bend, away) = match segment {
        PathSeg::Line(_) => return 1,
        PathSeg::Quad(q) => (2.0 * ((q.p2 - q.p1) - (q.p1 - q.p0)).hypot(), vec![q.p1]),
        PathSeg::Cubic(c) => {
            let at_start = (c.p2 - c.p1) - (c.p1 - c.p0);
            let at_end = (c.p3 - c.p2) - (c.p2 - c.p1);
            (6.0 * at_start.hypot().max(at_end.hypot()), vec![c.p1, c.p2])
        }
    };
    let (from, to) = (vector(ends(segment)[0]), vector(ends(segment)[1]));
    // Control points on the chord: drawing programs write lines as curves.
    let along = (to - from).normalize_or_zero();
    let straight = away.into_iter().map(vector).all(|control| {
        let (at, off) = ((control - from).dot(along), (control - from).perp_dot(along).abs());
        off < STRAIGHT * from.distance(to) && at >= 0.0 && at <= from.distance(to)
    });
    if straight {
        return 1;
    }
    // A polynomial is off its chord by at most an eighth of its greatest second derivative.
    ((FINER * bend / (8.0 * tolerance)).sqrt().ceil() as usize).clamp(PIECES[0], PIECES[1])
}

/// Control points nearer to the chord than this, in its lengths, make a straight line.
const STRAIGHT: f64 = 1e-6;
