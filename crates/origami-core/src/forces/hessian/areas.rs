//! Areas: the second derivatives of `D = |N|`, twice a triangle's area, with `N = (b - a) x (c - a)`.
//!
//! Moving a by x changes N by `(c - b) x x`, and moving b by y as well by `x x y` beyond that. With n = N / D and `J_a` the
//! matrix of the cross product with the side opposite to a that is
//!
//! ```text
//! d2D/da^2 = J_a^T (I - n n^T) J_a / D        d2D/da db = J_a^T (I - n n^T) J_b / D - [n x]
//! ```
//!
//! and so on around the triangle.

use glam::{DMat3, DVec3};

use super::outer;
use crate::forces::areas::Area;
use crate::forces::corner_angles::Triangle;

/// `d2E / dp_i dp_j` of a triangle that has its corners at `points` and is not collapsed.
pub(crate) fn blocks(area: &Area, triangle: &Triangle, points: [DVec3; 3]) -> [[DMat3; 3]; 3] {
    let [a, b, c] = points;
    let doubled_area = triangle.doubled_area();
    let n = (b - a).cross(c - a) / doubled_area;
    let gradient = triangle.area_gradient();
    let turned = [c - b, a - c, b - a].map(cross);
    let across = (DMat3::IDENTITY - outer(n, n)) * doubled_area.recip();
    let (slope, curvature) = (area.slope(doubled_area), area.curvature(doubled_area));
    let mut blocks = [[DMat3::ZERO; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            let second = turned[i].transpose() * across * turned[j];
            let second = match (j + 3 - i) % 3 {
                0 => second,
                1 => second - cross(n),
                _ => second + cross(n),
            };
            blocks[i][j] = outer(gradient[i], gradient[j]) * curvature + second * slope;
        }
    }
    blocks
}

/// The matrix that takes x to `v x x`.
fn cross(v: DVec3) -> DMat3 {
    DMat3::from_cols(v.cross(DVec3::X), v.cross(DVec3::Y), v.cross(DVec3::Z))
}
