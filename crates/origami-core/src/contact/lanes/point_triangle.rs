//! The distance of points from triangles.

use super::{Given, Measured, WIDTH, choose};

/// Measures a point and a triangle each, as [`super::super::distance::of_point_and_triangle`] does: all regions are looked
/// at, and the first that holds the nearest point is taken.
#[inline(always)]
pub(in crate::contact) fn measure_points(given: &Given, measured: &mut Measured) {
    for i in 0..WIDTH {
        let [p, a, b, c] = given.points(i);
        let (ab, ac, ap, bp, cp) = (b - a, c - a, p - a, p - b, p - c);
        let (d1, d2) = (ab.dot(ap), ac.dot(ap));
        let (d3, d4) = (ab.dot(bp), ac.dot(bp));
        let (d5, d6) = (ab.dot(cp), ac.dot(cp));
        let (va, vb, vc) = (d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2);
        // Weights of the corners but for their sum: of the inside, then of all that comes before it.
        let (mut u, mut v, mut w, mut sum) = (va, vb, vc, va + vb + vc);
        let mut region = |here: bool, own: [f64; 4]| {
            u = choose(here, own[0], u);
            v = choose(here, own[1], v);
            w = choose(here, own[2], w);
            sum = choose(here, own[3], sum);
        };
        let (along_b, along_c) = (d5 - d6, d4 - d3);
        region((va <= 0.0) & (along_c >= 0.0) & (along_b >= 0.0), [0.0, along_b, along_c, along_c + along_b]);
        region((vb <= 0.0) & (d2 >= 0.0) & (d6 <= 0.0), [-d6, 0.0, d2, d2 - d6]);
        region((d6 >= 0.0) & (d5 <= d6), [0.0, 0.0, 1.0, 1.0]);
        region((vc <= 0.0) & (d1 >= 0.0) & (d3 <= 0.0), [-d3, d1, 0.0, d1 - d3]);
        region((d3 >= 0.0) & (d4 <= d3), [0.0, 1.0, 0.0, 1.0]);
        region((d1 <= 0.0) & (d2 <= 0.0), [1.0, 0.0, 0.0, 1.0]);
        let inverse = 1.0 / sum;
        let (u, v, w) = (u * inverse, v * inverse, w * inverse);
        measured.set(i, [1.0, -u, -v, -w], ap - v * ab - w * ac, given.closed[i]);
    }
}
