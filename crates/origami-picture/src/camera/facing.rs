//! Where to look at a flat sheet from: its face.

use origami_core::glam::DVec3;

use super::Camera;

/// A sheet is flat if it is no thicker than this, in lengths of its largest side.
const THIN: f64 = 0.05;

impl Camera {
    /// From the face of a sheet that lies flat, folded or not, from the side that the [default](Camera::default) camera is on;
    /// the default camera for any other. A sheet that lies level is seen as crease patterns are drawn, [from the
    /// top](Camera::top).
    ///
    /// `points` are any of the sheet, in any order. Each three that follow one another span a plane: that of the largest such
    /// triangle is the sheet's, if it has one.
    #[must_use]
    pub fn facing(points: impl Iterator<Item = [f32; 3]> + Clone) -> Self {
        let points = points.map(|p| DVec3::from_array(p.map(f64::from)));
        let mut largest = DVec3::ZERO;
        let mut left = points.clone();
        while let (Some(a), Some(b), Some(c)) = (left.next(), left.next(), left.next()) {
            let normal = (b - a).cross(c - a);
            if normal.length_squared() > largest.length_squared() {
                largest = normal;
            }
        }
        let Some(normal) = largest.try_normalize() else { return Self::default() };
        let [_, _, towards] = Self::default().axes();
        let face = if normal.dot(towards) < 0.0 { -normal } else { normal };
        let size = |along: DVec3| {
            let places = points.clone().map(|p| p.dot(along));
            places.clone().fold(f64::NEG_INFINITY, f64::max) - places.fold(f64::INFINITY, f64::min)
        };
        let side = face.any_orthonormal_vector();
        if size(face) > THIN * size(side).max(size(face.cross(side))) {
            return Self::default();
        }
        if face.z.abs() > 0.999 {
            return Self { elevation: 90.0_f64.copysign(face.z), ..Self::top() };
        }
        let elevation = face.z.clamp(-1.0, 1.0).asin().to_degrees();
        Self { azimuth: face.y.atan2(face.x).to_degrees(), elevation, ..Self::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::Frame;

    /// Two triangles of a rectangle with this normal, its second one folded back by so much.
    fn folded(normal: DVec3, back: f64) -> Vec<[f32; 3]> {
        let x = normal.any_orthonormal_vector();
        let y = normal.cross(x);
        let places = [DVec3::ZERO, x * 2.0, y, DVec3::ZERO, y, (x * 0.9 + normal * back).normalize()];
        places.iter().map(|p| p.to_array().map(|x| x as f32)).collect()
    }

    #[test]
    fn a_flat_sheet_is_seen_from_its_face_and_from_the_usual_side() {
        let [_, _, usual] = Camera::default().axes();
        for normal in [DVec3::X, DVec3::new(0.3, -0.5, 0.2), DVec3::new(-0.1, 0.4, -0.9), DVec3::Z, -DVec3::Z] {
            let normal = normal.normalize();
            let camera = Camera::facing(folded(normal, 0.01).into_iter());
            let [_, _, towards] = camera.axes();
            assert!(towards.dot(normal).abs() > 0.999 && towards.dot(usual) > 0.0, "{normal}: {camera:?}");
            let frame = Frame { width: 100, height: 100, margins: [0.0; 4] };
            camera.view(folded(normal, 0.01).into_iter(), &frame).unwrap();
        }
        assert_eq!(Camera::facing(folded(DVec3::Z, 0.0).into_iter()), Camera::top());
    }

    #[test]
    fn any_other_sheet_is_seen_as_usual() {
        assert_eq!(Camera::facing(folded(DVec3::X, 1.0).into_iter()), Camera::default());
        assert_eq!(Camera::facing(std::iter::empty()), Camera::default());
        assert_eq!(Camera::facing([[1.0; 3]; 6].into_iter()), Camera::default());
    }
}
