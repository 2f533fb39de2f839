//! Path data as straight and Bezier segments.

use std::f64::consts::PI;

use kurbo::{Arc, CubicBez, Line, PathEl, PathSeg, Point, QuadBez, Shape, SvgArc, Vec2};
use svgtypes::{PathParser, PathSegment};

/// Arcs become cubics that are off by at most so many radii: nothing at all beside the tolerance of curves.
const ARC: f64 = 1e-7;
/// Arcs beyond these sizes are straight: squares of lengths would overflow or vanish.
const ARCS: std::ops::Range<f64> = 1e-40..1e40;

/// The segments of path data, as far as it can be read, and whether it can be to its end.
pub(super) fn segments(data: &str) -> (Vec<PathSeg>, bool) {
    let mut pen = Pen::default();
    for segment in PathParser::from(data) {
        match segment {
            Ok(segment) => pen.draw(segment),
            // What stands before a mistake is drawn, as everywhere.
            Err(_) => return (pen.segments, false),
        }
    }
    (pen.segments, true)
}

/// The segments of an ellipse.
pub(super) fn ellipse(center: Point, radii: Vec2) -> Vec<PathSeg> {
    let mut pen = Pen::default();
    let at = |angle: f64| center + Vec2::new(radii.x * angle.cos(), radii.y * angle.sin());
    pen.start = at(0.0);
    pen.at = pen.start;
    for quarter in 0..4 {
        let arc =
            Arc { center, radii, start_angle: f64::from(quarter) * PI / 2.0, sweep_angle: PI / 2.0, x_rotation: 0.0 };
        let to = if quarter == 3 { pen.start } else { at(f64::from(quarter + 1) * PI / 2.0) };
        pen.arc(&arc, to);
    }
    pen.segments
}

#[derive(Debug, Default)]
struct Pen {
    segments: Vec<PathSeg>,
    /// Where the subpath begins.
    start: Point,
    at: Point,
    /// The last control point of a cubic and of a quadratic just before.
    cubic: Option<Point>,
    quadratic: Option<Point>,
}

impl Pen {
    fn draw(&mut self, segment: PathSegment) {
        let from = if segment.is_abs() { Vec2::ZERO } else { self.at.to_vec2() };
        let point = |x: f64, y: f64| Point::new(x, y) + from;
        let reflected = |control: Option<Point>| control.map_or(self.at, |control| self.at + (self.at - control));
        let (mut cubic, mut quadratic) = (None, None);
        match segment {
            PathSegment::MoveTo { x, y, .. } => {
                self.start = point(x, y);
                self.at = self.start;
            }
            PathSegment::LineTo { x, y, .. } => self.line(point(x, y)),
            PathSegment::HorizontalLineTo { x, .. } => self.line(Point::new(x + from.x, self.at.y)),
            PathSegment::VerticalLineTo { y, .. } => self.line(Point::new(self.at.x, y + from.y)),
            PathSegment::CurveTo { x1, y1, x2, y2, x, y, .. } => {
                cubic = Some(point(x2, y2));
                self.cubic(point(x1, y1), point(x2, y2), point(x, y));
            }
            PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
                cubic = Some(point(x2, y2));
                self.cubic(reflected(self.cubic), point(x2, y2), point(x, y));
            }
            PathSegment::Quadratic { x1, y1, x, y, .. } => {
                quadratic = Some(point(x1, y1));
                self.quadratic(point(x1, y1), point(x, y));
            }
            PathSegment::SmoothQuadratic { x, y, .. } => {
                let control = reflected(self.quadratic);
                quadratic = Some(control);
                self.quadratic(control, point(x, y));
            }
            PathSegment::EllipticalArc { rx, ry, x_axis_rotation, large_arc, sweep, x, y, .. } => {
                let to = point(x, y);
                let x_rotation = x_axis_rotation.to_radians();
                let sized = [rx.abs(), ry.abs(), self.at.distance(to)].iter().all(|length| ARCS.contains(length));
                let arc = SvgArc { from: self.at, to, radii: Vec2::new(rx, ry), x_rotation, large_arc, sweep };
                match Arc::from_svg_arc(&arc).filter(|_| sized) {
                    Some(arc) => self.arc(&arc, to),
                    None => self.line(to),
                }
            }
            PathSegment::ClosePath { .. } => {
                self.line(self.start);
            }
        }
        (self.cubic, self.quadratic) = (cubic, quadratic);
    }

    fn push(&mut self, segment: PathSeg, to: Point) {
        self.at = to;
        self.segments.push(segment);
    }

    fn line(&mut self, to: Point) {
        if to != self.at {
            self.push(PathSeg::Line(Line::new(self.at, to)), to);
        }
    }

    fn cubic(&mut self, one: Point, two: Point, to: Point) {
        self.push(PathSeg::Cubic(CubicBez::new(self.at, one, two, to)), to);
    }

    fn quadratic(&mut self, control: Point, to: Point) {
        self.push(PathSeg::Quad(QuadBez::new(self.at, control, to)), to);
    }

    /// An arc, whose last point is exactly `to`.
    fn arc(&mut self, arc: &Arc, to: Point) {
        let radius = arc.radii.x.abs().max(arc.radii.y.abs());
        let first = self.segments.len();
        for element in arc.path_elements(ARC * radius) {
            if let PathEl::CurveTo(one, two, end) = element {
                self.cubic(one, two, end);
            }
        }
        self.at = to;
        match self.segments[first..].last_mut() {
            Some(PathSeg::Cubic(last)) => last.p3 = to,
            _ => self.line(to),
        }
    }
}

