//! Rigid motions, which cost nothing and lead nowhere: each part of a sheet that nothing holds has six.

use glam::{DMat3, DVec3};

use crate::model::Model;
use crate::scene::{Held, Scene};

/// The parts of the sheet that hang together and have no held node.
#[derive(Debug)]
pub(super) struct Rigid {
    parts: Vec<Vec<usize>>,
}

impl Rigid {
    pub(super) fn new(model: &Model, scene: &Scene) -> Self {
        let count = model.node_count();
        // Union of the ends of each beam; the root of a part is its first node.
        let mut root: Vec<usize> = (0..count).collect();
        for beam in &model.beams {
            let [a, b] = beam.nodes.map(|n| find(&mut root, n.index()));
            root[a.max(b)] = a.min(b);
        }
        let mut parts = vec![Vec::new(); count];
        for node in 0..count {
            parts[find(&mut root, node)].push(node);
        }
        for (node, _) in Held::new(model, scene).iter() {
            parts[find(&mut root, node.index())].clear();
        }
        // Under loads a turn costs energy.
        if !scene.has_springs_only() {
            parts.clear();
        }
        parts.retain(|part| !part.is_empty());
        Self { parts }
    }

    /// Takes the rigid motion of least squares out of `moves`, part by part. Nodes count by the weights with which a shift
    /// holds them back: else a stiff node, which hardly moves, would be moved by what is taken from the others.
    pub(super) fn remove(&self, positions: &[DVec3], weights: &[f64], moves: &mut [DVec3]) {
        for part in &self.parts {
            let total: f64 = part.iter().map(|n| weights[*n]).sum();
            let mean = |of: &[DVec3]| part.iter().map(|n| of[*n] * weights[*n]).sum::<DVec3>() / total;
            let (centre, shift) = (mean(positions), mean(moves));
            let (mut inertia, mut moment) = (DMat3::ZERO, DVec3::ZERO);
            for n in part {
                let arm = positions[*n] - centre;
                let square = DMat3::from_cols(arm * arm.x, arm * arm.y, arm * arm.z);
                let around = DMat3::from_diagonal(DVec3::splat(arm.length_squared())) - square;
                inertia += around * (weights[*n] / total);
                moment += arm.cross(moves[*n] - shift) * (weights[*n] / total);
            }
            // Points on one line have no inertia about it: they are turned by nothing.
            let turn = inertia.inverse_or_zero() * moment;
            for n in part {
                moves[*n] -= shift + turn.cross(positions[*n] - centre);
            }
        }
    }
}

fn find(root: &mut [usize], node: usize) -> usize {
    let mut node = node;
    while root[node] != node {
        root[node] = root[root[node]];
        node = root[node];
    }
    node
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::miura;
    use crate::model::Material;

    #[test]
    fn a_rigid_motion_goes_and_what_is_none_stays() {
        let model = Model::new(&miura(3, 3).expect("valid"), &Material::default()).expect("valid");
        let rigid = Rigid::new(&model, &Scene::default());
        let turn = DVec3::new(0.3, -1.0, 0.4);
        let mut moves: Vec<DVec3> = model.rest.iter().map(|p| DVec3::X + turn.cross(*p)).collect();
        let weights: Vec<f64> = (1..=model.node_count()).map(|i| i as f64).collect();
        rigid.remove(&model.rest, &weights, &mut moves);
        assert!(moves.iter().all(|m| m.length() < 1e-14));
        let mut dent = vec![DVec3::ZERO; model.node_count()];
        dent[5] = DVec3::Z;
        rigid.remove(&model.rest, &weights, &mut dent);
        assert!(dent[5].z > 0.5, "{}", dent[5]);
        let momentum: DVec3 = dent.iter().zip(&weights).map(|(d, w)| *d * *w).sum();
        assert!(momentum.length() < 1e-13, "{momentum}");
    }

    #[test]
    fn what_is_held_has_no_rigid_motion() {
        let mut model = Model::new(&miura(3, 3).expect("valid"), &Material::default()).expect("valid");
        model.fixed.push(crate::ids::NodeId(0));
        let mut moves = vec![DVec3::X; model.node_count()];
        Rigid::new(&model, &Scene::default()).remove(&model.rest, &vec![1.0; model.node_count()], &mut moves);
        assert_eq!(moves, vec![DVec3::X; model.node_count()]);
    }
}
