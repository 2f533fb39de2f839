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
use pairs::Pairs;

/// The number of each triangle's layer times the direction in which layers are counted; empty where none lie upon each
/// other. `positions` by node, in radii.
///
/// More than some twenty thousand pairs of triangles upon each other are left to their depths.
#[must_use]
pub fn layers(model: &Model, positions: &[DVec3]) -> Vec<[f32; 3]> {
    if positions.len() != model.node_count() || positions.iter().any(|p| !p.is_finite()) {
        return Vec::new();
    }
    let Some(pairs) = Pairs::find(model, positions) else { return Vec::new() };
    let mut order = Order::new(&pairs);
    conditions::add(model, positions, &pairs, &mut order);
    order.decide();
    ranks(&pairs, &order)
}

/// Layers counted from the lowest: each triangle is above all that lie under it.
fn ranks(pairs: &Pairs, order: &Order) -> Vec<[f32; 3]> {
    let count = pairs.normals.len();
    let mut above = vec![Vec::new(); count];
    let mut under = vec![0_u32; count];
    for (pair, [i, j]) in pairs.triangles.iter().enumerate() {
        let (low, high) = if order.above(pair) { (*i, *j) } else { (*j, *i) };
        above[low as usize].push(high);
        under[high as usize] += 1;
    }
    let mut rank = vec![0_u32; count];
    let mut left: Vec<u32> = (0..count as u32).filter(|t| !pairs.of(*t as usize).is_empty()).collect();
    let mut ready: Vec<u32> = left.iter().copied().filter(|t| under[*t as usize] == 0).collect();
    let mut done = vec![false; count];
    loop {
        while let Some(low) = ready.pop() {
            if std::mem::replace(&mut done[low as usize], true) {
                continue;
            }
            for high in &above[low as usize] {
                rank[*high as usize] = rank[*high as usize].max(rank[low as usize] + 1);
                under[*high as usize] -= 1;
                if under[*high as usize] == 0 {
                    ready.push(*high);
                }
            }
        }
        // Where layers run in a circle it is cut at the one with the least under it.
        left.retain(|t| !done[*t as usize]);
        let Some(next) = left.iter().copied().min_by_key(|t| under[*t as usize]) else { break };
        ready.push(next);
    }
    let highest = f64::from(rank.iter().copied().max().unwrap_or(0));
    let vector = |t: usize| {
        if pairs.of(t).is_empty() {
            return [0.0; 3];
        }
        let number = f64::from(rank[t]) - 0.5 * highest;
        (pairs.up[t] * number).to_array().map(|x| x as f32)
    };
    (0..count).map(vector).collect()
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

    fn height(layer: [f32; 3], along: DVec3) -> f64 {
        DVec3::from_array(layer.map(f64::from)).dot(along)
    }

    #[test]
    fn what_does_not_lie_upon_itself_has_no_layers() {
        let pattern = BirdBase::default().pattern().unwrap();
        for percent in [0.0, 50.0] {
            let (model, positions) = folded(&pattern, percent);
            assert!(layers(&model, &positions).is_empty(), "{percent} %");
        }
    }

    #[test]
    fn a_valley_lays_the_second_face_on_the_front_of_the_first() {
        for angle in [180.0, -180.0_f64] {
            let pattern = SingleCrease { angle: angle.to_radians(), ..SingleCrease::default() }.pattern().unwrap();
            let (model, positions) = folded(&pattern, 100.0);
            let layers = layers(&model, &positions);
            let crease = model.creases.iter().find(|c| c.goal.abs() > 3.0).unwrap();
            let [Some(one), Some(two)] = model.mesh.sides[crease.side.index()].triangles else { panic!("two faces") };
            let [a, b, c] = model.mesh.triangles[one.index()].map(|n| positions[n.index()]);
            let front = (b - a).cross(c - a).normalize();
            let step = height(layers[two.index()], front) - height(layers[one.index()], front);
            assert!(step * angle.signum() > 0.9, "{angle}: {step}");
        }
    }
}
