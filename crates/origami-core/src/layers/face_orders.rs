//! The order of a sheet's faces where it is folded flat, as FOLD's `faceOrders` has it.

use std::collections::BTreeMap;

use crate::ids::FaceId;
use crate::model::Model;
use glam::DVec3;

use super::conditions;
use super::order::Order;
use super::pairs::{FAR, Pairs};

/// How far the nodes of a sheet that is folded flat lie apart, at most, across its plane, in radii: more than solvers leave,
/// and less than anything that is not flat. Of a state that has layers of its own nothing is asked but that all triangles are
/// parallel: its layers may be thick.
const FLAT: f64 = 5e-3;

/// Cosine of the largest angle between triangles of such a state: 5 degrees.
const ALIKE: f64 = 0.9962;

/// What two faces that lie upon each other are to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FaceOrder {
    /// The two faces, the first by its number the first here.
    pub faces: [FaceId; 2],
    /// FOLD's: 1 if the first lies on the side of the second that faces the viewer when its corners are seen
    /// counterclockwise, -1 if it lies on the other side, 0 if it lies on both or that cannot be told.
    pub side: i8,
}

/// The order of all pairs of faces that lie upon each other, by their numbers; `positions` by node, in radii, `angles` by crease,
/// in radians. `None` where the sheet is not folded flat, or has too many layers to tell (some twenty thousand pairs of
/// triangles upon each other).
///
/// What folds and the conditions of flat folding leave open, the positions decide. Where that ends in three faces each of which
/// lies on the next, which paper may do but a stack cannot, none of the three pairs is told.
#[must_use]
pub fn face_orders(model: &Model, positions: &[DVec3], angles: &[f64]) -> Option<Vec<FaceOrder>> {
    if positions.len() != model.node_count() {
        return None;
    }
    let thickness = thickness(model, positions)?;
    let pairs = Pairs::find(model, positions, angles, FAR.max(thickness))?;
    if thickness >= FLAT && !pairs.has_own() {
        return None;
    }
    let mut order = Order::new(&pairs);
    conditions::add(model, positions, angles, &pairs, &mut order);
    order.decide();
    Some(told(model, &pairs, &order))
}

/// The order of faces that the answers about their triangles are.
pub(super) fn told(model: &Model, pairs: &Pairs, order: &Order<'_>) -> Vec<FaceOrder> {
    let in_threes = in_threes(pairs, order);
    let mut sides: BTreeMap<[FaceId; 2], i8> = BTreeMap::new();
    for (pair, triangles) in pairs.triangles.iter().enumerate() {
        let mut both = triangles.map(|t| (model.mesh.face_of_triangle[t as usize], t as usize));
        // Whether the first of `both` is above the second.
        let mut above = !order.above(pair);
        if both[0].0 == both[1].0 {
            continue;
        }
        if both[0].0 > both[1].0 {
            both.swap(0, 1);
            above = !above;
        }
        let [_, (_, second)] = both;
        let front_up = pairs.normals[second].dot(pairs.up[second]) > 0.0;
        let side = match above == front_up {
            _ if in_threes[pair] => 0,
            true => 1,
            false => -1,
        };
        let told = sides.entry(both.map(|(face, _)| face)).or_insert(side);
        if *told != side {
            *told = 0;
        }
    }
    sides.into_iter().map(|(faces, side)| FaceOrder { faces, side }).collect()
}

/// By pair: whether it is one of three pairs of three triangles of which each lies on the next.
fn in_threes(pairs: &Pairs, order: &Order<'_>) -> Vec<bool> {
    let mut in_threes = vec![false; pairs.triangles.len()];
    for (pair, [i, j]) in pairs.triangles.iter().enumerate() {
        for (k, on_j) in pairs.of(*j as usize).iter().filter(|(k, _)| k > j) {
            let Some((on_i, _)) = pairs.between(*i, *k) else { continue };
            let [first, second, third] = [pair, *on_j as usize, on_i].map(|pair| order.above(pair));
            if first == second && second != third {
                [pair, *on_j as usize, on_i].into_iter().for_each(|pair| in_threes[pair] = true);
            }
        }
    }
    in_threes
}

/// How far the nodes lie apart across the plane of the largest triangle, in radii; `None` where another triangle is not
/// parallel to it.
fn thickness(model: &Model, positions: &[DVec3]) -> Option<f64> {
    let area = |nodes: &[crate::ids::NodeId; 3]| {
        let [a, b, c] = nodes.map(|n| positions[n.index()]);
        (b - a).cross(c - a)
    };
    let largest =
        model.mesh.triangles.iter().map(area).max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
    let normal = largest?.try_normalize()?;
    let across = |nodes| area(nodes).try_normalize().is_none_or(|own| own.dot(normal).abs() > ALIKE);
    let heights = positions.iter().map(|p| p.dot(normal));
    let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)));
    (high - low < FLAT || model.mesh.triangles.iter().all(across)).then_some(high - low)
}

