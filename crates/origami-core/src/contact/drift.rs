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

#[cfg(test)]
mod tests {
    use super::*;

    /// Points by a fixed sequence, with coordinates from -1 to 1.
    fn points(count: usize) -> Vec<DVec3> {
        let mut state = 5_u64;
        let mut next = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from(u32::try_from(state >> 32).expect("32 bits")) / f64::from(1_u32 << 31) - 1.0
        };
        (0..count).map(|_| DVec3::new(next(), next(), next())).collect()
    }

    /// The most that two of these points have come nearer to each other that were `apart` or more, but for what is more.
    fn most(before: &[DVec3], now: &[DVec3], apart: f64) -> f64 {
        let mut most = 0.0_f64;
        for i in 0..before.len() {
            for j in 0..i {
                if (before[i] - before[j]).length() >= apart {
                    most = most.max(apart - (now[i] - now[j]).length());
                }
            }
        }
        most
    }

    #[test]
    fn nothing_comes_nearer_than_that() {
        let before = points(60);
        for (squeeze, noise) in [(0.0, 0.0), (0.3, 0.0), (0.0, 0.1), (0.2, 0.02), (1.5, 0.1)] {
            let beside = points(120);
            let moved = |(p, by): (&DVec3, &DVec3)| {
                let turned = DVec3::new(p.x - 0.1 * p.y, p.y + 0.1 * p.x, p.z);
                turned * (1.0 - squeeze) + noise * *by + DVec3::new(0.4, 0.0, 0.7)
            };
            let now: Vec<DVec3> = before.iter().zip(&beside[60..]).map(moved).collect();
            for apart in [0.2, 0.5, 1.0] {
                let (bound, is) = (nearer(&before, &now, apart), most(&before, &now, apart));
                assert!(is <= bound + 1e-12, "{squeeze} {noise} {apart}: {is}, not {bound}");
            }
        }
    }

    #[test]
    fn what_all_do_together_brings_little_nearer() {
        // A flat sheet that is drawn together, and moved far away.
        let before: Vec<DVec3> = points(50).into_iter().map(|p| DVec3::new(p.x, p.y, 0.0)).collect();
        let now: Vec<DVec3> = before.iter().map(|p| 0.9 * *p + DVec3::new(3.0, 0.0, 1.0)).collect();
        let bound = nearer(&before, &now, 0.01);
        assert!((1e-3..2e-3).contains(&bound), "{bound}");
        assert_eq!(nearer(&before, &before, 0.01), 0.0);
        assert_eq!(nearer(&[], &[], 0.01), 0.0);
    }
}
