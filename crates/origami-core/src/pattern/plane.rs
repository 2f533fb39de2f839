//! Sizes, normals and planes.

use glam::{DVec2, DVec3};

/// Sides of the box along the axes that holds all points; zero without points.
pub(crate) fn extent(points: &[DVec3]) -> DVec3 {
    let Some(&first) = points.first() else { return DVec3::ZERO };
    let (low, high) = points.iter().fold((first, first), |(low, high), &p| (low.min(p), high.max(p)));
    high - low
}

/// Distance of the farthest point from the centre of that box.
pub(crate) fn radius(points: &[DVec3]) -> f64 {
    let low = points.iter().fold(DVec3::INFINITY, |low, &p| low.min(p));
    let centre = low + 0.5 * extent(points);
    points.iter().map(|p| p.distance(centre)).fold(0.0, f64::max)
}

/// Whether all points lie at one height z, to a billionth of their extent.
pub(crate) fn is_flat(points: &[DVec3]) -> bool {
    let extent = extent(points);
    extent.z <= 1e-9 * extent.max_element()
}

/// The power of two that brings a size into [1/2, 1): multiplying by it is exact.
///
/// `size` must be finite, positive and no more than some 300 powers of ten from one.
pub(crate) fn unit_scale(size: f64) -> f64 {
    2f64.powi(-(size.log2().floor() as i32) - 1)
}

/// Twice the area of a polygon, along the normal from which it is seen counterclockwise (Newell).
pub(crate) fn area_vector(corners: impl IntoIterator<Item = DVec3>) -> DVec3 {
    let mut corners = corners.into_iter();
    let (Some(origin), Some(mut previous)) = (corners.next(), corners.next()) else { return DVec3::ZERO };
    let mut sum = DVec3::ZERO;
    for corner in corners {
        sum += (previous - origin).cross(corner - origin);
        previous = corner;
    }
    sum
}

/// Coordinates in the plane of a face, in which it is counterclockwise.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Plane {
    /// The plane z = 0 seen from above: x and y as they are.
    Above,
    /// The plane z = 0 seen from below: y and x.
    Below,
    /// Any other.
    Tilted(DVec3, DVec3),
}

impl Plane {
    /// The plane at right angles to `normal`, which must not be zero; of a `flat` pattern exactly its own.
    pub(crate) fn new(normal: DVec3, flat: bool) -> Self {
        if flat {
            if normal.z < 0.0 { Self::Below } else { Self::Above }
        } else {
            let normal = normal.normalize_or(DVec3::Z);
            let u = normal.any_orthonormal_vector();
            Self::Tilted(u, normal.cross(u))
        }
    }

    /// Where `point` lies in it.
    pub(crate) fn project(self, point: DVec3) -> DVec2 {
        match self {
            Self::Above => DVec2::new(point.x, point.y),
            Self::Below => DVec2::new(point.y, point.x),
            Self::Tilted(u, v) => DVec2::new(point.dot(u), point.dot(v)),
        }
    }
}

/// The exact sign of the area of triangle `a b c`, positive when counterclockwise, times about twice that area.
pub(crate) fn orient(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let coord = |p: DVec2| robust::Coord { x: p.x, y: p.y };
    robust::orient2d(coord(a), coord(b), coord(c))
}

/// A triangle flatter than this, as height over longest side, is a sliver: its corners lie on a line but for rounding.
pub(crate) const SLIVER: f64 = 1e-9;

/// Height over longest side, negative when clockwise; and which corner is opposite to that side.
pub(crate) fn flatness(points: &[DVec2], triangle: [usize; 3]) -> (f64, usize) {
    let [a, b, c] = triangle.map(|corner| points[corner]);
    let squares = [b.distance_squared(c), c.distance_squared(a), a.distance_squared(b)];
    let apex = (0..3).max_by(|&i, &j| squares[i].total_cmp(&squares[j])).unwrap_or(0);
    (orient(a, b, c) / squares[apex], apex)
}
