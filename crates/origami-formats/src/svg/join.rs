//! How near ends of lines must be in a drawing to be meant to meet.

use kurbo::{ParamCurve, PathSeg};

use crate::curves::Stroke;

/// The reference program's distance, in user units.
const UNITS: f64 = 3.0;
/// But no more than this, in sizes of the drawing: a hundredth of a millimetre is not joined in a stamp.
const SIZES: f64 = 1.0 / 250.0;
/// Nor more than this, in lengths of the shortest line, so that none vanishes.
const LINES: f64 = 0.5;
/// Ends nearer than this, in sizes, are joined anyway.
const ROUNDING: f64 = 2e-6;

/// The distance, if there are ends that it would join; drawings whose ends meet are left to what holds for all formats. With
/// curves, which have a tolerance of their own, there is none.
pub(super) fn distance(strokes: &[Stroke]) -> Option<f64> {
    let mut ends = Vec::new();
    let mut shortest = f64::INFINITY;
    for segment in strokes.iter().flat_map(|stroke| &stroke.path) {
        let PathSeg::Line(line) = segment else { return None };
        let length = line.p0.distance(line.p1);
        if length > 0.0 {
            shortest = shortest.min(length);
        }
        ends.extend([segment.start(), segment.end()]);
    }
    let extent = |of: fn(&kurbo::Point) -> f64| {
        let values = ends.iter().map(of);
        values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min)
    };
    let size = extent(|end| end.x).max(extent(|end| end.y));
    let join = UNITS.min(SIZES * size).min(LINES * shortest);
    ends.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    ends.dedup();
    let near = |(index, end): (usize, &kurbo::Point)| {
        let rest = ends[index + 1..].iter().take_while(|other| other.x - end.x <= join);
        rest.into_iter().any(|other| (ROUNDING * size..=join).contains(&other.distance(*end)))
    };
    (join > ROUNDING * size && ends.iter().enumerate().any(near)).then_some(join)
}
