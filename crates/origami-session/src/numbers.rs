//! How the sheet is, in numbers: what a frame says beside the picture.

use origami_core::forces::beams::strains;
use origami_core::measure::{Strain, node_strains};
use origami_core::solve::{Folded, Report, State, crushed_triangles};
use origami_core::{Model, ids::NodeId};

use crate::message::{FrameHead, MapWish};

/// The numbers of a state, of which `wanted` is asked, and the values of the map by node.
pub(crate) fn head(
    model: &Model,
    state: &State,
    wanted: &[f64],
    report: Report,
    map: MapWish,
) -> (FrameHead, Vec<f64>) {
    let strain = Strain::of(model, &state.positions).beams;
    let differences =
        || state.fold_angles.iter().zip(wanted).map(|(reached, asked)| (reached - asked).abs().to_degrees());
    let values = match map {
        MapWish::None => vec![0.0; model.node_count()],
        MapWish::Strain => node_strains(model, &state.positions),
        MapWish::AngleError => by_creases(model, differences(), |value, difference| *value = value.max(difference)),
        MapWish::Energy => energies(model, state),
    };
    let asked = State { targets: wanted.to_vec(), fold_angles: state.fold_angles.clone(), ..State::default() };
    let head = FrameHead {
        steps: report.steps,
        settled: report.settled,
        distance: report.distance.is_finite().then_some(report.distance),
        ramp: report.ramp,
        strain_mean: strain.mean,
        strain_max: strain.max,
        energy: state.energy(model).total(),
        angle_error_max: differences().fold(0.0, f64::max),
        lost_creases: asked.lost_creases(),
        crushed: crushed_triangles(model, &state.positions).len(),
        map,
        map_max: values.iter().copied().fold(0.0, f64::max),
        ..FrameHead::default()
    };
    (head, values)
}

/// How a solver left a state.
pub(crate) fn report(folded: &Folded) -> Report {
    Report { steps: folded.steps, settled: folded.converged(), distance: folded.distance, ramp: 1.0 }
}

/// Values of creases brought to the two nodes of each.
fn by_creases(model: &Model, values: impl Iterator<Item = f64>, mut bring: impl FnMut(&mut f64, f64)) -> Vec<f64> {
    let mut of_node = vec![0.0; model.node_count()];
    for (crease, value) in model.creases.iter().zip(values) {
        let [_, _, one, two] = crease.nodes;
        [one, two].iter().for_each(|node: &NodeId| bring(&mut of_node[node.index()], value));
    }
    of_node
}

/// Half of the energy of each beam and crease to either end.
fn energies(model: &Model, state: &State) -> Vec<f64> {
    let of_creases = model
        .creases
        .iter()
        .zip(state.fold_angles.iter().zip(&state.targets))
        .map(|(crease, (angle, target))| 0.5 * crease.stiffness * (angle - target).powi(2));
    let mut of_node = by_creases(model, of_creases, |value, energy| *value += 0.5 * energy);
    for (beam, strain) in model.beams.iter().zip(strains(model, &state.positions)) {
        let energy = 0.5 * beam.stiffness * (strain * beam.rest_length).powi(2);
        beam.nodes.iter().for_each(|node| of_node[node.index()] += 0.5 * energy);
    }
    of_node
}

/// Positions in radii and values of the map, four numbers for each node.
pub(crate) fn body(state: &State, values: &[f64]) -> Vec<u8> {
    let mut body = Vec::with_capacity(16 * values.len());
    for (position, value) in state.positions.iter().zip(values) {
        position.as_vec3().to_array().iter().for_each(|x| body.extend(x.to_le_bytes()));
        #[expect(clippy::cast_possible_truncation, reason = "a colour")]
        body.extend((*value as f32).to_le_bytes());
    }
    body
}

#[cfg(test)]
mod tests {
    use super::*;
    use origami_core::generate::Miura;
    use origami_core::{Material, Relax, Solver};

    #[test]
    fn shares_of_the_nodes_add_up_to_the_energy_of_beams_and_creases() {
        let pattern = Miura::default().pattern().expect("the default");
        let model = Model::new(&pattern, &Material::default()).expect("a sheet");
        let state = Relax { steps: Some(50), ..Relax::default() }.fold_from_rest(&model, 70.0).expect("folds").state;
        let energy = state.energy(&model);
        let sum: f64 = energies(&model, &state).iter().sum();
        let expected = energy.beams + energy.creases;
        assert!(expected > 1e-6, "{expected}");
        assert!((sum - expected).abs() < 1e-12 * expected.max(1.0), "{sum} {expected}");
    }
}
