//! Energy of all members with its first and second derivatives. The geometry is that of [`crate::forces`]; what the members
//! answer is their [laws](super::BarLaw).

use glam::{DMat3, DVec3};

use super::structure::{Bar, Corners, HingeKind, Structure};
use super::{Configuration, Response};
use crate::forces::corner_angles::Triangle;
use crate::forces::hessian::{self, add_pairs, outer};
use crate::forces::{creases, unwrapped};

/// What is stored in a structure, by kind of member, in units of force times length.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Energies {
    /// In stretched and compressed bars.
    pub bars: f64,
    /// In hinges that are creases.
    pub creases: f64,
    /// In hinges that are bent facets.
    pub facets: f64,
    /// In sheared triangles.
    pub corners: f64,
}

impl Energies {
    /// The sum.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.bars + self.creases + self.facets + self.corners
    }
}

impl Structure {
    /// What is stored at `at`.
    #[must_use]
    pub fn energies(&self, at: &Configuration) -> Energies {
        let mut energies = Energies::default();
        for bar in &self.bars {
            energies.bars += stretched(bar, &at.positions).map_or(0.0, |(_, _, response)| response.energy);
        }
        for (hinge, angle) in self.hinges.iter().zip(&at.fold_angles) {
            let energy = hinge.law.respond(hinge.stiffness, hinge.rest_angle, *angle).energy;
            match hinge.kind {
                HingeKind::Crease => energies.creases += energy,
                HingeKind::Facet => energies.facets += energy,
            }
        }
        for corners in &self.corners {
            let deviations = Triangle::new(points(&corners.angles.nodes, &at.positions)).deviations(&corners.angles);
            energies.corners += 0.5 * corners.stiffness * deviations.iter().map(|d| d * d).sum::<f64>();
        }
        energies
    }

    /// Adds the gradient of the energy at `at` to `gradient`, by node, and brings the fold angles of `at` up to its positions.
    /// `size` is [`Structure::size`].
    pub(super) fn add_gradient(&self, size: f64, at: &mut Configuration, gradient: &mut [DVec3]) {
        for bar in &self.bars {
            let Some((direction, _, response)) = stretched(bar, &at.positions) else { continue };
            let [i, j] = bar.nodes.map(|n| n.index());
            gradient[i] -= direction * response.slope;
            gradient[j] += direction * response.slope;
        }
        for (hinge, angle) in self.hinges.iter().zip(&mut at.fold_angles) {
            // A hinge without two triangles keeps its angle and pulls at nothing.
            let Some(geometry) = creases::hinge(points(&hinge.nodes, &at.positions).map(|p| p / size)) else {
                continue;
            };
            *angle = unwrapped(geometry.angle(), *angle);
            let moment = hinge.law.respond(hinge.stiffness, hinge.rest_angle, *angle).slope / size;
            for (node, by_node) in hinge.nodes.iter().zip(geometry.gradient) {
                gradient[node.index()] += by_node * moment;
            }
        }
        for Corners { angles, stiffness } in &self.corners {
            let triangle = Triangle::new(points(&angles.nodes, &at.positions));
            if triangle.collapsed() {
                continue;
            }
            let moments = triangle.deviations(angles).map(|d| d * stiffness);
            let [ab, bc, ca] = triangle.side_vectors();
            let along =
                [ab * (moments[0] - moments[1]), bc * (moments[1] - moments[2]), ca * (moments[2] - moments[0])];
            let [a, b, c] = angles.nodes.map(|n| n.index());
            gradient[a] += along[0] - along[2];
            gradient[b] += along[1] - along[0];
            gradient[c] += along[2] - along[1];
        }
    }

    /// Hands `add(i, j, block)` the blocks of the second derivatives at `at`, as [`hessian::blocks`] does.
    pub(super) fn blocks(&self, size: f64, at: &Configuration, add: &mut impl FnMut(usize, usize, DMat3)) {
        for bar in &self.bars {
            let Some((direction, length, response)) = stretched(bar, &at.positions) else { continue };
            let across = response.slope / length;
            let along = outer(direction, direction) * (response.curvature - across);
            let block = DMat3::from_diagonal(DVec3::splat(across)) + along;
            let [i, j] = bar.nodes.map(|n| n.index());
            add(i, i, block);
            add(j, j, block);
            add(i, j, -block);
        }
        for (hinge, angle) in self.hinges.iter().zip(&at.fold_angles) {
            let nodes = hinge.nodes.map(|n| n.index());
            let scaled = nodes.map(|n| at.positions[n] / size);
            let Some(geometry) = hessian::creases::hinge(scaled) else { continue };
            let Response { slope, curvature, .. } = hinge.law.respond(hinge.stiffness, hinge.rest_angle, *angle);
            let (slope, curvature) = (slope / (size * size), curvature / (size * size));
            add_pairs(&nodes, add, |i, j| {
                outer(geometry.gradient[i], geometry.gradient[j]) * curvature + geometry.second[i][j] * slope
            });
        }
        for Corners { angles, stiffness } in &self.corners {
            let nodes = angles.nodes.map(|n| n.index());
            let Some(second) = hessian::corner_angles::blocks(angles, nodes.map(|n| at.positions[n])) else { continue };
            add_pairs(&nodes, add, |i, j| second[i][j] * *stiffness);
        }
    }
}

