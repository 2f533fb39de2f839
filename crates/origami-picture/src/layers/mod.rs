//! Layers that lie upon each other: which is on top, where depth cannot tell.
//!
//! A sheet folded flat has no thickness, and what the solver leaves between its layers is rounding. Their order follows
//! from the folds: a valley lays its second face on the front of its first, and paper does not go through paper (the
//! taco and tortilla conditions of J. Justin, 1994, as E. Demaine and J. O'Rourke, Geometric Folding Algorithms, 2007,
//! chapter 12, name them). What they leave open the positions decide.

mod conditions;
mod order;
mod overlap;
mod pairs;

use origami_core::Model;
use origami_core::glam::DVec3;

use order::Order;
pub use pairs::NEAR;
use pairs::{Contact, PARALLEL, Pairs};

/// How a triangle is moved in depth, and nowhere else, so that it is seen to lie where it belongs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Layer {
    /// The unit vector along which layers are counted; zero for a triangle that lies on none.
    pub up: [f32; 3],
    /// By how much each of the triangle's corners is moved along it, in radii.
    pub heights: [f32; 3],
}

/// How far apart layers are drawn that lie upon each other, in radii.
pub const LAYER: f64 = 4e-3;

/// The order of layers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stack {
    /// How each triangle is moved; empty where none lie upon each other.
    pub layers: Vec<Layer>,
    /// Pairs of triangles, the first under the second, that lie upon each other in a circle.
    pub circles: Vec<[u32; 2]>,
}

/// The order of a sheet's layers; `positions` by node, in radii.
///
/// More than some twenty thousand pairs of triangles upon each other are left to their depths.
#[must_use]
pub fn stack(model: &Model, positions: &[DVec3]) -> Stack {
    if positions.len() != model.node_count() || positions.iter().any(|p| !p.is_finite()) {
        return Stack::default();
    }
    let Some(pairs) = Pairs::find(model, positions) else { return Stack::default() };
    let mut order = Order::new(&pairs);
    conditions::add(model, positions, &pairs, &mut order);
    order.decide();
    let circling = circling(&pairs, &order);
    let heights = spread(&pairs, &order, &circling, &welds(model, &pairs));
    let layer = |(t, heights): (usize, [f64; 3])| Layer {
        up: pairs.up[t].to_array().map(|x| x as f32),
        heights: heights.map(|h| h as f32),
    };
    Stack { layers: heights.into_iter().enumerate().map(layer).collect(), circles: circles(&pairs, &order, &circling) }
}

/// Pairs that lie upon each other in a circle, the lower one first; but none of a stack in which paper has gone through
/// paper, where pairs contradict what depth shows.
fn circles(pairs: &Pairs, order: &Order, circling: &[bool]) -> Vec<[u32; 2]> {
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
    (0..pairs.triangles.len()).filter(in_circle).filter(|pair| !tangled[stack(*pair)]).map(upwards).collect()
}

/// Heights of all triangles' corners with which each pair is a [`LAYER`] apart wherever they overlap.
///
/// One number a triangle would not do: the pleats of a twist lie upon each other in a circle, like the flaps of a box. So
/// triangles may tilt, and are pushed apart contact by contact until all have room. Where stiff triangles cannot go around
/// a circle, at least all above it and below it come to lie where they belong.
fn spread(pairs: &Pairs, order: &Order, circling: &[bool], welds: &[[(usize, usize); 2]]) -> Vec<[f64; 3]> {
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
fn welds(model: &Model, pairs: &Pairs) -> Vec<[(usize, usize); 2]> {
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

/// Triangles that are left when those are taken away, again and again, under which or over which nothing lies: those that
/// lie upon each other in a circle, and what lies between two such circles.
fn circling(pairs: &Pairs, order: &Order) -> Vec<bool> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use origami_core::generate::{BirdBase, SingleCrease};
    use origami_core::{CreasePattern, Material, Relax};

    fn folded(pattern: &CreasePattern, percent: f64) -> (Model, Vec<DVec3>) {
        let model = Model::new(pattern, &Material::default()).unwrap();
        let state = Relax::default().fold_from_rest(&model, percent).unwrap().state;
        (model, state.positions)
    }

    /// How far the middle of a triangle is moved.
    fn height(layer: Layer, along: DVec3) -> f64 {
        let mean = layer.heights.iter().sum::<f32>() / 3.0;
        DVec3::from_array(layer.up.map(f64::from)).dot(along) * f64::from(mean)
    }

    #[test]
    fn what_does_not_lie_upon_itself_has_no_layers() {
        let pattern = BirdBase::default().pattern().unwrap();
        for percent in [0.0, 50.0] {
            let (model, positions) = folded(&pattern, percent);
            assert_eq!(stack(&model, &positions), Stack::default(), "{percent} %");
        }
    }

    #[test]
    fn a_valley_lays_the_second_face_on_the_front_of_the_first() {
        for angle in [180.0, -180.0_f64] {
            let pattern = SingleCrease { angle: angle.to_radians(), ..SingleCrease::default() }.pattern().unwrap();
            let (model, positions) = folded(&pattern, 100.0);
            let layers = stack(&model, &positions).layers;
            let crease = model.creases.iter().find(|c| c.goal.abs() > 3.0).unwrap();
            let [Some(one), Some(two)] = model.mesh.sides[crease.side.index()].triangles else { panic!("two faces") };
            let [a, b, c] = model.mesh.triangles[one.index()].map(|n| positions[n.index()]);
            let front = (b - a).cross(c - a).normalize();
            let step = height(layers[two.index()], front) - height(layers[one.index()], front);
            assert!(step * angle.signum() > 0.8 * LAYER, "{angle}: {step}");
        }
    }
}
