//! The force that keeps the layers of a nearly flat-folded sheet in their order.

use glam::DVec3;

use super::beside::Beside;
use super::relations::Relation;
use crate::ids::NodeId;
use crate::model::Built;
use crate::scene::Force;

/// How stiff it is, in the model's unit of force per radius; beams are about a hundredth of that. Less stiff: creases press layers
/// through each other; stiffer: more evaluations.
const STIFFNESS: f64 = 5000.0;
/// How far beyond an end that paper folds around a relation goes on, fading, in radii.
const FAR: f64 = 0.1;

/// Pushes layers apart that are nearer than a gap or on the wrong side, and nodes that are nearer to a line than a margin or beyond it.
#[derive(Clone, Debug)]
pub(super) struct OrderForce {
    pub(super) relations: Vec<Relation>,
    pub(super) beside: Vec<Beside>,
    /// In radii.
    pub(super) gap: f64,
    /// In radii.
    pub(super) margin: f64,
    /// How far a relation goes on beyond an end that no paper folds around, fading, in radii.
    pub(super) beyond: f64,
}

/// A relation at some positions.
pub(super) struct Measured {
    /// How far the first thing is on its right side.
    gap: f64,
    normal: DVec3,
    /// Of the four nodes: the nearest points' difference.
    weights: [f64; 4],
    /// 1 where the things lie over each other, less beyond an end.
    fading: f64,
}

impl OrderForce {
    /// `None` where the things do not lie over each other.
    fn measure(&self, relation: &Relation, positions: &[DVec3]) -> Option<Measured> {
        let [a, b, c, d] = relation.nodes.map(|n| positions[n.index()]);
        let inside = |by: f64, place: usize| {
            let reach = if relation.folded_around[place] { FAR } else { self.beyond };
            (1.0 + by / reach).clamp(0.0, 1.0)
        };
        if relation.split == 1 {
            let (u, v, w) = (c - b, d - b, a - b);
            let normal = u.cross(v);
            let squared = normal.length_squared();
            let (s, t) = (w.cross(v).dot(normal) / squared, u.cross(w).dot(normal) / squared);
            // Heights of the triangle turn its coordinates into lengths.
            let [over_b, over_c, over_d] = [v - u, v, u].map(|side| squared.sqrt() / side.length());
            let fading = inside((1.0 - s - t) * over_b, 1) * inside(s * over_c, 2) * inside(t * over_d, 3);
            let normal = normal / squared.sqrt() * relation.sign;
            let weights = [1.0, s + t - 1.0, -s, -t];
            (fading > 0.0).then(|| Measured { gap: w.dot(normal), normal, weights, fading })
        } else {
            let (u, v, w) = (b - a, d - c, a - c);
            let [uu, uv, vv, uw, vw] = [u.dot(u), u.dot(v), v.dot(v), u.dot(w), v.dot(w)];
            let determinant = uu * vv - uv * uv;
            if determinant < 1e-4 * uu * vv {
                return None;
            }
            let (s, t) = ((uv * vw - vv * uw) / determinant, (uu * vw - uv * uw) / determinant);
            let sine = (determinant / (uu * vv)).sqrt();
            let (first, second) = (uu.sqrt() * sine, vv.sqrt() * sine);
            let fading = inside(s * first, 0)
                * inside((1.0 - s) * first, 1)
                * inside(t * second, 2)
                * inside((1.0 - t) * second, 3);
            let normal = u.cross(v).normalize_or_zero() * relation.sign;
            let weights = [1.0 - s, s, t - 1.0, -t];
            (fading > 0.0).then(|| Measured { gap: w.dot(normal), normal, weights, fading })
        }
    }

    /// How far a node is from its line, and the three nodes with their weights.
    fn off(beside: &Beside, positions: &[DVec3]) -> (f64, [(NodeId, f64); 3]) {
        let Beside { node, line: [from, to], along, away } = *beside;
        let weights = [(node, 1.0), (from, along - 1.0), (to, -along)];
        (weights.iter().map(|(n, w)| w * away.dot(positions[n.index()])).sum(), weights)
    }
}

impl Force for OrderForce {
    fn inventory(&self) -> Built {
        Built { what: "layers", count: self.relations.len() + self.beside.len() }
    }

