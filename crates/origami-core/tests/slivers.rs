//! Sheets with sides a hundred thousand times shorter than the others: near nodes move as one, and Newton's method takes over
//! where FIRE crawls.

#[cfg(feature = "newton")]
use origami_core::forces::Forces;
use origami_core::generate::miura;
use origami_core::measure::align;
use origami_core::solve::Reflect;
use origami_core::{Folded, Material, Model, Relax, Solver};

const COLUMNS: usize = 6;
const NARROW: usize = 3;

/// A Miura sheet with one column of panels so wide, the others 1: its angles are those of the plain one, so that it folds flat.
fn sheet(width: f64) -> Model {
    let mut pattern = miura(COLUMNS, COLUMNS).expect("a pattern");
    let plain = pattern.vertices.clone();
    for (vertex, position) in pattern.vertices.iter_mut().enumerate() {
        if vertex % (COLUMNS + 1) > NARROW {
            *position -= (1.0 - width) * (plain[NARROW + 1] - plain[NARROW]);
        }
    }
    Model::new(&pattern, &Material::default()).expect("valid")
}

/// From rest to 100 %.
fn fold(relax: &Relax, model: &Model) -> Folded {
    relax.fold_from_rest(model, 100.0).expect("it holds")
}

/// In radii, from the state that is known without a solver.
fn from_exact(folded: &Folded, model: &Model) -> f64 {
    let exact = Reflect::default().fold_from_rest(model, 100.0).expect("it folds flat");
    align(&folded.state.positions, &exact.state.positions).max
}

/// FIRE alone, in one attempt.
fn fire(near: f64, max_steps: u64) -> Relax {
    Relax { near, hand_over: None, retry: false, max_steps, ..Relax::default() }
}

#[test]
fn near_nodes_move_as_one() {
    let plain = fold(&fire(0.4, 6000), &sheet(1.0));
    assert!(plain.converged());
    for width in [1e-3, 1e-4, 1e-5] {
        let model = sheet(width);
        let alone = fold(&fire(0.0, 6000), &model);
        assert!(!alone.converged(), "{width}: without clusters the sheet is dragged along by its short sides");
        let folded = fold(&fire(0.4, 6000), &model);
        assert!(folded.converged() && folded.factorisations == 0 && folded.steps < 8 * plain.steps, "{width}");
        assert!(from_exact(&folded, &model) < 1e-4, "{width}");
    }
}

#[cfg(feature = "newton")]
#[test]
fn where_fire_crawls_newton_takes_over_and_the_plain_forces_agree() {
    let model = sheet(3e-3);
    let limit = 8000;
    let alone = fold(&fire(0.0, limit), &model);
    assert!(!alone.converged());
    let folded = fold(&Relax { hand_over: Some(2), ..fire(0.0, limit) }, &model);
    assert!(folded.converged() && folded.steps < limit && (1..60).contains(&folded.factorisations));
    assert!(from_exact(&folded, &model) < 1e-4);
    let energy = |folded: &Folded| folded.state.energy(&model).total();
    assert!(energy(&folded) <= energy(&alone), "Newton's method only goes down");
    let state = &folded.state;
    let mut forces = Forces::new(&model);
    let plain = forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles.clone());
    let largest = plain.iter().map(|force| force.length()).fold(0.0, f64::max);
    assert!(largest == folded.residual && largest < 1e-3 * alone.residual, "{largest:e}");
}
