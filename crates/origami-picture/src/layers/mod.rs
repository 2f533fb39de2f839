//! Layers that lie upon each other: which is on top, where depth cannot tell.
//!
//! A sheet folded flat has no thickness, and what the solver leaves between its layers is rounding. Their order follows
//! from the folds: a valley lays its second face on the front of its first, and paper does not go through paper (the
//! taco and tortilla conditions of J. Justin, 1994, as E. Demaine and J. O'Rourke, Geometric Folding Algorithms, 2007,
//! chapter 12, name them). What they leave open the positions decide.
//!
//! A state in which nothing crosses by the exact test ([`origami_core::contact`]) has layers of its own, as one that was folded
//! under contact: there heights tell the order, and what lies apart is shown as it lies.
//!
//! Depth buffers are all that renderers need to know: layers are moved apart in depth, by as little as rounding allows, and
//! what hangs on a stack moves with it. So no layer comes before paper that lies in front of its stack.

mod circles;
mod spread;

use origami_core::glam::DVec3;
pub use origami_core::layers::FaceOrder;
use origami_core::layers::conditions;
use origami_core::layers::order::Order;
pub use origami_core::layers::pairs::NEAR;
use origami_core::layers::pairs::{FAR, Pairs};
use origami_core::{Model, State};

/// The order of all pairs of faces that lie upon each other in a state ([`origami_core::layers::face_orders`]). `None` where the
/// sheet is not folded flat, or has too many layers to tell.
#[must_use]
pub fn face_orders(model: &Model, state: &State) -> Option<Vec<FaceOrder>> {
    origami_core::layers::face_orders(model, &state.positions, &state.fold_angles)
}

/// How a triangle is moved in depth, and nowhere else, so that it is seen to lie where it belongs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Layer {
    /// The unit vector along which layers are counted; zero for a triangle that lies on none and hangs on none that does.
    pub up: [f32; 3],
    /// By how much each of the triangle's corners is moved along it, in radii.
    pub heights: [f32; 3],
}

/// How far apart layers are drawn that lie upon each other, in radii: more than rounding, and little enough that a stack
/// of them does not come before what lies in front of it.
pub const LAYER: f64 = 2e-4;

/// The order of layers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stack {
    /// How each triangle is moved; empty where none lie upon each other.
    pub layers: Vec<Layer>,
    /// Pairs of triangles, the first under the second, that lie upon each other in a circle.
    pub circles: Vec<[u32; 2]>,
}

