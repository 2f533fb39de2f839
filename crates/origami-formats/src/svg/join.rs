//! How near ends of lines must be in a drawing to be meant to meet.

use std::collections::BTreeMap;

use kurbo::{ParamCurve, PathSeg, Point};

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
    let low = |of: fn(&Point) -> f64| ends.iter().map(of).fold(f64::INFINITY, f64::min);
    let high = |of: fn(&Point) -> f64| ends.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
    let corner = Point::new(low(|end| end.x), low(|end| end.y));
    let size = (high(|end| end.x) - corner.x).max(high(|end| end.y) - corner.y);
    let join = UNITS.min(SIZES * size).min(LINES * shortest);
    let rounding = ROUNDING * size;
    (join > rounding && are_near(&ends, corner, rounding, join)).then_some(join)
}

/// Whether two of these points are at least `least` and at most `most` apart. They lie above and to the right of `corner`.
///
/// Of the points of a square cell half of `most` wide, one stands for all: the others are nearer to it than `least`, or
/// there are two. So each point looks at a few others, however many lie in a row or at one place.
fn are_near(points: &[Point], corner: Point, least: f64, most: f64) -> bool {
    let cell = |distance: f64| (distance / (0.5 * most)) as i64;
    let mut first_in: BTreeMap<[i64; 2], Point> = BTreeMap::new();
    for point in points {
        let [x, y] = [cell(point.x - corner.x), cell(point.y - corner.y)];
        for column in x - 2..=x + 2 {
            let mut others = first_in.range([column, y - 2]..=[column, y + 2]);
            if others.any(|(_, other)| (least..=most).contains(&other.distance(*point))) {
                return true;
            }
        }
        first_in.entry([x, y]).or_insert(*point);
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_points_are_found_as_by_a_look_at_all_pairs() {
        let mut seed = 1u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut found = [0, 0];
        for _ in 0..400 {
            let points: Vec<Point> = (0..12).map(|_| Point::new(random() - 0.5, random() - 0.5)).collect();
            let pair = |(index, one): (usize, &Point)| {
                points[index + 1..].iter().any(|two| (1e-9..=0.05).contains(&two.distance(*one)))
            };
            let expected = points.iter().enumerate().any(pair);
            assert_eq!(are_near(&points, Point::new(-0.5, -0.5), 1e-9, 0.05), expected);
            found[usize::from(expected)] += 1;
        }
        assert!(found[0] > 50 && found[1] > 50, "{found:?}");
    }

    #[test]
    fn points_in_a_row_and_at_one_place_are_no_matter() {
        let row = |step: f64| (0..200_000).map(|i| Point::new(0.0, step * f64::from(i))).collect::<Vec<_>>();
        assert!(!are_near(&row(1.5), Point::ZERO, 1e-3, 1.0));
        assert!(are_near(&row(0.9), Point::ZERO, 1e-3, 1.0));
        assert!(!are_near(&row(1e-9), Point::ZERO, 1e-3, 1.0));
    }
}
