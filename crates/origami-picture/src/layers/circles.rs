//! Triangles that lie upon each other in a circle.

use origami_core::layers::order::Order;
use origami_core::layers::pairs::Pairs;

use super::LAYER;

/// Pairs that lie upon each other in a circle, the lower one first; but none of a stack in which paper has gone through
/// paper, where pairs contradict what depth shows, and none that is seen as it lies.
pub(super) fn circles(pairs: &Pairs, order: &Order, circling: &[bool]) -> Vec<[u32; 2]> {
    let in_circle = |pair: &usize| pairs.triangles[*pair].iter().all(|t| circling[*t as usize]);
    let stack = |pair: usize| pairs.stacks[pairs.triangles[pair][0] as usize];
    let mut tangled = vec![false; pairs.stacks.len()];
    for pair in (0..pairs.triangles.len()).filter(in_circle) {
        tangled[stack(pair)] |= !pairs.agrees(pair, order.above(pair));
    }
    let upwards = |pair: usize| {
        let [i, j] = pairs.triangles[pair];
        if order.above(pair) { [i, j] } else { [j, i] }
    };
    (0..pairs.triangles.len())
        .filter(in_circle)
        .filter(|pair| !tangled[stack(*pair)] && !pairs.is_apart(*pair, LAYER))
        .map(upwards)
        .collect()
}

/// Triangles that are left when those are taken away, again and again, under which or over which nothing lies: those that
/// lie upon each other in a circle, and what lies between two such circles.
pub(super) fn circling(pairs: &Pairs, order: &Order) -> Vec<bool> {
    let mut left = vec![true; pairs.normals.len()];
    for up in [true, false] {
        let is_over = |pair: usize, t: u32| (pairs.triangles[pair][1] == t) == (order.above(pair) == up);
        let mut under: Vec<usize> = (0..left.len())
            .map(|t| {
                pairs.of(t).iter().filter(|(o, pair)| left[*o as usize] && is_over(*pair as usize, t as u32)).count()
            })
            .collect();
        let mut free: Vec<usize> = (0..left.len()).filter(|t| left[*t] && under[*t] == 0).collect();
        while let Some(t) = free.pop() {
            left[t] = false;
            for (other, pair) in pairs.of(t) {
                let o = *other as usize;
                if left[o] && is_over(*pair as usize, *other) {
                    under[o] -= 1;
                    if under[o] == 0 {
                        free.push(o);
                    }
                }
            }
        }
    }
    left
}
