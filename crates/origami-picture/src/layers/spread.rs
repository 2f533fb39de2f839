//! Layers pushed apart, so that depth shows their order.

use origami_core::Model;
use origami_core::glam::DVec3;
use origami_core::layers::order::Order;
use origami_core::layers::pairs::{Contact, PARALLEL, Pairs, ROUNDING};

use super::LAYER;

/// Heights of all triangles' corners with which each pair is a [`LAYER`] apart wherever they overlap.
///
/// One number a triangle would not do: the pleats of a twist lie upon each other in a circle, like the flaps of a box. So
/// triangles may tilt, and are pushed apart contact by contact until all have room. Where stiff triangles cannot go around
/// a circle, at least all above it and below it come to lie where they belong. Where the sheet goes on flat over a side,
/// its triangles stay together there: else the line of a layer below would come out at their seam. Pairs that a state has
/// apart by itself keep their heights.
pub(super) fn spread(model: &Model, pairs: &Pairs, order: &Order, circling: &[bool]) -> Vec<[f64; 3]> {
    const SWEEPS: usize = 300;
    let seams = seams(model, pairs, circling);
    let mut heights = counted(pairs, order, circling, &seams);
    for sweep in 0..2 * SWEEPS {
        let mut worst = 0.0_f64;
        for (pair, contacts) in pairs.contacts.iter().enumerate() {
            let [i, j] = pairs.triangles[pair].map(|t| t as usize);
            if sweep >= SWEEPS && circling[i] && circling[j] {
                continue;
            }
            let sign = if order.above(pair) { 1.0 } else { -1.0 };
            let least = least(pairs, pair);
            for Contact { weights: [first, second], height } in contacts {
                let at = |t: usize, weights: &[f64; 3]| (0..3).map(|k| weights[k] * heights[seams[t][k]]).sum::<f64>();
                let lacking = least - sign * (height + at(j, second) - at(i, first));
                if lacking <= ROUNDING {
                    continue;
                }
                worst = worst.max(lacking);
                let squares: f64 = first.iter().chain(second).map(|w| w * w).sum();
                for k in 0..3 {
                    heights[seams[i][k]] -= sign * lacking / squares * first[k];
                    heights[seams[j][k]] += sign * lacking / squares * second[k];
                }
            }
        }
        if worst < 0.1 * LAYER {
            break;
        }
    }
    seams.iter().map(|corners| corners.map(|place| heights[place])).collect()
}

/// How far apart a pair is to be, in radii.
fn least(pairs: &Pairs, pair: usize) -> f64 {
    if pairs.is_apart(pair, LAYER) { 0.0 } else { LAYER }
}

/// To begin with: layers counted from the bottom of each stack, its middle at 0.
fn counted(pairs: &Pairs, order: &Order, circling: &[bool], seams: &[[usize; 3]]) -> Vec<f64> {
    let count = pairs.normals.len();
    let ends = |pair: usize| {
        let [i, j] = pairs.triangles[pair].map(|t| t as usize);
        if order.above(pair) { (i, j) } else { (j, i) }
    };
    let in_line = |pair: usize| pairs.triangles[pair].iter().all(|t| !circling[*t as usize]);
    let mut under = vec![0_usize; count];
    (0..pairs.triangles.len()).filter(|pair| in_line(*pair)).for_each(|pair| under[ends(pair).1] += 1);
    let mut free: Vec<usize> = (0..count).filter(|t| under[*t] == 0).collect();
    let mut levels = vec![0.0_f64; count];
    while let Some(low) = free.pop() {
        for (_, pair) in pairs.of(low).iter().filter(|(_, pair)| in_line(*pair as usize)) {
            let pair = *pair as usize;
            let (bottom, top) = ends(pair);
            if bottom != low {
                continue;
            }
            let gap = pairs.contacts[pair].iter().map(|contact| contact.height.abs()).fold(f64::INFINITY, f64::min);
            levels[top] = levels[top].max(levels[low] + (least(pairs, pair) - gap).max(0.0));
            under[top] -= 1;
            if under[top] == 0 {
                free.push(top);
            }
        }
    }
    let mut highest = vec![0.0_f64; count];
    (0..count).for_each(|t| highest[pairs.stacks[t]] = highest[pairs.stacks[t]].max(levels[t]));
    let mut heights = vec![f64::NEG_INFINITY; 3 * count];
    for (t, corners) in seams.iter().enumerate() {
        let level = levels[t] - 0.5 * highest[pairs.stacks[t]];
        corners.iter().for_each(|place| heights[*place] = heights[*place].max(level));
    }
    heights
}

/// By triangle: where each corner's height is kept. Corners that move together share one place: those at a side over
/// which the sheet goes on flat.
fn seams(model: &Model, pairs: &Pairs, circling: &[bool]) -> Vec<[usize; 3]> {
    let count = pairs.normals.len();
    let mut parents: Vec<usize> = (0..3 * count).collect();
    let root = |parents: &mut Vec<usize>, mut place: usize| {
        while parents[place] != place {
            parents[place] = parents[parents[place]];
            place = parents[place];
        }
        place
    };
    for side in &model.mesh.sides {
        let [Some(one), Some(two)] = side.triangles.map(|t| t.map(|t| t.index())) else { continue };
        let together = pairs.up[one] != DVec3::ZERO && pairs.up[one] == pairs.up[two];
        if !together || circling[one] || circling[two] || pairs.normals[one].dot(pairs.normals[two]) < PARALLEL {
            continue;
        }
        for node in side.nodes {
            let [a, b] = [one, two].map(|t| model.mesh.triangles[t].iter().position(|n| *n == node));
            if let (Some(a), Some(b)) = (a, b) {
                let [a, b] = [3 * one + a, 3 * two + b].map(|place| root(&mut parents, place));
                parents[a.max(b)] = a.min(b);
            }
        }
    }
    (0..count).map(|t| [0, 1, 2].map(|k| root(&mut parents, 3 * t + k))).collect()
}

/// What hangs on a stack without lying in one begins where the stack's layer has been moved to: heights of such triangles,
/// and the direction in which they count.
pub(super) fn hangers(model: &Model, pairs: &Pairs, heights: &mut [[f64; 3]]) -> Vec<DVec3> {
    let mut up = pairs.up.clone();
    for side in &model.mesh.sides {
        let [Some(one), Some(two)] = side.triangles.map(|t| t.map(|t| t.index())) else { continue };
        for (stacked, other) in [(one, two), (two, one)] {
            let along = pairs.up[stacked];
            // One that hangs between two stacks keeps to the first.
            if along == DVec3::ZERO
                || pairs.up[other] != DVec3::ZERO
                || (up[other] != DVec3::ZERO && up[other] != along)
            {
                continue;
            }
            up[other] = along;
            for node in side.nodes {
                let [a, b] = [stacked, other].map(|t| model.mesh.triangles[t].iter().position(|n| *n == node));
                if let (Some(a), Some(b)) = (a, b) {
                    heights[other][b] = heights[stacked][a];
                }
            }
        }
    }
    up
}