/// The order of a sheet's layers; `positions` by node, in radii, `angles` by crease, in radians. Where there are none, the
/// creases are taken to fold as the pattern asks.
///
/// More than some twenty thousand pairs of triangles upon each other are left to their depths.
#[must_use]
pub fn stack(model: &Model, positions: &[DVec3], angles: &[f64]) -> Stack {
    if positions.len() != model.node_count() || positions.iter().any(|p| !p.is_finite()) {
        return Stack::default();
    }
    let Some(pairs) = Pairs::find(model, positions, angles, FAR) else { return Stack::default() };
    let mut order = Order::new(&pairs);
    conditions::add(model, positions, angles, &pairs, &mut order);
    order.decide();
    let circling = circles::circling(&pairs, &order);
    let mut heights = spread::spread(model, &pairs, &order, &circling);
    let up = spread::hangers(model, &pairs, &mut heights);
    let layer = |(t, heights): (usize, [f64; 3])| Layer {
        up: up[t].to_array().map(|x| x as f32),
        heights: heights.map(|h| h as f32),
    };
    Stack {
        layers: heights.into_iter().enumerate().map(layer).collect(),
        circles: circles::circles(&pairs, &order, &circling),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use origami_core::contact::Contact;
    use origami_core::generate::{BirdBase, SingleCrease, SquareTwist};
    use origami_core::solve::ContactRelax;
    use origami_core::{CreasePattern, Material, Relax, Solver};

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
            assert_eq!(stack(&model, &positions, &[]), Stack::default(), "{percent} %");
        }
    }

    #[test]
    fn a_valley_lays_the_second_face_on_the_front_of_the_first() {
        // A valley folded the other way is a mountain, which its own angles tell.
        for (asked, percent) in [(180.0_f64, 100.0), (-180.0, 100.0), (180.0, -100.0), (-180.0, -100.0)] {
            let angle = asked.copysign(asked * percent);
            let pattern = SingleCrease { angle: asked.to_radians(), ..SingleCrease::default() }.pattern().unwrap();
            let (model, positions) = folded(&pattern, percent);
            let angles = vec![angle.to_radians(); model.creases.len()];
            let layers = stack(&model, &positions, if percent < 0.0 { &angles } else { &[] }).layers;
            let crease = model.creases.iter().find(|c| c.full_target.abs() > 3.0).unwrap();
            let [Some(one), Some(two)] = model.mesh.sides[crease.side.index()].triangles else { panic!("two faces") };
            let [a, b, c] = model.mesh.triangles[one.index()].map(|n| positions[n.index()]);
            let front = (b - a).cross(c - a).normalize();
            let step = height(layers[two.index()], front) - height(layers[one.index()], front);
            assert!(step * angle.signum() > 0.8 * LAYER, "{angle}: {step}");
        }
    }

    /// Every triangle of the bird base is a layer away from all it lies upon, and what both folds of a crease say holds.
    #[test]
    fn layers_of_a_flat_base_are_all_apart() {
        let pattern = BirdBase::default().pattern().unwrap();
        let (model, positions) = folded(&pattern, 100.0);
        let pairs = Pairs::find(&model, &positions, &[], FAR).unwrap();
        let stack = stack(&model, &positions, &[]);
        assert!(pairs.triangles.len() > 20 && stack.circles.is_empty());
        for (pair, contacts) in pairs.contacts.iter().enumerate() {
            let gap = |contact: &origami_core::layers::pairs::Contact| {
                let at = |k: usize| {
                    let heights = stack.layers[pairs.triangles[pair][k] as usize].heights;
                    (0..3).map(|c| contact.weights[k][c] * f64::from(heights[c])).sum::<f64>()
                };
                contact.height + at(1) - at(0)
            };
            let gaps: Vec<f64> = contacts.iter().map(gap).collect();
            let apart = |sign: f64| gaps.iter().all(|gap| sign * gap > 0.8 * LAYER);
            assert!(apart(1.0) || apart(-1.0), "{:?}: {gaps:?}", pairs.triangles[pair]);
        }
    }

    /// A state that contact has folded has its layers where they are seen: none is moved, and no circle is told apart.
    #[test]
    fn layers_that_lie_apart_are_shown_as_they_lie() {
        let pattern = SquareTwist::default().pattern().unwrap();
        let model = Model::new(&pattern, &Material::default()).unwrap();
        let contact = Contact { gap: 3e-3, ..Contact::default() };
        let state = ContactRelax { contact, ..ContactRelax::default() }.fold_from_rest(&model, 100.0).unwrap().state;
        let own = stack(&model, &state.positions, &state.fold_angles);
        let most =
            |stack: &Stack| stack.layers.iter().flat_map(|layer| layer.heights).fold(0.0_f32, |a, b| a.max(b.abs()));
        assert!(!own.layers.is_empty() && own.circles.is_empty());
        assert_eq!(most(&own), 0.0);
        // Without its angles nobody knows that it has not gone through itself.
        let unknown = stack(&model, &state.positions, &[]);
        assert!(!unknown.circles.is_empty() && most(&unknown) > 0.0);
    }

    /// The four pleats of a square twist hold each other down like the flaps of a box.
    #[test]
    fn a_twist_lies_in_a_circle() {
        let pattern = SquareTwist::default().pattern().unwrap();
        let (model, positions) = folded(&pattern, 100.0);
        let circles = stack(&model, &positions, &[]).circles;
        let mut under: Vec<u32> = vec![circles[0][0]];
        // Going up from layer to layer one never comes to an end.
        for _ in 0..50 {
            let last = under[under.len() - 1];
            let next = circles.iter().find(|[low, high]| *low == last && !under.ends_with(&[*high]));
            match next {
                Some([_, high]) => under.push(*high),
                None => break,
            }
        }
        assert!(under.len() == 51, "{under:?}");
    }
}
