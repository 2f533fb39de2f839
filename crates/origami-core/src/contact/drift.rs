//! How far things have come towards each other, when most of the way was made by all of them together.

use glam::{DMat3, DVec3};

/// A bound on how much nearer two things may be to each other with the nodes at `now` than they were `before`, of things that
/// were at least `apart` from each other then, in radii.
///
/// The moves of all nodes are compared with the linear map that fits them best, by least squares. Turning it over, a sheet that
/// moves, turns or is drawn together as a whole brings things nearer by what it takes off the distance between them alone, which
/// is little of things that are near each other; what nodes move beside the map may bring them nearer by twice as much.
pub(super) fn nearer(before: &[DVec3], now: &[DVec3], apart: f64) -> f64 {
    let count = before.len().max(1) as f64;
    let middle = before.iter().sum::<DVec3>() / count;
    let shift = before.iter().zip(now).map(|(b, n)| *n - *b).sum::<DVec3>() / count;
    let (mut places, mut moves) = (DMat3::ZERO, DMat3::ZERO);
    for (b, n) in before.iter().zip(now) {
        let (from, by) = (*b - middle, *n - *b - shift);
        places += outer(from, from);
        moves += outer(by, from);
    }
    // Of a flat sheet nothing is known across it.
    let size = places.x_axis.x + places.y_axis.y + places.z_axis.z;
    let map = moves * (places + DMat3::from_diagonal(DVec3::splat(FLAT * size))).inverse();
    let (mut plain, mut beside) = (0.0_f64, 0.0_f64);
    for (b, n) in before.iter().zip(now) {
        let by = *n - *b;
        plain = plain.max(by.length_squared());
        beside = beside.max((by - shift - map * (*b - middle)).length_squared());
    }
    let together = map.to_cols_array().iter().map(|x| x * x).sum::<f64>().sqrt();
    let by_map = 2.0 * beside.sqrt() + together * apart;
    // Not where it draws everything to a point, nor where it is no map.
    if together < 1.0 { by_map.min(2.0 * plain.sqrt()) } else { 2.0 * plain.sqrt() }
}

/// What is added to the spread of the nodes in each direction, as a share of all of it.
const FLAT: f64 = 1e-9;

/// The matrix of `a` times the transpose of `b`.
fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}
