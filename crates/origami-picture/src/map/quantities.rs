//! What is mapped, computed from a state.

use origami_core::glam::DVec3;
use origami_core::ids::SideId;
use origami_core::{Model, State, forces, measure};

use super::{Quantity, Values};

pub(super) fn values(quantity: Quantity, model: &Model, state: &State) -> Values {
    let shown = |values: Vec<f64>, factor: f64| values.into_iter().map(|v| (v * factor) as f32).collect();
    match quantity {
        Quantity::Strain => Values::Nodes(shown(measure::node_strains(model, &state.positions), 100.0)),
        Quantity::FaceStrain => Values::Triangles(shown(face_strains(model, state), 100.0)),
        Quantity::AngleError => Values::Triangles(shown(angle_errors(model, state), 1.0_f64.to_degrees())),
        Quantity::EnergyDensity => Values::Triangles(shown(energy_densities(model, state), 1.0)),
    }
}

/// The triangles beside a side.
fn beside(model: &Model, side: SideId) -> impl Iterator<Item = usize> {
    model.mesh.sides[side.index()].triangles.into_iter().flatten().map(|t| t.index())
}

/// Sums of a value of each side over the sides of each triangle, and their number.
fn over_sides(model: &Model, of_side: impl Iterator<Item = (SideId, f64)>) -> Vec<(f64, u32)> {
    let mut sums = vec![(0.0, 0); model.mesh.triangles.len()];
    for (side, value) in of_side {
        for triangle in beside(model, side) {
            sums[triangle].0 += value;
            sums[triangle].1 += 1;
        }
    }
    sums
}

fn means(sums: Vec<(f64, u32)>) -> Vec<f64> {
    sums.into_iter().map(|(sum, count)| sum / f64::from(count.max(1))).collect()
}

fn face_strains(model: &Model, state: &State) -> Vec<f64> {
    let strains = forces::beams::strains(model, &state.positions);
    means(over_sides(model, strains.enumerate().map(|(side, strain)| (SideId::new(side), strain.abs()))))
}

fn angle_errors(model: &Model, state: &State) -> Vec<f64> {
    let angles = state.fold_angles.iter().zip(&state.targets);
    let errors = model.creases.iter().zip(angles).map(|(crease, (is, asked))| (crease.side, (is - asked).abs()));
    means(over_sides(model, errors))
}

/// Energy by triangle; of a spring between two triangles each has half. Springs outside any face are no triangle's.
fn energies(model: &Model, state: &State) -> Vec<f64> {
    let strains = forces::beams::strains(model, &state.positions).zip(&model.beams).enumerate();
    let beams = strains
        .map(|(side, (strain, beam))| (SideId::new(side), 0.5 * beam.stiffness * (strain * beam.rest_length).powi(2)));
    let angles = state.fold_angles.iter().zip(&state.targets);
    let creases = model
        .creases
        .iter()
        .zip(angles)
        .map(|(crease, (is, asked))| (crease.side, 0.5 * crease.stiffness * (is - asked).powi(2)));
    let mut energies = vec![0.0; model.mesh.triangles.len()];
    for (side, energy) in beams.chain(creases) {
        let share = energy / beside(model, side).count().max(1) as f64;
        beside(model, side).for_each(|triangle| energies[triangle] += share);
    }
    for corners in &model.corner_angles {
        let [a, b, c] = corners.nodes.map(|n| state.positions[n.index()]);
        let [first, second] = [(a, b, c, corners.rest[0]), (b, c, a, corners.rest[1])]
            .map(|(corner, left, right, (cos, sin))| corner_angle(left - corner, right - corner) - sin.atan2(cos));
        let squares = first * first + second * second + (first + second).powi(2);
        energies[corners.triangle.index()] += 0.5 * model.material.k_face * squares;
    }
    energies
}

fn corner_angle(left: DVec3, right: DVec3) -> f64 {
    left.cross(right).length().atan2(left.dot(right))
}

fn energy_densities(model: &Model, state: &State) -> Vec<f64> {
    let area = |triangle: &[origami_core::ids::NodeId; 3]| {
        let [a, b, c] = triangle.map(|n| model.rest[n.index()]);
        0.5 * (b - a).cross(c - a).length()
    };
    let energies = energies(model, state).into_iter().zip(&model.mesh.triangles);
    energies
        .map(|(energy, triangle)| (energy, area(triangle)))
        .map(|(e, a)| if a > 0.0 { e / a } else { 0.0 })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use origami_core::generate::catalog;
    use origami_core::{Material, Relax, Solver};

    #[test]
    fn triangles_share_all_the_energy_there_is() {
        let pattern = catalog::generate("hypar", &[]).unwrap();
        let model = Model::new(&pattern, &Material::default()).unwrap();
        let state = Relax::default().fold_from_rest(&model, 80.0).unwrap().state;
        let (sum, total) = (energies(&model, &state).iter().sum::<f64>(), state.energy(&model).total());
        assert!(total > 1e-6 && (sum / total - 1.0).abs() < 1e-6, "{sum} {total}");
    }

    #[test]
    fn a_stretched_sheet_is_strained_everywhere_and_a_flat_one_asked_to_fold_is_off_its_angle() {
        let pattern = catalog::generate("single-crease", &[]).unwrap();
        let model = Model::new(&pattern, &Material::default()).unwrap();
        let mut state = State::at_rest(&model);
        state.targets = model.targets(50.0);
        state.positions.iter_mut().for_each(|p| *p *= 1.02);
        let all = |quantity, expected: f32| {
            let (Values::Nodes(values) | Values::Triangles(values)) = values(quantity, &model, &state);
            assert!(
                !values.is_empty() && values.iter().all(|v| (v - expected).abs() < 1e-4),
                "{quantity:?} {values:?}"
            );
        };
        all(Quantity::Strain, 2.0);
        all(Quantity::FaceStrain, 2.0);
        all(Quantity::AngleError, 90.0);
    }
}
