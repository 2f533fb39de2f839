//! Settings that are saved come back; what is misspelt is not passed over.

use std::num::NonZeroUsize;

use origami_core::glam::DVec3;
use origami_core::ids::{EdgeId, NodeId};
use origami_core::model::MaterialGrid;
use origami_core::solve::{Integrator, TimeStep};
use origami_core::{Dynamics, Material, Relax};
use serde_json::{from_value, json, to_value};

#[test]
fn settings_come_back_and_what_is_left_out_is_the_default() {
    let material = Material { ea: 0.1 + 0.2, zeta: 0.3, ..Material::default() };
    let saved = to_value(material).unwrap();
    assert_eq!(from_value::<Material>(saved).unwrap(), material);
    assert_eq!(from_value::<Material>(json!({ "ea": 50 })).unwrap(), Material { ea: 50.0, ..Material::default() });
    assert!(from_value::<Material>(json!({ "k_folds": 1 })).is_err(), "a misspelt number");
    let grid = MaterialGrid { k_fold: vec![0.1, 0.7], ..MaterialGrid::default() };
    assert_eq!(from_value::<MaterialGrid>(to_value(&grid).unwrap()).unwrap(), grid);
}

#[test]
fn ids_and_vectors_are_plain_numbers() {
    assert_eq!(to_value([EdgeId(3), EdgeId(9)]).unwrap(), json!([3, 9]));
    assert_eq!(from_value::<NodeId>(json!(7)).unwrap(), NodeId(7));
    assert_eq!(to_value(DVec3::new(1.0, -2.5, 0.0)).unwrap(), json!([1.0, -2.5, 0.0]));
}

#[test]
fn settings_of_solvers_come_back_and_what_is_left_out_is_the_default() {
    let relax = Relax { ramp: Some(7), threads: NonZeroUsize::new(3), ..Relax::default() };
    assert_eq!(from_value::<Relax>(to_value(&relax).unwrap()).unwrap(), relax);
    assert_eq!(from_value::<Relax>(json!({ "ramp": 7, "threads": 3 })).unwrap(), relax);
    assert!(from_value::<Relax>(json!({ "ramps": 7 })).is_err(), "a misspelt setting");
    let dynamics = Dynamics { time_step: TimeStep::Fixed(0.01), integrator: Integrator::Verlet, ..Dynamics::default() };
    assert_eq!(from_value::<Dynamics>(to_value(&dynamics).unwrap()).unwrap(), dynamics);
    assert_ne!(from_value::<Dynamics>(json!({})).unwrap(), dynamics);
}
