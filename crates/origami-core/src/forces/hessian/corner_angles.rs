//! Corner angles: `sum of (alpha - alpha0)^2 / 2` over the corners of a triangle.
//!
//! The angle at p between `u = q - p` and `v = r - p`, counterclockwise about n, has the gradient `-w/|u|` by u, where
//! `w = n x u / |u|`, and the same with the other sign by v. In the plane this turns with u and shrinks with its length;
//! moving u along n turns n about v, and the gradient with it. With A = `|u x v|` that is
//!
//! ```text
//! d2/du^2 =  (u w^T + w u^T)/|u|^3 + (u . v)/(A |u|^2) n n^T        d2/du dv = -n n^T / A
//! d2/dv^2 = -(v w^T + w v^T)/|v|^3 + (u . v)/(A |v|^2) n n^T
//! ```

use glam::{DMat3, DVec3};

use super::{both, outer};
use crate::forces::corner_angles::Triangle;
use crate::model::CornerAngles;

/// `d2E / dp_i dp_j` per unit of stiffness; `None` where the triangle has collapsed and pulls at nothing.
#[must_use]
pub fn blocks(corners: &CornerAngles, points: [DVec3; 3]) -> Option<[[DMat3; 3]; 3]> {
    let triangle = Triangle::new(points);
    if triangle.collapsed() {
        return None;
    }
    let deviations = triangle.deviations(corners);
    let cross = (points[1] - points[0]).cross(points[2] - points[0]);
    let area = cross.length();
    let n = cross / area;
    let mut blocks = [[DMat3::ZERO; 3]; 3];
    for (p, deviation) in deviations.into_iter().enumerate() {
        let (q, r) = ((p + 1) % 3, (p + 2) % 3);
        let (u, v) = (points[q] - points[p], points[r] - points[p]);
        let (uu, vv, uv) = (u.length_squared(), v.length_squared(), u.dot(v));
        let (wu, wv) = (n.cross(u) / uu, n.cross(v) / vv);
        let nn = outer(n, n);
        let by_u = both(u, wu) * uu.recip() + nn * (uv / (area * uu));
        let by_v = nn * (uv / (area * vv)) - both(v, wv) * vv.recip();
        let by_both = nn * -area.recip();
        // d alpha / dp is minus the two others; the second derivatives follow in the same way.
        let (gu, gv) = (-wu, wv);
        let by_u = outer(gu, gu) + by_u * deviation;
        let by_v = outer(gv, gv) + by_v * deviation;
        let by_both = outer(gu, gv) + by_both * deviation;
        blocks[q][q] += by_u;
        blocks[r][r] += by_v;
        blocks[q][r] += by_both;
        blocks[r][q] += by_both.transpose();
        blocks[q][p] -= by_u + by_both;
        blocks[p][q] -= (by_u + by_both).transpose();
        blocks[r][p] -= by_v + by_both.transpose();
        blocks[p][r] -= (by_v + by_both.transpose()).transpose();
        blocks[p][p] += by_u + by_v + by_both + by_both.transpose();
    }
    Some(blocks)
}
