//! Triangles that have been crushed to a line.
//!
//! Beams and corner angles resist that only so far: where creases cannot have their angles together, the least energy may
//! be that of a triangle without height. There the energy has a kink, as |h| has at 0: the force jumps from one side to
//! the other and never vanishes, so that no number of steps brings the sheet to rest.

use glam::DVec3;

use crate::ids::{NodeId, TriangleId};
use crate::model::{DEGENERATE, Model};

/// The share of its height at rest below which a triangle is crushed. Of 600 folds of vertices of degree 3 to 7 with random
/// angles, the 505 that come to rest keep 0.018 of it or more; the other 95 swing about 1e-6.
pub const CRUSHED: f64 = 1e-3;

/// The triangles that have less than [`CRUSHED`] of their height at rest, with the nodes at `positions` (in radii, by
/// node). Those too thin for springs at rest are left out.
#[must_use]
pub fn crushed_triangles(model: &Model, positions: &[DVec3]) -> Vec<TriangleId> {
    crushed(model, positions).collect()
}

/// Whether there is one.
pub(super) fn is_crushed(model: &Model, positions: &[DVec3]) -> bool {
    crushed(model, positions).next().is_some()
}

fn crushed(model: &Model, positions: &[DVec3]) -> impl Iterator<Item = TriangleId> {
    let at = |nodes: &[NodeId; 3], positions: &[DVec3]| height(nodes.map(|node| positions[node.index()]));
    let is_crushed = move |nodes: &[NodeId; 3]| {
        let rest = at(nodes, &model.rest);
        rest >= DEGENERATE && at(nodes, positions) < CRUSHED * rest
    };
    let triangles = model.mesh.triangles.iter().enumerate();
    triangles.filter(move |(_, nodes)| is_crushed(nodes)).map(|(triangle, _)| TriangleId::new(triangle))
}

/// The height of a triangle above its longest side; 0 for one without a side.
fn height([a, b, c]: [DVec3; 3]) -> f64 {
    let longest = [b - a, c - b, a - c].into_iter().map(DVec3::length_squared).fold(0.0, f64::max);
    if longest > 0.0 { ((b - a).cross(c - a).length_squared() / longest).sqrt() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::Miura;
    use crate::model::Material;

    #[test]
    fn a_triangle_is_crushed_below_a_thousandth_of_its_height() {
        let model = Model::new(&Miura::default().pattern().unwrap(), &Material::default()).unwrap();
        assert_eq!(crushed_triangles(&model, &model.rest), []);
        let [a, b, c] = model.mesh.triangles[3];
        let squeezed = |share: f64| {
            let mut positions = model.rest.clone();
            let (from, along) = (model.rest[b.index()], model.rest[c.index()] - model.rest[b.index()]);
            let height = (model.rest[a.index()] - from).reject_from(along);
            positions[a.index()] -= height * (1.0 - share);
            crushed_triangles(&model, &positions).contains(&TriangleId(3))
        };
        assert!(!squeezed(0.01) && squeezed(1e-4) && squeezed(0.0));
        let lost = vec![DVec3::ZERO; model.rest.len()];
        assert_eq!(crushed_triangles(&model, &lost).len(), model.mesh.triangles.len(), "all of it at one point");
    }
}
