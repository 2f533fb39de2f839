//! An order of the layers of the exact flat-folded sheet.

use std::collections::BTreeSet;

use glam::{DVec2, DVec3};

use super::conditions;
use super::face_orders::{FaceOrder, told};
use super::order::Order;
use super::pairs::{FAR, Pairs};
use super::search::NoOrder;
use crate::ids::{FaceId, TriangleId};
use crate::model::Model;

/// Which triangle lies on which in a sheet that is folded flat, so that paper goes through no paper.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Stacking {
    /// Pairs of triangles that lie upon each other, the lower one first, seen from where z points to.
    pub triangles: Vec<[TriangleId; 2]>,
    /// The same of faces, as FOLD's `faceOrders` has it.
    pub faces: Vec<FaceOrder>,
    /// The pairs of faces, those of `faces`, that another order has the other way round, or that may be so as far as was found out.
    /// None: it is the only order.
    pub free: Vec<[FaceId; 2]>,
}

impl Stacking {
    /// One of perhaps many, of a sheet with its nodes at `positions` (by node, in radii) in one plane of constant z and its creases
    /// at `angles` (by crease, in radians), as [`crate::solve::Reflect`] has them. The same one every time.
    ///
    /// # Errors
    /// [`NoOrder`] where the pattern cannot lie flat, or none is found.
    pub fn of(model: &Model, positions: &[DVec3], angles: &[f64]) -> Result<Self, NoOrder> {
        let Some(pairs) = Pairs::find(model, positions, angles, FAR) else { return Ok(Self::default()) };
        let mut order = Order::new(&pairs);
        conditions::add(model, positions, angles, &pairs, &mut order);
        let seen: Vec<[DVec2; 3]> =
            model.mesh.triangles.iter().map(|corners| corners.map(|n| positions[n.index()].truncate())).collect();
        let free = order.search(&seen)?;
        let upwards = |(pair, triangles): (usize, &[u32; 2])| {
            let [i, j] = triangles.map(|t| TriangleId::new(t as usize));
            let up = pairs.up[i.index()].z > 0.0;
            if order.above(pair) == up { [i, j] } else { [j, i] }
        };
        let face = |t: &u32| model.mesh.face_of_triangle[*t as usize];
        let of_faces = |[i, j]: &[u32; 2]| [face(i).min(face(j)), face(i).max(face(j))];
        let free: BTreeSet<[FaceId; 2]> =
            pairs.triangles.iter().zip(free).filter(|(_, free)| *free).map(|(pair, _)| of_faces(pair)).collect();
        Ok(Self {
            triangles: pairs.triangles.iter().enumerate().map(upwards).collect(),
            faces: told(model, &pairs, &order),
            free: free.into_iter().filter(|[one, other]| one != other).collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CreasePattern;
    use crate::fold::Document;
    use crate::generate::catalog;
    use crate::model::Material;
    use crate::solve::{Reflect, Solver};

    /// Through every point of a flat sheet goes a stack: no three triangles that have it in common lie in a circle, and what
    /// folds there lies as its crease says.
    #[test]
    fn layers_over_a_point_are_a_stack_and_creases_are_obeyed() {
        for name in ["bird-base", "square-twist", "miura", "waterbomb", "strip"] {
            let model = Model::new(&catalog::generate(name, &[]).unwrap(), &Material::default()).unwrap();
            let flat = Reflect::default().fold_from_rest(&model, 100.0).unwrap().state;
            let stacking = Stacking::of(&model, &flat.positions, &flat.fold_angles).unwrap();
            let corners = |t: usize| model.mesh.triangles[t].map(|n| flat.positions[n.index()].truncate());
            let inside = |t: usize, p: DVec2| {
                let [a, b, c] = corners(t);
                let sides = [(a, b), (b, c), (c, a)].map(|(a, b)| (b - a).perp_dot(p - a));
                sides.iter().all(|s| *s > 1e-6) || sides.iter().all(|s| *s < -1e-6)
            };
            let mut deepest = 0;
            for t in 0..model.mesh.triangles.len() {
                let [a, b, c] = corners(t);
                let point = 0.411 * a + 0.353 * b + 0.236 * c;
                let over: Vec<usize> = (0..model.mesh.triangles.len()).filter(|o| inside(*o, point)).collect();
                let under = |t: &usize| {
                    let is = |[low, high]: &&[TriangleId; 2]| high.index() == *t && over.contains(&low.index());
                    stacking.triangles.iter().filter(is).count()
                };
                let mut ranks: Vec<usize> = over.iter().map(under).collect();
                ranks.sort_unstable();
                assert!(ranks.iter().copied().eq(0..over.len()), "{name}, over triangle {t}: {ranks:?}");
                deepest = deepest.max(over.len());
            }
            assert!(deepest > 2, "{name}");
            for (crease, angle) in model.creases.iter().zip(&flat.fold_angles).filter(|(_, angle)| angle.abs() > 3.0) {
                let [Some(one), Some(two)] = model.mesh.sides[crease.side.index()].triangles else { panic!() };
                let [a, b, c] = corners(one.index());
                let front_is_up = (b - a).perp_dot(c - a) > 0.0;
                let expected = if (*angle > 0.0) == front_is_up { [one, two] } else { [two, one] };
                assert!(stacking.triangles.contains(&expected), "{name}: {expected:?}");
            }
        }
    }
    /// A strip of squares of which the creases are told, flat-folded.
    fn strip(letters: &str) -> Stacking {
        let count = letters.len() + 1;
        let coords: Vec<[usize; 2]> = (0..=count).flat_map(|x| [[x, 0], [x, 1]]).collect();
        let mut edges: Vec<[usize; 2]> = (0..=count).map(|i| [2 * i, 2 * i + 1]).collect();
        edges.extend((0..count).flat_map(|i| [[2 * i, 2 * i + 2], [2 * i + 1, 2 * i + 3]]));
        let letters: Vec<String> = format!("B{letters}B{}", "BB".repeat(count)).chars().map(String::from).collect();
        let faces: Vec<[usize; 4]> = (0..count).map(|i| [2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1]).collect();
        let text = serde_json::json!({
            "vertices_coords": coords, "edges_vertices": edges, "edges_assignment": letters, "faces_vertices": faces,
        });
        let document = Document::from_slice(text.to_string().as_bytes()).unwrap();
        let model = Model::new(&CreasePattern::from_document(&document, 0).unwrap(), &Material::default()).unwrap();
        let flat = Reflect::default().fold_from_rest(&model, 100.0).unwrap().state;
        Stacking::of(&model, &flat.positions, &flat.fold_angles).unwrap()
    }

    /// Whether the panels of a strip, each from its place in the stack, can be folded: no crease lies between the two panels of
    /// another one on the same end of the strip, by one from below and one from above.
    fn folds(order: &[usize], letters: &str) -> bool {
        let place = |panel: usize| order.iter().position(|p| *p == panel).unwrap();
        let creases: Vec<[usize; 2]> =
            (0..letters.len()).map(|i| [place(i).min(place(i + 1)), place(i).max(place(i + 1))]).collect();
        let interleave =
            |[a, b]: [usize; 2], [c, d]: [usize; 2]| (a < c && c < b && b < d) || (c < a && a < d && d < b);
        let parted =
            (0..creases.len()).any(|i| (i + 2..creases.len()).step_by(2).any(|j| interleave(creases[i], creases[j])));
        // A valley lays the next panel on the front of the first, which looks up in every second panel.
        let obeyed = letters
            .chars()
            .enumerate()
            .all(|(i, letter)| (place(i + 1) > place(i)) == ((letter == 'V') == (i % 2 == 0)));
        obeyed && !parted
    }

    /// Against all orders of the panels, tried one after the other: a pair is free if and only if two of these differ in it.
    #[test]
    fn pairs_that_may_lie_the_other_way_round_are_named() {
        let mut several = 0;
        for letters in ["V", "VV", "VM", "VVV", "VMVM", "VVMM", "VVVV", "VVMV"] {
            let count = letters.len() + 1;
            let mut orders: Vec<Vec<usize>> = vec![Vec::new()];
            for panel in 0..count {
                let with = |order: &Vec<usize>| {
                    (0..=order.len()).map(|at| [&order[..at], &[panel], &order[at..]].concat()).collect::<Vec<_>>()
                };
                orders = orders.iter().flat_map(with).collect();
            }
            orders.retain(|order| folds(order, letters));
            let above = |order: &Vec<usize>, [a, b]: [usize; 2]| {
                order.iter().position(|p| *p == a) < order.iter().position(|p| *p == b)
            };
            let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| [a, b]));
            let expected: Vec<[usize; 2]> = pairs
                .filter(|pair| orders.iter().any(|order| above(order, *pair) != above(&orders[0], *pair)))
                .collect();
            let free: Vec<[usize; 2]> = strip(letters).free.iter().map(|pair| pair.map(|face| face.index())).collect();
            assert_eq!(free, expected, "{letters}: {orders:?}");
            several += usize::from(orders.len() > 1);
        }
        assert!(several > 2);
    }
}
