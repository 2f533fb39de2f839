//! Planes against distances measured all along the way.

use super::*;
use crate::contact::distance::{of_edges, of_point_and_triangle};
use crate::contact::noise::noise;

fn pair(split: usize, closed: f64) -> Pair {
    Pair { nodes: [0, 1, 2, 3].map(NodeId), split, closed, width: 0.05, eased: 0.0 }
}

/// Two things near each other, and moves: of both alike, by turning and shifting them, and a little of each node's own.
fn case(split: usize, seed: u64) -> ([DVec3; 4], [DVec3; 4]) {
    let mut next = noise(seed);
    let mut vector = || DVec3::new(next(), next(), next());
    let (turn, shift) = (vector(), vector());
    let at: [DVec3; 4] = std::array::from_fn(|i| {
        let place = vector() * DVec3::new(1.0, 1.0, 0.01);
        if i < split { place + 0.03 * DVec3::Z } else { place }
    });
    (at, at.map(|at| 0.05 * (turn.cross(at) + shift) + 0.01 * vector()))
}

/// The least distance on the way of these shares of the moves.
fn least(split: usize, at: [DVec3; 4], by: [DVec3; 4], shares: [f64; 4]) -> f64 {
    let distance = |t: f64| {
        let points = std::array::from_fn(|i| at[i] + t * shares[i] * by[i]);
        let nearest = if split == 1 { of_point_and_triangle(&points) } else { of_edges(&points) };
        nearest.apart.length()
    };
    (0..=200).map(|i| distance(f64::from(i) / 200.0)).fold(f64::INFINITY, f64::min)
}

#[test]
fn no_pair_uses_up_more_of_its_gap_than_it_may() {
    let (mut shortened, mut whole, mut would) = (0, 0, 0);
    for (split, seed) in [1, 2].into_iter().flat_map(|split| (0..2000).map(move |seed| (split, seed))) {
        let (at, by) = case(split, seed);
        let distance = least(split, at, by, [0.0; 4]);
        for closed in [0.0, 0.9 * distance] {
            let pair = pair(split, closed);
            let near = pair.near(0, &at);
            let Some(plane) = Plane::new(&pair, &near, FLOOR, (&at, &by)) else { continue };
            let most = 1.001 * USABLE * near.gap;
            let mut shares = [1.0; 4];
            while !plane.is_free(shares) {
                shares = plane.wanted(shares);
            }
            let kept = |shares| distance - least(split, at, by, shares) <= most;
            assert!(kept(shares), "{split} {seed}, closed at {closed}: {shares:?}");
            assert!(kept(plane.standing), "{split} {seed}, closed at {closed}: {:?} standing", plane.standing);
            #[cfg(feature = "newton")]
            for share in [1.0, 0.4] {
                assert!(kept([share * plane.alike(); 4]), "{split} {seed}, closed at {closed}: alike");
            }
            would += usize::from(!kept([1.0; 4]));
            if shares == [1.0; 4] { whole += 1 } else { shortened += 1 }
        }
    }
    assert!(shortened > 500 && whole > 500 && would > 300, "{shortened} {whole} {would}");
}

#[test]
fn what_turns_together_goes_on_and_what_comes_nearer_does_not() {
    let at = [-DVec3::X, DVec3::X, DVec3::new(0.0, -1.0, -1e-3), DVec3::new(0.0, 1.0, -1e-3)];
    let turned = at.map(|at| 0.02 * DVec3::new(0.6, 0.8, 0.0).cross(at) - 5e-3 * DVec3::Z);
    let (pair, shares) = (pair(2, 0.0), [1.0; 4]);
    let plane = |by: &[DVec3; 4]| Plane::new(&pair, &pair.near(0, &at), FLOOR, (&at, by)).expect("in the way");
    let least = |of: [f64; 4]| of.into_iter().fold(1.0, f64::min);
    let together = plane(&turned);
    assert!(together.is_free(shares) && least(together.standing) < 0.1, "{:?}", together.standing);
    // The one behind comes nearer by twice what it may.
    let nearer = [0, 1, 2, 3].map(|i| turned[i] + if i < 2 { -1e-3 * DVec3::Z } else { DVec3::ZERO });
    let nearer = plane(&nearer);
    assert!(!nearer.is_free(shares));
    let wanted = nearer.wanted(shares);
    assert!(least(wanted) > 0.4 && least(wanted) < 0.6, "{wanted:?}");
    // And where one stays back, the other does not go on through it.
    assert!(!together.is_free([1.0, 1.0, 0.0, 0.0]));
}

#[test]
fn where_rounding_hides_what_lies_between_nothing_moves() {
    // A point on a triangle but for rounding: no direction is known in which they are apart.
    let at = [DVec3::new(0.3, 0.3, 1e-17), DVec3::ZERO, DVec3::X, DVec3::Y];
    for by in [[DVec3::X; 4], [DVec3::Z, -DVec3::Z, -DVec3::Z, -DVec3::Z]] {
        let near = Near { pair: 0, weights: [1.0, -0.4, -0.3, -0.3], normal: DVec3::Z, gap: 1e-17 };
        let by = by.map(|by| 1e-3 * by);
        let plane = Plane::new(&pair(1, 0.0), &near, FLOOR, (&at, &by)).expect("in the way");
        assert!(!plane.is_free([1.0; 4]) && !plane.is_free([0.5; 4]));
        assert_eq!(plane.wanted([1.0; 4]), [0.0; 4]);
        assert!(plane.is_free([0.0; 4]));
    }
}
