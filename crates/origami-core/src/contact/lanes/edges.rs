//! The distance of edges from each other.

use super::{Given, Measured, WIDTH, choose, clamped};
use crate::contact::distance::PARALLEL;

/// Measures two edges each, as [`super::super::distance::of_edges`] does, but for those that are nearly parallel
/// ([`Measured::is_parallel`]).
#[inline(always)]
pub(in crate::contact) fn measure_edges(given: &Given, measured: &mut Measured) {
    for i in 0..WIDTH {
        let [p, q, r, s] = given.points(i);
        let (u, v, w) = (q - p, s - r, p - r);
        let (a, b, c, d, e) = (u.length_squared(), u.dot(v), v.length_squared(), u.dot(w), v.dot(w));
        let det = a * c - b * b;
        let along = clamped((b * e - c * d) / det);
        let t = (b * along + e) / c;
        // Beyond an end of the second edge, that end is the nearest.
        let (before, beyond) = (t < 0.0, t > 1.0);
        let from_end = clamped(choose(before, -d, b - d) / a);
        let first = choose(before | beyond, from_end, along);
        let second = clamped(t);
        measured.set(i, [1.0 - first, first, second - 1.0, -second], w + first * u - second * v, given.closed[i]);
        let sine = det / (a * c);
        measured.sine[i] = choose(sine > 0.0, sine, 0.0);
    }
}

/// Measures those again that are nearly parallel: the four ends are looked at too, each against the other edge.
#[inline(always)]
pub(in crate::contact) fn measure_ends(given: &Given, measured: &mut Measured) {
    for i in 0..WIDTH {
        let [p, q, r, s] = given.points(i);
        let (u, v, w) = (q - p, s - r, p - r);
        let (a, b, c, d, e) = (u.length_squared(), u.dot(v), v.length_squared(), u.dot(w), v.dot(w));
        let det = a * c - b * b;
        let along = choose(det > 0.0, clamped((b * e - c * d) / det), 0.0);
        let t = (b * along + e) / c;
        let (before, beyond) = (t < 0.0, t > 1.0);
        let from_end = clamped(choose(before, -d, b - d) / a);
        let (mut first, mut second) = (choose(before | beyond, from_end, along), clamped(t));
        let mut least = (w + first * u - second * v).length_squared();
        let ends =
            [(0.0, clamped(e / c)), (1.0, clamped((e + b) / c)), (clamped(-d / a), 0.0), (clamped((b - d) / a), 1.0)];
        for (x, y) in ends {
            let square = (w + x * u - y * v).length_squared();
            let nearer = square < least;
            first = choose(nearer, x, first);
            second = choose(nearer, y, second);
            least = choose(nearer, square, least);
        }
        if measured.sine[i] <= PARALLEL {
            measured.set(i, [1.0 - first, first, second - 1.0, -second], w + first * u - second * v, given.closed[i]);
        }
    }
}