#[cfg(test)]
mod tests {
    use crate::contact::Contact;
    use crate::fold::Document;
    use crate::generate::catalog;
    use crate::solve::ContactRelax;
    use crate::{CreasePattern, Material, Relax, Solver};
    use glam::{DQuat, DVec2};

    use super::*;
    use crate::solve::State;

    fn face_orders(model: &Model, state: &State) -> Option<Vec<FaceOrder>> {
        super::face_orders(model, &state.positions, &state.fold_angles)
    }

    fn folded(pattern: &CreasePattern, percent: f64) -> (Model, State) {
        let model = Model::new(pattern, &Material::default()).unwrap();
        let state = Relax { tolerance: 1e-6, ..Relax::default() }.fold_from_rest(&model, percent).unwrap().state;
        (model, state)
    }

    /// A strip of panels of these widths, side by side, folded by these letters.
    fn pleats(widths: &[f64], letters: &str) -> CreasePattern {
        let mut xs = vec![0.0];
        widths.iter().for_each(|width| xs.push(xs[xs.len() - 1] + width));
        let count = xs.len();
        let coords: Vec<[f64; 2]> = xs.iter().flat_map(|x| [[*x, 0.0], [*x, 1.0]]).collect();
        let mut edges: Vec<[usize; 2]> = (0..count).map(|i| [2 * i, 2 * i + 1]).collect();
        edges.extend((0..count - 1).flat_map(|i| [[2 * i, 2 * i + 2], [2 * i + 1, 2 * i + 3]]));
        let all: Vec<String> = format!("B{letters}B{}", "BB".repeat(count - 1)).chars().map(String::from).collect();
        let faces: Vec<[usize; 4]> = (0..count - 1).map(|i| [2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1]).collect();
        let text = serde_json::json!({
            "vertices_coords": coords, "edges_vertices": edges, "edges_assignment": all, "faces_vertices": faces,
        });
        let document = Document::from_slice(text.to_string().as_bytes()).unwrap();
        CreasePattern::from_document(&document, 0).unwrap()
    }

    fn triples(orders: &[FaceOrder]) -> Vec<(u32, u32, i8)> {
        orders.iter().map(|order| (order.faces[0].0, order.faces[1].0, order.side)).collect()
    }

    #[test]
    fn a_valley_lays_fronts_upon_each_other_and_a_mountain_backs() {
        for (letter, percent, side) in [("V", 100.0, 1), ("M", 100.0, -1), ("V", -100.0, -1), ("M", -100.0, 1)] {
            let (model, state) = folded(&pleats(&[1.0, 1.0], letter), percent);
            assert_eq!(triples(&face_orders(&model, &state).unwrap()), [(0, 1, side)], "{letter} {percent}");
        }
    }

    /// Each panel of an accordion lies on the one before. The fronts of every second panel look down.
    #[test]
    fn an_accordion_is_a_stack_in_its_order() {
        let (model, state) = folded(&pleats(&[1.0; 5], "VMVM"), 100.0);
        let mut expected = Vec::new();
        for first in 0..5 {
            for second in first + 1..5 {
                // The first is below the second, which looks up if its number is even.
                expected.push((first, second, if second % 2 == 0 { -1 } else { 1 }));
            }
        }
        assert_eq!(triples(&face_orders(&model, &state).unwrap()), expected);
        // As it lies is all one.
        let turned = state.positions.iter().map(|p| DQuat::from_rotation_x(2.0) * *p + DVec3::ONE).collect();
        let turned = State { positions: turned, ..state };
        assert_eq!(triples(&face_orders(&model, &turned).unwrap()), expected);
    }

    /// A letter: the last panel goes over the first two, between which nothing else fits.
    #[test]
    fn what_is_rolled_up_lies_inside() {
        let (model, state) = folded(&pleats(&[1.0, 1.05, 0.95], "VV"), 100.0);
        // Panel 1 in the middle of the pattern looks up at both; 0 and 2 show each other front and back.
        let orders = triples(&face_orders(&model, &state).unwrap());
        let on_middle = |f: u32, g: u32| orders.iter().find(|(a, b, _)| (*a, *b) == (f, g)).unwrap().2;
        assert_eq!((on_middle(0, 1), on_middle(1, 2)), (1, 1));
        assert_ne!(on_middle(0, 2), 0);
    }

