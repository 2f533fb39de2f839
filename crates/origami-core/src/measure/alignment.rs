//! Distance between two states after the best rigid motion.
//!
//! B. K. P. Horn, Journal of the Optical Society of America A 4 (1987) 629: the rotation that brings one set of points
//! nearest to another in the least squares sense is the eigenvector of a symmetric matrix, as a quaternion. It is never a
//! reflection, which is no rigid motion.

use glam::{DMat3, DQuat, DVec3};

use super::eigen::eigenvectors;

/// How two states differ when one has been laid upon the other.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Alignment {
    /// Largest distance between corresponding points, in the unit of the points.
    pub max: f64,
    /// Root mean square distance.
    pub rms: f64,
    /// The first set of points, moved.
    pub moved: Vec<DVec3>,
}

/// Lays `points` upon `onto` by the rotation and translation of least squares.
///
/// # Panics
/// If the two differ in length.
#[must_use]
pub fn align(points: &[DVec3], onto: &[DVec3]) -> Alignment {
    assert_eq!(points.len(), onto.len(), "two states of one sheet");
    if points.is_empty() {
        return Alignment { max: 0.0, rms: 0.0, moved: Vec::new() };
    }
    let (from, to) = (centroid(points), centroid(onto));
    let covariance = points.iter().zip(onto).fold(DMat3::ZERO, |sum, (p, q)| sum + outer(*p - from, *q - to));
    let (rotation, _) = best_rotation(covariance);
    let moved: Vec<DVec3> = points.iter().map(|p| rotation * (*p - from) + to).collect();
    let distances = || moved.iter().zip(onto).map(|(p, q)| p.distance(*q));
    let rms = (distances().map(|d| d * d).sum::<f64>() / points.len() as f64).sqrt();
    // `f64::max` drops NaN: what is nowhere is not near.
    let max = distances().fold(0.0, |max: f64, d| if d > max || d.is_nan() { d } else { max });
    Alignment { max, rms, moved }
}

fn centroid(points: &[DVec3]) -> DVec3 {
    points.iter().sum::<DVec3>() / points.len() as f64
}

/// The products of the coordinates: `p`'s by column, `q`'s by row.
pub(super) fn outer(p: DVec3, q: DVec3) -> DMat3 {
    DMat3::from_cols(q * p.x, q * p.y, q * p.z)
}

/// The rotation that turns the first points nearest to the second, from the sum of the products of their coordinates, and
/// how clearly it is the best: twice the sum of the two lesser singular values (their difference where the best motion would
/// be a reflection), which is 0 where there is another as good. None, and 0, where the products are not finite.
pub(super) fn best_rotation(covariance: DMat3) -> (DMat3, f64) {
    if !covariance.is_finite() {
        return (DMat3::IDENTITY, 0.0);
    }
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = covariance.to_cols_array_2d();
    let [(largest, [w, x, y, z]), (next, _), ..] = eigenvectors([
        [xx + yy + zz, yz - zy, zx - xz, xy - yx],
        [yz - zy, xx - yy - zz, xy + yx, zx + xz],
        [zx - xz, xy + yx, yy - xx - zz, yz + zy],
        [xy - yx, zx + xz, yz + zy, zz - xx - yy],
    ]);
    (DMat3::from_quat(DQuat::from_xyzw(x, y, z, w).normalize()), largest - next)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape() -> Vec<DVec3> {
        (0..20).map(f64::from).map(|i| DVec3::new((2.1 * i).sin(), (1.3 * i).cos(), (0.7 * i).sin() * 0.4)).collect()
    }

    #[test]
    fn a_rigid_motion_is_undone() {
        let motion = DQuat::from_euler(glam::EulerRot::XYZ, 2.0, -0.7, 1.1);
        let moved: Vec<DVec3> = shape().iter().map(|p| motion * *p + DVec3::new(3.0, -2.0, 5.0)).collect();
        let alignment = align(&moved, &shape());
        assert!(alignment.max < 1e-14 && alignment.rms <= alignment.max, "{alignment:?}");
    }

    #[test]
    fn flat_points_are_laid_upon_each_other() {
        let flat: Vec<DVec3> = shape().iter().map(|p| DVec3::new(p.x, p.y, 0.0)).collect();
        let turned: Vec<DVec3> = flat.iter().map(|p| DQuat::from_rotation_x(1.0) * *p).collect();
        assert!(align(&turned, &flat).max < 1e-14);
    }

    #[test]
    fn a_point_that_is_nowhere_is_not_near() {
        let mut lost = shape();
        lost[7].y = f64::NAN;
        let alignment = align(&lost, &shape());
        assert!(alignment.max.is_nan() && alignment.rms.is_nan());
    }

    #[test]
    fn a_reflection_and_a_dent_are_seen() {
        let mirrored: Vec<DVec3> = shape().iter().map(|p| DVec3::new(-p.x, p.y, p.z)).collect();
        assert!(align(&mirrored, &shape()).max > 0.1, "a mirror image is another shape");
        let mut dented = shape();
        dented[3].z += 0.5;
        let alignment = align(&dented, &shape());
        assert!(alignment.max > 0.4 && alignment.max < 0.5, "the dent is shared out a little: {}", alignment.max);
    }
}
