//! Newton's method on sheets that touch themselves.

use origami_core::Solver;
use origami_core::contact::Crossings;
use origami_core::scene::Scene;
use origami_core::solve::{ContactNewton, ContactRelax, Relax, State, Stop, Touching, unwatched};

use crate::model;

#[test]
fn it_certifies_where_relaxation_ends() {
    for name in ["bird-base", "strip", "square-twist", "kresling"] {
        let model = model(name);
        let start = State::at_rest(&model);
        let near = ContactRelax::default().fold(&model, &start, &Scene::percent(100.0), &mut unwatched);
        let near = near.expect("it folds");
        assert_eq!(near.stop, Stop::Converged);
        let (reached, touch) =
            ContactNewton::default().refine(&model, &near.state, &Scene::default()).expect("it settles");
        assert!(reached.converged && reached.distance < 1e-9, "{name}: {} {}", reached.residual, reached.distance);
        let stability = reached.stability.expect("factors");
        assert_eq!((stability.negative, stability.neutral), (0, 6), "{name}: a minimum but for rigid motions");
        assert!(reached.factorisations < 30, "{name}: {}", reached.factorisations);
        assert!(touch.least_gap > 0.0 && touch.least_gap.is_finite(), "{name}");
        assert!(Crossings::of(&model.mesh, &reached.state.positions).is_empty(), "{name}");
        // The relaxation says how far it is from there.
        let moved = near.state.positions.iter().zip(&reached.state.positions).map(|(a, b)| (*a - *b).length());
        assert!(moved.fold(0.0, f64::max) < 1e-4, "{name}");
        // Forces of springs and contact, by the gradient of the energy that both have: along any move it does not change.
        let energy = |share: f64| {
            let moves = near.state.positions.iter().zip(&reached.state.positions).map(|(a, b)| *b + share * (*a - *b));
            let there = State { positions: moves.collect(), ..reached.state.clone() };
            let (_, touch) = ContactNewton { max_factorisations: 0, ..ContactNewton::default() }
                .refine(&model, &there, &Scene::default())
                .expect("it is measured");
            there.moved_to(&model, there.positions.clone()).energy(&model).total() + touch.energy
        };
        let (here, there) = (energy(0.0), energy(1.0));
        assert!(there >= here * (1.0 - 1e-12), "{name}: {there} is not below {here}");
    }
}

#[test]
fn folding_ends_certified_or_blocked() {
    let solver = ContactNewton::default();
    let strip = model("strip");
    let (folded, _) = solver
        .fold_touching(&strip, &State::at_rest(&strip), &Scene::percent(100.0), &mut unwatched)
        .expect("it folds");
    assert!(folded.converged() && folded.residual < 1e-10 && folded.factorisations > 0, "{}", folded.residual);
    let broken =
        |relax: Relax| ContactNewton { relax: ContactRelax { relax, ..ContactRelax::default() }, ..solver.clone() };
    let few = broken(Relax { max_steps: 100, ..Relax::default() });
    let folded = few.fold(&strip, &State::at_rest(&strip), &Scene::percent(100.0), &mut unwatched).expect("it folds");
    assert_eq!((folded.stop, folded.factorisations), (Stop::StepLimit, 0), "what is not at rest is not gone on with");
}
