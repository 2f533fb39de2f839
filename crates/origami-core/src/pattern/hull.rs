//! The convex hull of points in the plane.

use glam::DVec2;

use super::plane::orient;

/// The area of the convex hull of `points`.
pub(super) fn area(points: impl Iterator<Item = DVec2>) -> f64 {
    let mut points: Vec<DVec2> = points.collect();
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    let half = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut hull: Vec<DVec2> = Vec::new();
        for point in points {
            while let [.., a, b] = hull[..]
                && orient(a, b, point) <= 0.0
            {
                hull.pop();
            }
            hull.push(point);
        }
        hull
    };
    let (low, high) = (half(&mut points.iter().copied()), half(&mut points.iter().rev().copied()));
    let origin = points.first().copied().unwrap_or_default();
    let below = |hull: &[DVec2]| hull.windows(2).map(|side| (side[0] - origin).perp_dot(side[1] - origin)).sum::<f64>();
    0.5 * (below(&low) + below(&high))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_square_and_what_lies_in_it() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0], [1.0, 0.0], [2.0, 2.0]];
        assert_eq!(area(square.into_iter().map(DVec2::from)), 4.0);
        assert_eq!(area([[0.0, 0.0], [1.0, 0.0]].into_iter().map(DVec2::from)), 0.0);
        assert_eq!(area(std::iter::empty()), 0.0);
        // Against the area of a circle.
        let circle = (0..1000).map(|i| DVec2::from_angle(f64::from(i) * 0.618 * std::f64::consts::TAU));
        assert!((area(circle) - std::f64::consts::PI).abs() < 1e-3);
    }
}
