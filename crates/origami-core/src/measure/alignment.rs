//! Distance between two states after the best rigid motion.
//!
//! W. Kabsch, Acta Crystallographica A32 (1976) 922: the rotation that brings one set of points nearest to another in the
//! least squares sense, from the singular value decomposition of their covariance. Reflections are not rigid motions.

use glam::DVec3;
use nalgebra::{Matrix3, Vector3};

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
    let mut covariance = Matrix3::zeros();
    for (p, q) in points.iter().zip(onto) {
        covariance += vector(*q - to) * vector(*p - from).transpose();
    }
    let rotation = rotation(covariance);
    let moved: Vec<DVec3> = points
        .iter()
        .map(|p| {
            let turned = rotation * vector(*p - from);
            DVec3::new(turned.x, turned.y, turned.z) + to
        })
        .collect();
    let distances = || moved.iter().zip(onto).map(|(p, q)| p.distance(*q));
    let rms = (distances().map(|d| d * d).sum::<f64>() / points.len() as f64).sqrt();
    // `f64::max` drops NaN: what is nowhere is not near.
    let max = distances().fold(0.0, |max: f64, d| if d > max || d.is_nan() { d } else { max });
    Alignment { max, rms, moved }
}

fn centroid(points: &[DVec3]) -> DVec3 {
    points.iter().sum::<DVec3>() / points.len() as f64
}

fn vector(p: DVec3) -> Vector3<f64> {
    Vector3::new(p.x, p.y, p.z)
}

/// The proper rotation nearest to `covariance`; none where it is not finite.
fn rotation(covariance: Matrix3<f64>) -> Matrix3<f64> {
    let svd = covariance.iter().all(|x| x.is_finite()).then(|| covariance.svd(true, true));
    let Some((Some(u), Some(v_t))) = svd.map(|s| (s.u, s.v_t)) else { return Matrix3::identity() };
    // A reflection would fit better: turn the axis of the smallest singular value, which comes last, back.
    let handedness = (u * v_t).determinant().signum();
    u * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, handedness)) * v_t
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;

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
