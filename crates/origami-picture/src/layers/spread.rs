//! Layers pushed apart, so that depth shows their order.

use origami_core::Model;
use origami_core::glam::DVec3;

use super::LAYER;
use super::order::Order;
use super::pairs::{Contact, PARALLEL, Pairs};

/// Heights of all triangles' corners with which each pair is a [`LAYER`] apart wherever they overlap.
///
/// One number a triangle would not do: the pleats of a twist lie upon each other in a circle, like the flaps of a box. So
/// triangles may tilt, and are pushed apart contact by contact until all have room. Where stiff triangles cannot go around
/// a circle, at least all above it and below it come to lie where they belong.
pub(super) fn spread(pairs: &Pairs, order: &Order, circling: &[bool], welds: &[[(usize, usize); 2]]) -> Vec<[f64; 3]> {
    const SWEEPS: usize = 300;
    const WELD: f64 = 0.1;
    let mut heights = vec![[0.0; 3]; pairs.normals.len()];
    for sweep in 0..2 * SWEEPS {
        let mut worst = 0.0_f64;
        for (pair, contacts) in pairs.contacts.iter().enumerate() {
            let [i, j] = pairs.triangles[pair].map(|t| t as usize);
            if sweep >= SWEEPS && circling[i] && circling[j] {
                continue;
            }
            let sign = if order.above(pair) { 1.0 } else { -1.0 };
            for Contact { weights: [first, second], height } in contacts {
                let at = |t: usize, weights: &[f64; 3]| (0..3).map(|k| weights[k] * heights[t][k]).sum::<f64>();
                let lacking = LAYER - sign * (height + at(j, second) - at(i, first));
                if lacking <= 0.0 {
                    continue;
                }
                worst = worst.max(lacking);
                let squares: f64 = first.iter().chain(second).map(|w| w * w).sum();
                for k in 0..3 {
                    heights[i][k] -= sign * lacking / squares * first[k];
                    heights[j][k] += sign * lacking / squares * second[k];
                }
            }
        }
        if worst < 0.1 * LAYER {
            break;
        }
        for [(i, a), (j, b)] in welds.iter().filter(|[one, two]| !circling[one.0] && !circling[two.0]) {
            let apart = heights[*j][*b] - heights[*i][*a];
            heights[*i][*a] += WELD * apart;
            heights[*j][*b] -= WELD * apart;
        }
    }
    heights
}

/// Corners (triangle, and which of its three) that move together: those at a side over which the sheet goes on flat.
pub(super) fn welds(model: &Model, pairs: &Pairs) -> Vec<[(usize, usize); 2]> {
    let mut welds = Vec::new();
    for side in &model.mesh.sides {
        let [Some(one), Some(two)] = side.triangles.map(|t| t.map(|t| t.index())) else { continue };
        let together = pairs.up[one] != DVec3::ZERO && pairs.up[one] == pairs.up[two];
        if !together || pairs.normals[one].dot(pairs.normals[two]) < PARALLEL {
            continue;
        }
        for node in side.nodes {
            let [a, b] = [one, two].map(|t| model.mesh.triangles[t].iter().position(|n| *n == node));
            if let (Some(a), Some(b)) = (a, b) {
                welds.push([(one, a), (two, b)]);
            }
        }
    }
    welds
}
