//! Entities as paths of straight and curved pieces.

use std::f64::consts::TAU;

use kurbo::{Arc, BezPath, CubicBez, Line, PathSeg, Point, Shape, Vec2};

/// How near the Bezier curves that stand for an arc come to it, as a share of its radius; finer than any tolerance of
/// flattening.
const ARC: f64 = 1e-9;
/// Pieces of one span of a spline that is no Bezier curve.
const PIECES: usize = 64;

/// The straight piece between two points.
pub(super) fn line(from: Point, to: Point) -> Vec<PathSeg> {
    vec![PathSeg::Line(Line::new(from, to))]
}

/// The arc of an ellipse: its centre, half its main axis as a vector, the ratio of the other axis, and the angles along it
/// from which and to which it runs, counterclockwise, in radians. Nothing for one without size.
pub(super) fn arc(centre: Point, main: Vec2, ratio: f64, from: f64, to: f64) -> Vec<PathSeg> {
    let sweep = match (to - from).rem_euclid(TAU) {
        0.0 => TAU,
        sweep => sweep,
    };
    let radius = main.hypot();
    if !(radius > 0.0 && (radius * ratio).is_finite() && sweep.is_finite()) {
        return Vec::new();
    }
    let arc = Arc::new(centre, (radius, radius * ratio), from, sweep, main.atan2());
    arc.to_path(ARC * radius).segments().collect()
}

/// A piece of a polyline: straight, or an arc whose `bulge` is the tangent of a quarter of its angle, counterclockwise.
pub(super) fn bulged(from: Point, to: Point, bulge: f64) -> Vec<PathSeg> {
    let chord = to - from;
    if bulge.abs() < 1e-12 || chord.hypot2() == 0.0 {
        return line(from, to);
    }
    // The centre lies on the perpendicular bisector, to the left of the chord for a bulge below 1.
    let left = Vec2::new(-chord.y, chord.x);
    let centre = from.midpoint(to) + left * ((1.0 - bulge * bulge) / (4.0 * bulge));
    let radius = (from - centre).hypot();
    if !(radius.is_finite() && radius > 0.0) {
        return line(from, to);
    }
    let arc = Arc::new(centre, (radius, radius), (from - centre).atan2(), 4.0 * bulge.atan(), 0.0);
    let mut path: Vec<PathSeg> = arc.to_path(ARC * radius).segments().collect();
    // Its ends are those of the polyline, to the last bit.
    if let Some(PathSeg::Cubic(first)) = path.first_mut() {
        first.p0 = from;
    }
    if let Some(PathSeg::Cubic(last)) = path.last_mut() {
        last.p3 = to;
    }
    path
}

/// A spline by its degree, knots, control points and weights (none are all 1); `None` where these do not belong together.
/// Spans of cubic splines without weights whose knots are full are Bezier curves; others are cut into pieces.
pub(super) fn spline(degree: usize, knots: &[f64], points: &[Point], weights: &[f64]) -> Option<Vec<PathSeg>> {
    let fits = (1..=10).contains(&degree)
        && points.len() > degree
        && knots.len() == points.len() + degree + 1
        && knots.is_sorted()
        && (weights.is_empty() || (weights.len() == points.len() && weights.iter().all(|weight| *weight > 0.0)));
    if !fits {
        return None;
    }
    if degree == 3 && weights.is_empty() && is_bezier(knots) {
        let cubic = |p: &[Point]| PathSeg::Cubic(CubicBez::new(p[0], p[1], p[2], p[3]));
        return Some(points.windows(4).step_by(3).map(cubic).collect());
    }
    let at = |span: usize, t: f64| de_boor(degree, knots, points, weights, span, t);
    let mut path = BezPath::new();
    for span in degree..points.len() {
        let [from, to] = [knots[span], knots[span + 1]];
        if from == to {
            continue;
        }
        if path.elements().is_empty() {
            path.move_to(at(span, from));
        }
        let pieces = if degree == 1 { 1 } else { PIECES };
        (1..=pieces).for_each(|i| path.line_to(at(span, from + (to - from) * i as f64 / pieces as f64)));
    }
    Some(path.segments().collect())
}

