//! An order of the layers of the exact flat-folded sheet.

use glam::{DVec2, DVec3};

use super::conditions;
use super::face_orders::{FaceOrder, told};
use super::order::Order;
use super::pairs::{FAR, Pairs};
use super::search::NoOrder;
use crate::ids::TriangleId;
use crate::model::Model;

/// Which triangle lies on which in a sheet that is folded flat, so that paper goes through no paper.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Stacking {
    /// Pairs of triangles that lie upon each other, the lower one first, seen from where z points to.
    pub triangles: Vec<[TriangleId; 2]>,
    /// The same of faces, as FOLD's `faceOrders` has it.
    pub faces: Vec<FaceOrder>,
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
        order.search(&seen)?;
        let upwards = |(pair, triangles): (usize, &[u32; 2])| {
            let [i, j] = triangles.map(|t| TriangleId::new(t as usize));
            let up = pairs.up[i.index()].z > 0.0;
            if order.above(pair) == up { [i, j] } else { [j, i] }
        };
        Ok(Self {
            triangles: pairs.triangles.iter().enumerate().map(upwards).collect(),
            faces: told(model, &pairs, &order),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
}
