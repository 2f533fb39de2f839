//! The outline of each kind of shape.

use kurbo::{Line, PathSeg, Point, Vec2};
use roxmltree::Node;
use svgtypes::NumberListParser;

use super::path;
use super::view::{Along, Viewport};

/// The names of elements that are shapes.
pub(super) const SHAPES: [&str; 7] = ["line", "polyline", "polygon", "rect", "path", "circle", "ellipse"];

/// The outline of a shape in its own coordinates, and what is wrong with it, if anything is. A broken shape is drawn as
/// far as it goes.
pub(super) fn outline(node: Node, viewport: &Viewport) -> (Vec<PathSeg>, Option<&'static str>) {
    let length = |name: &str, along| viewport.length(node, name, along).unwrap_or(0.0);
    let point = |x: &str, y: &str| Point::new(length(x, Along::Width), length(y, Along::Height));
    match node.tag_name().name() {
        "line" => (vec![PathSeg::Line(Line::new(point("x1", "y1"), point("x2", "y2")))], None),
        "polyline" => polyline(node, false),
        "polygon" => polyline(node, true),
        "rect" => (rect(node, viewport), None),
        "path" => {
            let (segments, whole) = path::segments(node.attribute("d").unwrap_or_default());
            (segments, (!whole).then_some("has path data that cannot be read to its end"))
        }
        "circle" => {
            let radius = length("r", Along::Diagonal);
            (round(point("cx", "cy"), Vec2::new(radius, radius)), None)
        }
        _ => (round(point("cx", "cy"), Vec2::new(length("rx", Along::Width), length("ry", Along::Height))), None),
    }
}

fn polyline(node: Node, closed: bool) -> (Vec<PathSeg>, Option<&'static str>) {
    let mut points = Vec::new();
    let mut broken = None;
    let mut numbers = NumberListParser::from(node.attribute("points").unwrap_or_default());
    while let Some(x) = numbers.next() {
        match (x, numbers.next()) {
            (Ok(x), Some(Ok(y))) => points.push(Point::new(x, y)),
            _ => {
                broken = Some("has points that cannot be read to their end");
                break;
            }
        }
    }
    if closed && points.first() != points.last() {
        points.extend(points.first().copied());
    }
    (points.windows(2).map(|ends| PathSeg::Line(Line::new(ends[0], ends[1]))).collect(), broken)
}

fn round(center: Point, radii: Vec2) -> Vec<PathSeg> {
    if radii.x > 0.0 && radii.y > 0.0 { path::ellipse(center, radii) } else { Vec::new() }
}

fn rect(node: Node, viewport: &Viewport) -> Vec<PathSeg> {
    let length = |name: &str, along| viewport.length(node, name, along);
    let [x, y] = [length("x", Along::Width), length("y", Along::Height)].map(Option::unwrap_or_default);
    let [w, h] = [length("width", Along::Width), length("height", Along::Height)].map(Option::unwrap_or_default);
    if !(w > 0.0 && h > 0.0) {
        return Vec::new();
    }
    // One radius stands for both where the other is not given.
    let (rx, ry) = (length("rx", Along::Width), length("ry", Along::Height));
    let [rx, ry] = [rx.or(ry).unwrap_or(0.0).clamp(0.0, 0.5 * w), ry.or(rx).unwrap_or(0.0).clamp(0.0, 0.5 * h)];
    let data = if rx > 0.0 && ry > 0.0 {
        let [straight, up] = [w - 2.0 * rx, h - 2.0 * ry];
        let turn = |dx: f64, dy: f64| format!("a{rx} {ry} 0 0 1 {dx} {dy}");
        let corners = [turn(rx, ry), turn(-rx, ry), turn(-rx, -ry), turn(rx, -ry)];
        let [a, b, c, d] = corners;
        format!("M{} {y}h{straight}{a}v{up}{b}h{}{c}v{}{d}z", x + rx, -straight, -up)
    } else {
        let corners = [(x, y), (x + w, y), (x + w, y + h), (x, y + h), (x, y)].map(Point::from);
        return corners.windows(2).map(|ends| PathSeg::Line(Line::new(ends[0], ends[1]))).collect();
    };
    path::segments(&data).0
}
