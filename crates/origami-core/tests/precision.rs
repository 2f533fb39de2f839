//! Computing in f32 with places in f64 leads to the same equilibria as f64 throughout.

use origami_core::generate::catalog;
use origami_core::measure::align;
use origami_core::scene::Scene;
use origami_core::solve::unwatched;
use origami_core::solve::{Dynamics, Folded, Precision, Relax, Solver, State};
use origami_core::{Material, Model};

fn model(name: &str) -> Model {
    Model::new(&catalog::generate(name, &[]).expect("a pattern"), &Material::default()).expect("a model")
}

/// The same sheet by both, the second from where the first ended: so that a sheet with several equilibria does not take
/// another way in other numbers.
fn both(model: &Model, percent: f64) -> [Folded; 2] {
    let exact = Relax { tolerance: 1e-7, ..Relax::default() };
    let mixed = Relax { precision: Precision::Mixed, tolerance: 1e-6, max_steps: 20_000, ..exact.clone() };
    let exact = exact.fold_from_rest(model, percent).expect("holds");
    let start = exact.state.clone();
    let mixed = Relax { steps: Some(2000), ramp: Some(0), ..mixed }.fold(
        model,
        &start,
        &Scene::percent(percent),
        &mut unwatched,
    );
    [exact, mixed.expect("holds")]
}

#[test]
fn a_folded_sheet_stays_where_it_is() {
    for name in catalog::names() {
        let model = model(name);
        for percent in [60.0, 100.0] {
            let [exact, mixed] = both(&model, percent);
            let apart = align(&mixed.state.positions, &exact.state.positions).max;
            assert!(apart < 1e-5, "{name} at {percent} %: {apart}");
        }
    }
}

#[test]
fn the_way_from_rest_ends_at_the_same_place() {
    let mut differ = false;
    for name in catalog::names() {
        let model = model(name);
        for percent in [60.0, 100.0] {
            let exact = Relax { tolerance: 1e-7, ..Relax::default() };
            let mixed = Relax { precision: Precision::Mixed, tolerance: 1e-6, max_steps: 20_000, ..exact.clone() };
            let [one, other] = [&exact, &mixed].map(|relax| relax.fold_from_rest(&model, percent).expect("holds"));
            let end = if *name == "curved-pleat" {
                // It lies in a valley so flat that equilibria 1e-5 apart differ by rounding: the one nearby counts.
                let on = Relax { ramp: Some(0), ..exact.clone() };
                on.fold(&model, &other.state, &Scene::percent(percent), &mut unwatched).expect("holds")
            } else {
                one
            };
            let apart = align(&other.state.positions, &end.state.positions).max;
            assert!(apart < 1e-5, "{name} at {percent} %: {apart}");
            differ |= other.state.positions != end.state.positions;
        }
    }
    assert!(differ, "they were computed in the same numbers");
}

#[test]
fn a_hundred_steps_of_motion_agree() {
    let model = model("miura");
    let [exact, mixed] = [Precision::F64, Precision::Mixed].map(|precision| {
        let solver = Dynamics { precision, steps: Some(100), ..Dynamics::default() };
        solver.fold(&model, &State::at_rest(&model), &Scene::percent(60.0), &mut unwatched).expect("holds").state
    });
    let apart = exact.positions.iter().zip(&mixed.positions).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    assert!(apart > 0.0 && apart < 1e-6, "{apart}");
}
