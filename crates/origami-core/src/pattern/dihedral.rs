//! Fold angles measured from coordinates.

use glam::DVec3;

/// The fold angle about `edge` between a face with normal `n1`, which runs along the edge, and one with normal `n2`,
/// which runs against it: 0 flat, valley positive, in radians (paper section 2.3, as an arc tangent). The lengths of the
/// normals do not matter; 0 where one vanishes.
pub(crate) fn angle_between(edge: DVec3, n1: DVec3, n2: DVec3) -> f64 {
    let sine = edge.normalize_or_zero().dot(n2.cross(n1));
    sine.atan2(n1.dot(n2))
}

/// The fold angle of crease `p3 p4` between the triangles `p3 p4 p1` and `p4 p3 p2`, in radians, valley positive.
#[must_use]
pub fn fold_angle(p1: DVec3, p2: DVec3, p3: DVec3, p4: DVec3) -> f64 {
    let edge = p4 - p3;
    angle_between(edge, edge.cross(p1 - p3), (p2 - p3).cross(edge))
}

#[cfg(test)]
mod tests {
    use super::fold_angle;
    use glam::DVec3;

    #[test]
    fn a_flap_turned_by_an_angle_measures_that_angle() {
        let (p3, p4, p1) = (DVec3::ZERO, DVec3::new(0.0, 2.0, 0.0), DVec3::new(-1.0, 0.5, 0.0));
        for degrees in [-179.0f64, -90.0, -1e-6, 0.0, 1.0, 60.0, 179.9] {
            let angle = degrees.to_radians();
            // The right-hand flap rises towards the viewer: a valley.
            let p2 = DVec3::new(3.0 * angle.cos(), 0.7, 3.0 * angle.sin());
            assert!((fold_angle(p1, p2, p3, p4) - angle).abs() < 1e-14, "{degrees}");
        }
    }
}
