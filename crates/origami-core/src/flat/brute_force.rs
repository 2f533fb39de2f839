//! Flat foldings of one vertex, by trying all orders of its layers: what the rules are tested against. It knows none of
//! them, only that paper does not go through itself.

use std::f64::consts::{PI, TAU};

/// Places nearer than this are one.
const NEAR: f64 = 1e-9;

/// In how many orders of its layers a vertex with these sectors folds flat, where crease i lies before sector i and is a
/// valley or a mountain.
pub(super) fn flat_foldings(sectors: &[f64], valleys: &[bool]) -> usize {
    let count = sectors.len();
    // Along the folded circle: crease i at place[i], sector i from there to place[i + 1].
    let mut place = vec![0.0];
    for (i, sector) in sectors.iter().enumerate() {
        place.push(place[i] + if i % 2 == 0 { *sector } else { -sector });
    }
    if count % 2 == 1 || place[count].abs() > NEAR {
        return 0;
    }
    let mut orders = 0;
    permute(&mut (0..count).collect(), 0, &mut |height| orders += usize::from(holds(&place, valleys, height)));
    orders
}

/// Whether the layers at these heights have the letters that are asked and do not go through each other.
fn holds(place: &[f64], valleys: &[bool], height: &[usize]) -> bool {
    let count = valleys.len();
    let before = |crease: usize| (crease + count - 1) % count;
    let between = |x: usize, [a, b]: [usize; 2]| (a.min(b) + 1..a.max(b)).contains(&x);
    let heights = |crease: usize| [height[before(crease)], height[crease]];
    (0..count).all(|crease| {
        let [first, second] = heights(crease);
        // Even sectors lie face up: a valley lays the next one on their face.
        let valley = (second > first) == before(crease).is_multiple_of(2);
        let passes = (0..count).filter(|sector| *sector != crease && *sector != before(crease)).all(|sector| {
            let (low, high) = (place[sector].min(place[sector + 1]), place[sector].max(place[sector + 1]));
            let across = low + NEAR < place[crease] && place[crease] < high - NEAR;
            !(across && between(height[sector], [first, second]))
        });
        // Two creases at one place that open to the same side may lie in each other, but not half.
        let nests = (0..crease).filter(|other| (place[*other] - place[crease]).abs() < NEAR).all(|other| {
            let same_side = other % 2 == crease % 2;
            let inside = heights(other).map(|layer| between(layer, [first, second]));
            !same_side || inside[0] == inside[1]
        });
        valley == valleys[crease] && passes && nests
    })
}

fn permute(order: &mut Vec<usize>, fixed: usize, seen: &mut dyn FnMut(&[usize])) {
    if fixed == order.len() {
        return seen(order);
    }
    for i in fixed..order.len() {
        order.swap(fixed, i);
        permute(order, fixed + 1, seen);
        order.swap(fixed, i);
    }
}

/// Sectors that obey Kawasaki's rule, no two of them equal.
pub(super) fn kawasaki_sectors(count: usize, seed: u64) -> Vec<f64> {
    let random = |i: usize| (0.5 + 0.5 * (12.9898 * (seed as f64 + 1.0) + 78.233 * (i as f64 + 1.0)).sin()).abs();
    let mut sectors: Vec<f64> = (0..count).map(|i| 0.3 + random(i)).collect();
    for parity in [0, 1] {
        let sum: f64 = sectors.iter().skip(parity).step_by(2).sum();
        sectors.iter_mut().skip(parity).step_by(2).for_each(|sector| *sector *= PI / sum);
    }
    sectors
}

/// So many equal sectors.
pub(super) fn equal_sectors(count: usize) -> Vec<f64> {
    vec![TAU / count as f64; count]
}
