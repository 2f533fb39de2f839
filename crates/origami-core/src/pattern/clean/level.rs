//! A flat pattern in a plane other than z = 0, laid into it.

use glam::{DMat3, DVec3};

use crate::pattern::plane::extent;

/// Farther from the plane than this, in sizes, and the points do not lie in one.
const FLAT: f64 = 1e-9;

/// The rotation that brings points that lie in one plane to one height z; `None` where they do not.
///
/// It is seen as who wrote it drew it: with x, y in the order of the alphabet, of the three those two that change most.
/// A pattern in x and z has its x to the right and its z upwards, one in y and z its y to the right.
pub(super) fn turn(points: &[DVec3]) -> Option<DMat3> {
    let first = *points.first()?;
    let size = extent(points).max_element();
    let from_first = || points.iter().map(|&p| p - first);
    let far = from_first().max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))?.try_normalize()?;
    let off = |p: DVec3| p - p.dot(far) * far;
    let beside = from_first().map(off).max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))?;
    if beside.length() <= FLAT * size {
        return None;
    }
    let normal = far.cross(beside).try_normalize()?;
    if from_first().any(|p| p.dot(normal).abs() > FLAT * size) {
        return None;
    }
    // Which axis is seen end on, and from which side the two others run as drawn.
    let [x, y, z] = normal.abs().to_array();
    let faces_viewer = if z >= x && z >= y {
        normal.z
    } else if y >= x {
        -normal.y
    } else {
        normal.x
    };
    let normal = if faces_viewer < 0.0 { -normal } else { normal };
    Some(DMat3::from_cols(far, normal.cross(far), normal).transpose())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_are_seen_as_they_were_drawn() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let in_plane: [fn([f64; 2]) -> DVec3; 4] = [
            |[u, v]| DVec3::new(u, v, 7.0),
            |[u, v]| DVec3::new(u, 7.0, v),
            |[u, v]| DVec3::new(7.0, u, v),
            |[u, v]| DVec3::new(u, v, 0.3 * u - 0.2 * v),
        ];
        for place in in_plane {
            let points = square.map(place);
            let turn = turn(&points).unwrap();
            let [a, b, c, d] = points.map(|p| turn * p);
            assert!((turn.determinant() - 1.0).abs() < 1e-12);
            assert!([b, c, d].iter().all(|p| (p.z - a.z).abs() < 1e-12));
            assert!((b - a).cross(d - a).z > 0.5, "counterclockwise as drawn");
            assert!((c.distance(a) - points[2].distance(points[0])).abs() < 1e-12);
        }
        assert!(turn(&[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.0, 1.0, 1e-3)]).is_none());
        assert!(turn(&[DVec3::ZERO, DVec3::X, 2.0 * DVec3::X]).is_none());
    }
}
