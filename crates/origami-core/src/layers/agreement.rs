//! Whether the layers of a state lie as those of the flat-folded sheet must.

use glam::{DVec2, DVec3};

use super::conditions;
use super::order::Order;
use super::pairs::{FAR, Pairs};
use super::search::NoOrder;
use crate::ids::TriangleId;
use crate::model::Model;

/// How a state that has layers of its own agrees with what the folds of the flat-folded sheet demand.
///
/// A pair of triangles is *forced* if its order follows from the creases and the conditions of flat folding alone, without a
/// choice. Where all pairs are, the sheet has one order, and a state with another has not become what the pattern says, however
/// near its angles are.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Agreement {
    /// Pairs of triangles that lie upon each other in the flat-folded sheet.
    pub pairs: usize,
    /// Those of them that are forced.
    pub forced: usize,
    /// Those of the forced ones that the state tells the order of: its triangles are parallel there, and apart.
    pub told: usize,
    /// Those of them that lie the other way round.
    pub differ: Vec<[TriangleId; 2]>,
}

impl Agreement {
    /// That of a state, its `positions` by node in radii and `angles` by crease in radians, with the flat-folded sheet, which has
    /// its nodes at those of `flat` in one plane of constant z, as [`crate::solve::Reflect`] has them.
    ///
    /// # Errors
    /// [`NoOrder::Contradiction`] where the pattern cannot lie flat.
    pub fn of(
        model: &Model,
        (flat, flat_angles): (&[DVec3], &[f64]),
        (positions, angles): (&[DVec3], &[f64]),
    ) -> Result<Self, NoOrder> {
        let Some(pairs) = Pairs::find(model, flat, flat_angles, FAR) else { return Ok(Self::default()) };
        let mut order = Order::new(&pairs);
        conditions::add(model, flat, flat_angles, &pairs, &mut order);
        let seen: Vec<[DVec2; 3]> =
            model.mesh.triangles.iter().map(|corners| corners.map(|n| flat[n.index()].truncate())).collect();
        order.force(&seen)?;
        let state = Pairs::find(model, positions, angles, FAR);
        let mut agreement = Self { pairs: pairs.triangles.len(), ..Self::default() };
        for (pair, triangles) in pairs.triangles.iter().enumerate().filter(|(pair, _)| order.is_answered(*pair)) {
            agreement.forced += 1;
            let Some(above) = state.as_ref().and_then(|state| in_front(state, *triangles)) else { continue };
            agreement.told += 1;
            if above != (order.above(pair) == faces_up(&pairs, triangles[0])) {
                agreement.differ.push(triangles.map(|t| TriangleId::new(t as usize)));
            }
        }
        Ok(agreement)
    }

    /// Whether the flat-folded sheet has one order, and the state tells all of it, and the same.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.forced == self.pairs && self.told == self.forced && self.differ.is_empty()
    }
}

/// Whether the second of two triangles lies on the front of the first, as the state itself has them.
fn in_front(state: &Pairs, [i, j]: [u32; 2]) -> Option<bool> {
    let (pair, _) = state.between(i, j)?;
    state.own(pair).map(|above| above == faces_up(state, i))
}

fn faces_up(pairs: &Pairs, triangle: u32) -> bool {
    let triangle = triangle as usize;
    pairs.normals[triangle].dot(pairs.up[triangle]) > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::catalog;
    use crate::model::Material;
    use crate::solve::{ContactRelax, Reflect, Solver};

    /// An accordion has one order.
    #[test]
    fn a_stack_agrees_and_its_mirror_image_does_not() {
        let model = Model::new(&catalog::generate("strip", &[]).unwrap(), &Material::default()).unwrap();
        let flat = Reflect::default().fold_from_rest(&model, 100.0).unwrap().state;
        let folded = ContactRelax::default().fold_from_rest(&model, 100.0).unwrap().state;
        let agreement = |positions: &[DVec3]| {
            Agreement::of(&model, (&flat.positions, &flat.fold_angles), (positions, &folded.fold_angles)).unwrap()
        };
        let same = agreement(&folded.positions);
        assert!(same.is_whole() && same.pairs > 30, "{same:?}");
        // What lay above lies below, and every panel looks where it looked.
        let normal = {
            let [a, b, c] = model.mesh.triangles[0].map(|n| folded.positions[n.index()]);
            (b - a).cross(c - a).normalize()
        };
        let mirrored: Vec<DVec3> = folded.positions.iter().map(|p| *p - 2.0 * p.dot(normal) * normal).collect();
        let other = agreement(&mirrored);
        assert_eq!((other.told, other.differ.len()), (same.told, same.told), "{other:?}");
        // The open sheet tells nothing.
        let open = agreement(&model.rest);
        assert_eq!((open.forced, open.told), (same.forced, 0));
    }
}