    #[test]
    fn what_is_not_folded_flat_has_no_order() {
        let pattern = pleats(&[1.0, 1.0], "V");
        for percent in [0.0, 50.0, 95.0] {
            let (model, state) = folded(&pattern, percent);
            assert_eq!(face_orders(&model, &state), None, "{percent} %");
        }
    }

    /// What contact has laid on each other is told by where it lies, thick paper too; with nothing between the layers but the
    /// solver's tolerance the same follows from the folds.
    #[test]
    fn layers_that_contact_keeps_apart_are_a_stack_as_they_lie() {
        let pattern = pleats(&[1.0; 4], "VMV");
        let (model, free) = folded(&pattern, 100.0);
        let expected = face_orders(&model, &free).unwrap();
        for contact in [Contact { gap: 3e-3, ..Contact::default() }, Contact::thick(0.02)] {
            let solver = ContactRelax { contact, ..ContactRelax::default() };
            let state = solver.fold_from_rest(&model, 100.0).unwrap().state;
            assert_eq!(face_orders(&model, &state).unwrap(), expected, "{contact:?}");
        }
    }

    /// Where points of the plane are covered by several faces, each two of them have an order, and no three a circle.
    #[test]
    fn faces_over_a_point_are_a_stack() {
        for (name, least) in [("bird-base", 1.0), ("miura", 0.5), ("waterbomb", 0.5)] {
            let pattern = catalog::generate(name, &[]).unwrap();
            let (model, state) = folded(&pattern, 100.0);
            let orders = face_orders(&model, &state).unwrap();
            let positions = &state.positions;
            let sides: BTreeMap<[FaceId; 2], i8> = orders.iter().map(|order| (order.faces, order.side)).collect();
            let areas = (0..model.mesh.triangles.len()).map(|t| area(&model, positions, t));
            let normal = areas.fold(DVec3::ZERO, |a, b| if b.length() > a.length() { b } else { a }).normalize();
            let (x, y) = normal.any_orthonormal_pair();
            let flat: Vec<DVec2> = positions.iter().map(|p| DVec2::new(p.dot(x), p.dot(y))).collect();
            let (mut deepest, mut told, mut all) = (0, 0, 0);
            for t in 0..model.mesh.triangles.len() {
                // Points inside of each triangle, away from all symmetries.
                let [a, b, c] = model.mesh.triangles[t].map(|n| flat[n.index()]);
                let point = 0.411 * a + 0.353 * b + 0.236 * c;
                let over = (0..model.mesh.triangles.len()).filter(|other| inside(&model, &flat, *other, point));
                let front = |t: usize| area(&model, positions, t).dot(normal).signum();
                let faces: Vec<(FaceId, f64)> = over.map(|t| (model.mesh.face_of_triangle[t], front(t))).collect();
                deepest = deepest.max(faces.len());
                // 1 where the first is above the second, -1 where it is below.
                let above = |a: (FaceId, f64), b: (FaceId, f64)| {
                    let order = |f, g| f64::from(sides[&[f, g]]);
                    if a.0 < b.0 { order(a.0, b.0) * b.1 } else { -order(b.0, a.0) * a.1 }
                };
                for (i, a) in faces.iter().enumerate() {
                    for (j, b) in faces.iter().enumerate().skip(i + 1).filter(|(_, b)| b.0 != a.0) {
                        let first = above(*a, *b);
                        (told, all) = (told + usize::from(first != 0.0), all + 1);
                        for c in faces.iter().skip(j + 1).filter(|c| c.0 != a.0 && c.0 != b.0) {
                            let circle = first != 0.0 && first == above(*b, *c) && first == above(*c, *a);
                            assert!(!circle, "{name}, over triangle {t}: {a:?} {b:?} {c:?}");
                        }
                    }
                }
            }
            let share = f64::from(told as u32) / f64::from(all as u32);
            assert!(deepest >= 4 && share >= least, "{name}: {deepest} layers, {share} of the pairs are told");
        }
    }

    fn area(model: &Model, positions: &[DVec3], triangle: usize) -> DVec3 {
        let [a, b, c] = model.mesh.triangles[triangle].map(|n| positions[n.index()]);
        (b - a).cross(c - a)
    }

    /// Whether a point lies well inside of a triangle.
    fn inside(model: &Model, flat: &[DVec2], triangle: usize, point: DVec2) -> bool {
        let [a, b, c] = model.mesh.triangles[triangle].map(|n| flat[n.index()]);
        let sides = [(a, b), (b, c), (c, a)].map(|(p, q)| (q - p).normalize().perp_dot(point - p));
        sides.iter().all(|s| *s > 0.01) || sides.iter().all(|s| *s < -0.01)
    }
}
