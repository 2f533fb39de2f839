//! Creases that are asked for more than paper can do.

use std::f64::consts::PI;

use crate::error::{CreasePlace, Place, Warning, WarningCode};
use crate::model::{Crease, Model};

/// From here on a fold angle is past 180 degrees; rounding alone does not get there.
const PAST: f64 = PI * (1.0 + 1e-9);

/// Beyond 180 degrees the two sides of a crease have gone through each other.
pub(super) fn over_folding(model: &Model, percents: &[f64]) -> Option<Warning> {
    let percent = percents.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
    let asked = |target: f64| (target * percent / 100.0).abs();
    let past = model.creases.iter().filter(|crease| crease.stiffness > 0.0 && asked(crease.full_target) > PAST);
    let place = |crease: &Crease| {
        let ends = [crease.nodes[2], crease.nodes[3]].map(|node| model.mesh.vertex_of_node[node.index()]);
        CreasePlace::new(ends, model.mesh.sides[crease.side.index()].edge)
    };
    let places: Vec<CreasePlace> = past.clone().map(place).collect();
    let most = past.map(|crease| asked(crease.full_target)).fold(0.0, f64::max).to_degrees();
    (!places.is_empty()).then(|| {
        let message = format!(
            "asked to fold past 180 degrees at {percent} %, up to {most:.1}: there its sides go through each other, and \
             which of several states is reached depends on the way"
        );
        Warning::new(WarningCode::OverFolding, Place::Creases(places), message)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::{Miura, SingleCrease};
    use crate::ids::EdgeId;
    use crate::model::Material;

    #[test]
    fn past_a_half_turn_is_told() {
        let model = Model::new(&Miura::default().pattern().unwrap(), &Material::default()).unwrap();
        for percents in [&[][..], &[0.0], &[100.0], &[-100.0, 60.0], &[100.000_000_01]] {
            assert_eq!(over_folding(&model, percents), None, "{percents:?}");
        }
        for percents in [&[101.0][..], &[0.0, -120.0, 100.0]] {
            let warning = over_folding(&model, percents).unwrap();
            let Place::Creases(creases) = &warning.place else { panic!("{warning}") };
            assert_eq!(creases.len(), model.creases.iter().filter(|crease| crease.full_target != 0.0).count());
        }
        assert!(over_folding(&model, &[-120.0]).unwrap().message.contains("at -120 %, up to 216.0"));
    }

    #[test]
    fn what_stays_below_is_not() {
        let pattern = SingleCrease { angle: 90.0_f64.to_radians(), ..SingleCrease::default() }.pattern().unwrap();
        let model = Model::new(&pattern, &Material::default()).unwrap();
        assert_eq!(over_folding(&model, &[199.0]), None);
        let warning = over_folding(&model, &[201.0]).unwrap();
        let edge = pattern.edges.iter().position(|edge| edge.fold_angle.is_some()).unwrap();
        let ends = [2, 3].map(|i| model.mesh.vertex_of_node[model.creases[0].nodes[i].index()]);
        assert_eq!(warning.place, Place::Creases(vec![CreasePlace::new(ends, Some(EdgeId::new(edge)))]));
        // A hinge without a spring is asked for nothing.
        let loose = Model::new(&pattern, &Material { k_fold: 0.0, ..Material::default() }).unwrap();
        assert_eq!(over_folding(&loose, &[201.0]), None);
    }
}