#[cfg(test)]
mod tests {
    use kurbo::{ParamCurve, ParamCurveArclen};

    use super::*;

    fn ends(data: &str) -> Vec<[f64; 4]> {
        let (segments, whole) = segments(data);
        assert!(whole, "{data}");
        segments.iter().map(|s| [s.start().x, s.start().y, s.end().x, s.end().y]).collect()
    }

    #[test]
    fn commands_absolute_and_relative() {
        let absolute = ends("M1 2 L3 4 H5 V6 Z M7 8 9 10");
        assert_eq!(absolute, ends("m1,2 2,2 h2 v2 z m6,6 2,2"));
        assert_eq!(absolute.len(), 5, "the path closes");
        assert_eq!(absolute[3], [5.0, 6.0, 1.0, 2.0]);
        assert_eq!(ends("M0 0 1 0 1 1z l5 5")[3], [0.0, 0.0, 5.0, 5.0], "after z from where it began");
        assert_eq!(ends("M0 0 1 0 1 1 0 0z").len(), 3, "closed already");
    }

    #[test]
    fn smooth_curves_mirror_the_control_point() {
        let (smooth, _) = segments("M0 0 C0 1 1 2 2 2 S4 1 4 0 Q 5 -1 6 0 T 8 0");
        let (plain, _) = segments("M0 0 C0 1 1 2 2 2 C3 2 4 1 4 0 Q5 -1 6 0 Q 7 1 8 0");
        assert_eq!(smooth, plain);
        let (first, _) = segments("M0 0 S1 1 2 0 T 4 0");
        assert_eq!(first[0], PathSeg::Cubic(CubicBez::new((0.0, 0.0), (0.0, 0.0), (1.0, 1.0), (2.0, 0.0))));
        assert_eq!(first[1], PathSeg::Quad(QuadBez::new((2.0, 0.0), (2.0, 0.0), (4.0, 0.0))));
    }

    #[test]
    fn arcs_lie_on_their_ellipse() {
        for radius in [1e-3, 1.0, 1e9] {
            let data = format!("M{radius} 0 A{radius} {radius} 0 1 1 0 {}", -radius);
            let (arc, _) = segments(&data);
            for t in (0..=10).map(|i| f64::from(i) / 10.0) {
                for segment in &arc {
                    let distance = segment.eval(t).to_vec2().hypot();
                    assert!((distance / radius - 1.0).abs() < 2.0 * ARC, "{distance} in place of {radius}");
                }
            }
            let length: f64 = arc.iter().map(|segment| segment.arclen(1e-9 * radius)).sum();
            assert!((length / (1.5 * PI * radius) - 1.0).abs() < 1e-6, "three quarters of a turn: {length}");
            assert_eq!(arc.last().map(ParamCurve::end), Some(Point::new(0.0, -radius)), "ends where it says, exactly");
        }
    }

    #[test]
    fn an_ellipse_closes() {
        let round = ellipse(Point::new(3.0, 4.0), Vec2::new(2.0, 1.0));
        assert_eq!(round.first().map(ParamCurve::start), round.last().map(ParamCurve::end));
        for segment in &round {
            let p = segment.eval(0.37) - Point::new(3.0, 4.0);
            assert!(((p.x / 2.0).powi(2) + p.y.powi(2) - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn what_stands_before_a_mistake_is_drawn() {
        let (before, whole) = segments("M0 0 L1 1 L2 x");
        assert_eq!((before.len(), whole), (1, false));
        for odd in [
            "",
            "M",
            "z",
            "L1 1",
            "M1 1z",
            "M0 0A0 0 0 0 0 1 1",
            "M0 0A1e-200 1e-200 0 0 0 1e-190 0",
            "M0 0A1e300 1 0 1 1 3 4",
            "M0 0A1 1e300 9e99 1 1 1e-170 0",
            "M0 0a1 1 0 0 0 0 0",
            "M1e308 0 L-1e308 1e999",
        ] {
            segments(odd);
        }
    }
}
