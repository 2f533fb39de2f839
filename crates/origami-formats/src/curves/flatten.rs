//! Curves in straight pieces.

use glam::DVec2;
use kurbo::{ParamCurve, PathSeg, Point};
use origami_core::error::Error;

use super::Stroke;

/// How far pieces may be from their curve where nothing is said, in sizes of the pattern.
const TOLERANCE: f64 = 1e-3;

/// The tolerance in the units of the file.
pub(super) fn tolerance(strokes: &[Stroke], given: Option<f64>) -> Result<f64, Error> {
    match given {
        Some(tolerance) if tolerance > 0.0 && tolerance.is_finite() => Ok(tolerance),
        Some(tolerance) => Err(Error::invalid("curve-tolerance", format!("is {tolerance}"), "a length above 0")),
        None => Ok(TOLERANCE * size(strokes)),
    }
}

/// The longer side of the box around all ends and control points.
fn size(strokes: &[Stroke]) -> f64 {
    let points = strokes.iter().flat_map(|stroke| &stroke.path).flat_map(|segment| match segment {
        PathSeg::Line(line) => vec![line.p0, line.p1],
        PathSeg::Quad(quad) => vec![quad.p0, quad.p1, quad.p2],
        PathSeg::Cubic(cubic) => vec![cubic.p0, cubic.p1, cubic.p2, cubic.p3],
    });
    let (low, high) =
        points.map(vector).fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
    (high - low).max_element()
}

pub(super) fn vector(point: Point) -> DVec2 {
    DVec2::new(point.x, point.y)
}

/// The pieces of a path, each connected run as its points.
pub(super) fn points(path: &[PathSeg], tolerance: f64) -> Vec<Vec<DVec2>> {
    let mut runs: Vec<Vec<DVec2>> = Vec::new();
    for segment in path {
        let start = vector(segment.start());
        if runs.last().and_then(|run| run.last()) != Some(&start) {
            runs.push(vec![start]);
        }
        let count = pieces(segment, tolerance);
        if let Some(run) = runs.last_mut() {
            run.extend((1..=count).map(|i| vector(segment.eval(i as f64 / count as f64))));
        }
    }
    runs
}

fn pieces(segment: &PathSeg, tolerance: f64) -> usize {
    // A polynomial is off its chord by at most an eighth of its greatest second derivative.
    let bend = match segment {
        PathSeg::Line(_) => return 1,
        PathSeg::Quad(q) => 2.0 * ((q.p2 - q.p1) - (q.p1 - q.p0)).hypot(),
        PathSeg::Cubic(c) => {
            let at_start = (c.p2 - c.p1) - (c.p1 - c.p0);
            let at_end = (c.p3 - c.p2) - (c.p2 - c.p1);
            6.0 * at_start.hypot().max(at_end.hypot())
        }
    };
    ((bend / (8.0 * tolerance)).sqrt().ceil() as usize).clamp(1, 10_000)
}
