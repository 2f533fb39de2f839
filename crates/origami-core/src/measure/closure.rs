//! How far a folded sheet is from one with rigid facets, with no other state to compare it with.

use glam::DVec3;

use crate::ids::NodeId;
use crate::model::Model;
use crate::pattern::fold_angle;
use crate::rigid::loop_closure;

/// How far each interior node is from closing with the sectors that it has at rest: 0 where the facets around it are as they
/// were cut, and more where they had to stretch or bend ([`loop_closure`] has the formula). By node, those in the interior
/// only; facets too thin to have a fold angle leave out theirs.
#[must_use]
pub fn closures(model: &Model, positions: &[DVec3]) -> Vec<(NodeId, f64)> {
    let of = |node: usize| Some((NodeId::new(node), loop_closure(&around(model, positions, node)?)));
    (0..model.node_count()).filter_map(of).collect()
}

/// Fold angles at the sides around an interior node, each with the sector after it, counterclockwise.
fn around(model: &Model, positions: &[DVec3], node: usize) -> Option<Vec<(f64, f64)>> {
    let sides = model.mesh.sides_of_node.row(node);
    // Each neighbour with the one after it.
    let mut next: Vec<(usize, usize, f64)> = Vec::with_capacity(sides.len());
    for side in sides.iter().map(|side| &model.mesh.sides[side.index()]) {
        let [left, right] = [side.apexes[0]?.index(), side.apexes[1]?.index()];
        let [from, to] = side.nodes.map(|n| n.index());
        let fold = fold_angle(positions[left], positions[right], positions[from], positions[to]);
        next.push(if from == node { (to, left, fold) } else { (from, right, fold) });
    }
    next.sort_unstable_by_key(|(neighbour, ..)| *neighbour);
    let mut ring = Vec::with_capacity(next.len());
    let first = next.first()?.0;
    let mut at = first;
    for _ in 0..next.len() {
        let (_, after, fold) = next[next.binary_search_by_key(&at, |(neighbour, ..)| *neighbour).ok()?];
        let sector = (model.rest[at] - model.rest[node]).angle_between(model.rest[after] - model.rest[node]);
        ring.push((fold, sector));
        at = after;
    }
    // Two fans that meet in a point are not one loop.
    (at == first && ring.iter().all(|(fold, sector)| fold.is_finite() && sector.is_finite())).then_some(ring)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::Miura;
    use crate::model::Material;

    #[test]
    fn a_rigid_fold_closes_and_a_dented_one_does_not() {
        let miura = Miura { columns: 4, rows: 3, theta: 0.9, ..Miura::default() };
        let model = Model::new(&miura.pattern().expect("valid"), &Material::default()).expect("a model");
        let fold = miura.folded();
        let mut positions = vec![DVec3::ZERO; model.node_count()];
        for (node, vertex) in model.mesh.vertex_of_node.iter().enumerate() {
            positions[node] = fold.vertex(vertex.index() % 5, vertex.index() / 5) / model.normalisation.radius;
        }
        let worst = |positions: &[DVec3]| closures(&model, positions).iter().fold(0.0, |w: f64, (_, c)| w.max(*c));
        assert_eq!(closures(&model, &positions).len(), 3 * 2, "the interior vertices");
        assert!(worst(&positions) < 1e-12, "{}", worst(&positions));
        assert_eq!(worst(&model.rest).to_bits() >> 62, 0, "finite where flat");
        assert!(worst(&model.rest) < 1e-12);
        positions[7].z += 0.01;
        assert!(worst(&positions) > 1e-3, "a dent is seen");
    }
}