fn points<const N: usize>(nodes: &[crate::ids::NodeId; N], positions: &[DVec3]) -> [DVec3; N] {
    nodes.map(|n| positions[n.index()])
}

/// Direction from the first end to the second, length, and what the bar answers; `None` for one of no length.
fn stretched(bar: &Bar, positions: &[DVec3]) -> Option<(DVec3, f64, Response)> {
    let [from, to] = points(&bar.nodes, positions);
    let length = from.distance(to);
    (length > 0.0).then(|| ((to - from) / length, length, bar.law.respond(bar.rigidity, bar.rest_length, length)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::equations::Equations;
    use crate::analysis::{BarLaw, HingeLaw};
    use crate::generate::catalog;
    use crate::model::{Material, Model};

    /// A sheet of every kind of member and law, pushed out of shape, in a unit of length that is not its radius.
    fn sheet() -> (Structure, Configuration) {
        let pattern = catalog::generate("bird-base", &[]).expect("a pattern");
        let mut structure = Structure::of(&Model::new(&pattern, &Material::default()).expect("a model"));
        let scale = 40.0;
        structure.nodes.iter_mut().for_each(|p| *p *= scale);
        for (i, bar) in structure.bars.iter_mut().enumerate() {
            bar.rest_length *= scale;
            bar.law = [BarLaw::Linear, BarLaw::Green, BarLaw::Ogden][i % 3];
        }
        for (i, hinge) in structure.hinges.iter_mut().enumerate() {
            let laws = [
                HingeLaw::Linear,
                HingeLaw::Stiffened { between: [-0.02, 0.02] },
                HingeLaw::Power { exponent: 4.0 / 3.0 },
            ];
            hinge.law = laws[i % 3];
            hinge.rest_angle += 0.4;
        }
        structure.loads.pressures = vec![(structure.corners[3].angles.nodes, 0.7)];
        let mut at = structure.as_drawn();
        for (i, p) in at.positions.iter_mut().enumerate() {
            let i = i as f64;
            *p += 0.04 * scale * DVec3::new((1.0 + i).sin(), (2.0 + 3.0 * i).cos(), (3.0 + 2.0 * i).sin());
        }
        at.fold_angles = structure.fold_angles(&at.positions, &at.fold_angles);
        (structure, at)
    }

    fn moved(structure: &Structure, at: &Configuration, node: usize, way: DVec3) -> Configuration {
        let mut moved = at.clone();
        moved.positions[node] += way;
        moved.fold_angles = structure.fold_angles(&moved.positions, &at.fold_angles);
        moved
    }

    #[test]
    fn the_gradient_is_the_derivative_of_the_energy() {
        let (structure, mut at) = sheet();
        let mut gradient = vec![DVec3::ZERO; structure.nodes.len()];
        structure.add_gradient(structure.size(), &mut at, &mut gradient);
        let largest = gradient.iter().map(|g| g.length()).fold(0.0, f64::max);
        let h = 1e-4;
        for (node, own) in gradient.iter().enumerate() {
            for axis in DVec3::AXES {
                let energy = |way: f64| structure.energies(&moved(&structure, &at, node, axis * way)).total();
                let slope = (energy(h) - energy(-h)) / (2.0 * h);
                let own = own.dot(axis);
                assert!((slope - own).abs() < 1e-7 * largest, "node {node}: {own} is not {slope}");
            }
        }
    }

    #[test]
    fn the_blocks_are_the_derivative_of_the_forces_out_of_balance() {
        let (structure, at) = sheet();
        let equations = Equations::new(&structure).expect("a structure");
        let load_factor = 0.3;
        let count = structure.nodes.len();
        let mut dense = vec![vec![DMat3::ZERO; count]; count];
        let mut enter = |i: usize, j: usize, block: DMat3| {
            dense[i][j] += block;
            if i != j {
                dense[j][i] += block.transpose();
            }
        };
        structure.blocks(equations.size, &at, &mut enter);
        structure.loads.blocks(load_factor, &at.positions, &mut enter);
        // Of a pressure on one triangle only the symmetric part is there.
        let mut differences = vec![vec![DMat3::ZERO; count]; count];
        let h = 1e-4;
        for node in 0..count {
            for (column, axis) in DVec3::AXES.into_iter().enumerate() {
                let unbalanced =
                    |way: f64| equations.unbalanced(&mut moved(&structure, &at, node, axis * way), load_factor);
                let both = unbalanced(h).into_iter().zip(unbalanced(-h));
                for (row, (after, before)) in differences.iter_mut().zip(both) {
                    *row[node].col_mut(column) = (after - before) / (2.0 * h);
                }
            }
        }
        let (mut largest, mut worst) = (0.0_f64, 0.0_f64);
        for i in 0..count {
            for j in 0..count {
                let symmetric = (differences[i][j] + differences[j][i].transpose()) * 0.5;
                largest = largest.max(dense[i][j].to_cols_array().iter().fold(0.0, |a: f64, x| a.max(x.abs())));
                let error = (symmetric - dense[i][j]).to_cols_array();
                worst = error.iter().fold(worst, |a: f64, x| a.max(x.abs()));
            }
        }
        assert!(worst < 1e-6 * largest, "{worst} beside {largest}");
    }
}
