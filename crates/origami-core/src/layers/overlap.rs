//! What two triangles of a plane have in common.

use glam::DVec2;

/// The common part of two triangles (Sutherland and Hodgman, Commun. ACM 17, 1974).
pub(super) fn overlap(a: &[DVec2; 3], b: &[DVec2; 3]) -> Vec<DVec2> {
    clipped(a.to_vec(), b)
}

/// The part of a convex polygon that lies in a triangle.
pub(super) fn clipped(mut clipped: Vec<DVec2>, b: &[DVec2; 3]) -> Vec<DVec2> {
    let turn = (b[1] - b[0]).perp_dot(b[2] - b[0]).signum();
    for i in 0..3 {
        let (start, along) = (b[i], b[(i + 1) % 3] - b[i]);
        let inside = |p: DVec2| turn * along.perp_dot(p - start);
        let before = std::mem::take(&mut clipped);
        for (k, p) in before.iter().enumerate() {
            let q = before[(k + 1) % before.len()];
            let (at_p, at_q) = (inside(*p), inside(q));
            if at_p >= 0.0 {
                clipped.push(*p);
            }
            if (at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0) {
                clipped.push(*p + (q - *p) * (at_p / (at_p - at_q)));
            }
        }
    }
    clipped
}

/// Area over perimeter: how wide a polygon is, rather than how large.
pub(super) fn width(polygon: &[DVec2]) -> f64 {
    let next = |k: usize| polygon[(k + 1) % polygon.len()];
    let perimeter: f64 = polygon.iter().enumerate().map(|(k, p)| p.distance(next(k))).sum();
    let area: f64 = polygon.iter().enumerate().map(|(k, p)| 0.5 * p.perp_dot(next(k))).sum();
    if perimeter > 0.0 { area.abs() / perimeter } else { 0.0 }
}

/// The length of the part of a segment that lies inside a triangle, by more than `margin`.
pub(super) fn length_inside([from, to]: [DVec2; 2], triangle: &[DVec2; 3], margin: f64) -> f64 {
    let turn = (triangle[1] - triangle[0]).perp_dot(triangle[2] - triangle[0]).signum();
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    for i in 0..3 {
        let along = (triangle[(i + 1) % 3] - triangle[i]).normalize_or_zero();
        let inside = |p: DVec2| turn * along.perp_dot(p - triangle[i]) - margin;
        let (at_from, at_to) = (inside(from), inside(to));
        if at_from <= 0.0 && at_to <= 0.0 {
            return 0.0;
        }
        let crossing = at_from / (at_from - at_to);
        if at_from < 0.0 {
            low = low.max(crossing);
        } else if at_to < 0.0 {
            high = high.min(crossing);
        }
    }
    (high - low).max(0.0) * from.distance(to)
}

/// The length over which two segments lie upon each other, nowhere farther apart than `margin`.
pub(super) fn length_shared([a, b]: [DVec2; 2], [c, d]: [DVec2; 2], margin: f64) -> f64 {
    let along = (b - a).normalize_or_zero();
    if [c, d].iter().any(|p| along.perp_dot(*p - a).abs() > margin) {
        return 0.0;
    }
    let (length, [s, t]) = (a.distance(b), [c, d].map(|p| along.dot(p - a)));
    (s.max(t).min(length) - s.min(t).max(0.0)).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points<const N: usize>(points: [[f64; 2]; N]) -> [DVec2; N] {
        points.map(DVec2::from_array)
    }

    #[test]
    fn two_halves_of_a_square_have_a_quarter_in_common() {
        let one = points([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]);
        let two = points([[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]]);
        let common = overlap(&one, &two);
        // A triangle of area 1/4 with sides 1 and twice the root of 1/2.
        let expected = 0.25 / (1.0 + 2.0_f64.sqrt());
        assert!((width(&common) - expected).abs() < 1e-12, "{common:?}");
        let beside = points([[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        assert_eq!(width(&overlap(&one, &beside)), 0.0);
    }

    #[test]
    fn segments_are_measured_inside_and_along() {
        let triangle = points([[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]]);
        assert!((length_inside(points([[-1.0, 0.5], [5.0, 0.5]]), &triangle, 0.0) - 1.5).abs() < 1e-12);
        assert_eq!(length_inside(points([[0.0, 0.0], [2.0, 0.0]]), &triangle, 1e-3), 0.0, "along its side");
        assert!(
            (length_shared(points([[0.0, 0.0], [2.0, 0.0]]), points([[3.0, 0.0], [1.5, 0.0]]), 1e-3) - 0.5).abs()
                < 1e-12
        );
        assert_eq!(length_shared(points([[0.0, 0.0], [2.0, 0.0]]), points([[0.0, 0.0], [2.0, 0.1]]), 1e-3), 0.0);
    }
}