/// Whether all knots are there three times, and the ends four times.
fn is_bezier(knots: &[f64]) -> bool {
    let groups: Vec<usize> = knots.chunk_by(|a, b| a == b).map(<[f64]>::len).collect();
    groups.len() > 1
        && groups.iter().enumerate().all(|(i, count)| *count == if i == 0 || i + 1 == groups.len() { 4 } else { 3 })
}

/// The point at `t`, which lies in `span` (de Boor's algorithm, with weights as a third coordinate).
fn de_boor(degree: usize, knots: &[f64], points: &[Point], weights: &[f64], span: usize, t: f64) -> Point {
    let weighted = |i: usize| {
        let weight = weights.get(i).copied().unwrap_or(1.0);
        [points[i].x * weight, points[i].y * weight, weight]
    };
    let mut d: Vec<[f64; 3]> = (span - degree..=span).map(weighted).collect();
    for level in 1..=degree {
        for j in (level..=degree).rev() {
            let i = span - degree + j;
            let [low, high] = [knots[i], knots[i + degree + 1 - level]];
            let share = if high > low { (t - low) / (high - low) } else { 0.0 };
            d[j] = std::array::from_fn(|k| d[j - 1][k] + share * (d[j][k] - d[j - 1][k]));
        }
    }
    let [x, y, weight] = d[degree];
    Point::new(x / weight, y / weight)
}

#[cfg(test)]
mod tests {
    use kurbo::ParamCurve;

    use super::*;

    fn ends(path: &[PathSeg]) -> [Point; 2] {
        [path[0].start(), path[path.len() - 1].end()]
    }

    #[test]
    fn bulges_are_arcs_by_their_definition() {
        let [from, to] = [Point::new(1.0, 2.0), Point::new(5.0, -1.0)];
        // A half circle, a quarter, and more than a half; both ways round.
        for bulge in [1.0, (TAU / 16.0).tan(), 2.0, -1.0, -0.3] {
            let path = bulged(from, to, bulge);
            assert_eq!(ends(&path), [from, to]);
            // The height of the arc over its chord is the bulge times half the chord, to the right of the way for a positive one.
            let chord = to - from;
            let apex = from.midpoint(to) + Vec2::new(chord.y, -chord.x) * (0.5 * bulge);
            let near = path.iter().flat_map(|s| (0..=1000).map(|i| s.eval(f64::from(i) / 1000.0)));
            let nearest = near.map(|p| p.distance(apex)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-2, "{bulge}: {nearest}");
        }
    }

    #[test]
    fn weights_make_a_circle_of_a_quadratic_spline() {
        let half = 0.5f64.sqrt();
        let points = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(Point::from);
        let path = spline(2, &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0], &points, &[1.0, half, 1.0]).expect("a spline");
        assert_eq!(ends(&path), [points[0], points[2]]);
        for segment in &path {
            assert!((segment.start().to_vec2().hypot() - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn a_cubic_of_two_full_spans_is_two_bezier_curves_and_de_boor_agrees() {
        let points: Vec<Point> = (0..7).map(|i| Point::new(f64::from(i), f64::from(i * i % 5))).collect();
        let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0];
        let path = spline(3, &knots, &points, &[]).expect("a spline");
        assert_eq!((path.len(), ends(&path)), (2, [points[0], points[6]]));
        let by_pieces = spline(3, &knots, &points, &[1.0; 7]).expect("a spline");
        for (i, piece) in by_pieces.iter().enumerate() {
            let exact = path[i / PIECES].eval((i % PIECES) as f64 / PIECES as f64);
            assert!(piece.start().distance(exact) < 1e-12, "{i}");
        }
    }

    #[test]
    fn what_does_not_belong_together_is_no_spline() {
        let points = [Point::ZERO; 4];
        assert!(spline(3, &[0.0; 7], &points, &[]).is_none());
        assert!(spline(0, &[0.0; 5], &points, &[]).is_none());
        assert!(spline(3, &[0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0], &points, &[]).is_none());
    }
}