    fn add_forces(&self, positions: &[DVec3], _velocities: &[DVec3], forces: &mut [DVec3]) {
        for relation in &self.relations {
            let Some(measured) = self.measure(relation, positions) else { continue };
            let lacking = self.gap - measured.gap;
            if lacking > 0.0 {
                let force = relation.stiffer * measured.fading * STIFFNESS * lacking * measured.normal;
                for (node, weight) in relation.nodes.iter().zip(measured.weights) {
                    forces[node.index()] += weight * force;
                }
            }
        }
        for beside in &self.beside {
            let (off, weights) = Self::off(beside, positions);
            let force = STIFFNESS * (self.margin - off).max(0.0) * beside.away;
            weights.iter().for_each(|(node, weight)| forces[node.index()] += *weight * force);
        }
    }

    fn energy(&self, positions: &[DVec3]) -> Option<f64> {
        let of_relation = |relation: &Relation| {
            let stiffness = relation.stiffer * STIFFNESS;
            let lacking = |m: Measured| 0.5 * m.fading * stiffness * (self.gap - m.gap).max(0.0).powi(2);
            self.measure(relation, positions).map_or(0.0, lacking)
        };
        let of_beside =
            |beside: &Beside| 0.5 * STIFFNESS * (self.margin - Self::off(beside, positions).0).max(0.0).powi(2);
        Some(self.relations.iter().map(of_relation).sum::<f64>() + self.beside.iter().map(of_beside).sum::<f64>())
    }

    fn add_row_sums(&self, positions: &[DVec3], sums: &mut [f64]) -> bool {
        for relation in &self.relations {
            let Some(measured) = self.measure(relation, positions) else { continue };
            if measured.gap < 2.0 * self.gap {
                let all: f64 = measured.weights.iter().map(|w| w.abs()).sum();
                for (node, weight) in relation.nodes.iter().zip(measured.weights) {
                    sums[node.index()] += relation.stiffer * measured.fading * STIFFNESS * weight.abs() * all;
                }
            }
        }
        for beside in &self.beside {
            let (off, weights) = Self::off(beside, positions);
            if off < 2.0 * self.margin {
                weights.iter().for_each(|(node, weight)| sums[node.index()] += 2.0 * STIFFNESS * weight.abs());
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::super::flat::Flat;
    use super::*;
    use crate::generate::catalog;
    use crate::layers::Stacking;
    use crate::model::{Material, Model};
    use crate::solve::{Reflect, Solver};

    /// Where nothing fades the force is the gradient of the energy, by differences; and it has no momentum anywhere.
    #[test]
    fn forces_are_the_gradient_of_the_energy() {
        let model = Model::new(&catalog::generate("bird-base", &[]).unwrap(), &Material::default()).unwrap();
        let flat = Reflect::default().fold_from_rest(&model, 100.0).unwrap().state;
        let stacking = Stacking::of(&model, &flat.positions, &flat.fold_angles).unwrap();
        let sheet = Flat::new(&model.mesh, &flat.positions, &stacking);
        let all = sheet.relations(&stacking);
        let mut force =
            OrderForce { relations: all, beside: sheet.back_to_back(), gap: 0.05, margin: 0.02, beyond: 0.01 };
        let mut seed = 1_u64;
        let mut next = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from(u32::try_from(seed >> 32).unwrap()) / f64::from(1_u32 << 31) - 1.0
        };
        let positions: Vec<DVec3> =
            flat.positions.iter().map(|p| *p + 0.02 * DVec3::new(next(), next(), next())).collect();
        let of = |force: &OrderForce| {
            let mut forces = vec![DVec3::ZERO; positions.len()];
            force.add_forces(&positions, &[], &mut forces);
            forces
        };
        let all = of(&force);
        let size: f64 = all.iter().map(|f| f.length()).sum();
        assert!(size > 0.0 && all.iter().sum::<DVec3>().length() < 1e-12 * size);
        // Fading is not of the energy.
        let whole = |relation: &Relation| force.measure(relation, &positions).is_none_or(|m| m.fading == 1.0);
        force.relations = force.relations.iter().copied().filter(whole).collect();
        assert!(force.relations.len() > 20 && !force.beside.is_empty());
        let forces = of(&force);
        for (node, own) in forces.iter().enumerate() {
            for axis in 0..3 {
                let at = |h: f64| {
                    let mut moved = positions.clone();
                    moved[node][axis] += h;
                    force.energy(&moved).unwrap()
                };
                let slope = (at(1e-6) - at(-1e-6)) / 2e-6;
                assert!((slope + own[axis]).abs() < 1e-5 * size, "node {node}: {slope}, force {own}");
            }
        }
    }
}
