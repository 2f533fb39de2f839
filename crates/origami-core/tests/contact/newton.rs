//! Newton's method on sheets that touch themselves.

use origami_core::contact::Crossings;
use origami_core::scene::Scene;
use origami_core::solve::{ContactNewton, ContactRelax, State, Stop, unwatched};

use crate::model;

#[test]
fn it_certifies_where_relaxation_ends() {
    for (name, percent) in [("bird-base", 100.0), ("strip", 100.0), ("square-twist", 100.0), ("kresling", 100.0), ("miura", 100.0), ("waterbomb", 100.0)] {
        let model = model(name);
        let began = std::time::Instant::now();
        let (near, _) = ContactRelax::default()
            .fold_touching(&model, &State::at_rest(&model), &Scene::percent(percent), &mut unwatched)
            .expect("it folds");
        let middle = began.elapsed();
        let (reached, touch) =
            ContactNewton::default().refine(&model, &near.state, &Scene::default()).expect("it settles");
        let moved = near.state.positions.iter().zip(&reached.state.positions).map(|(a, b)| (*a - *b).length());
        println!(
            "{name}: {:?} {:e} -> {} {:e}, moved {:e}, claimed {:e}, distance {:e}, {} factorisations, {} evaluations, {:?}, gap {:e}, {:?} + {:?}",
            near.stop, near.residual, reached.converged, reached.residual, moved.fold(0.0, f64::max), near.distance, reached.distance,
            reached.factorisations, reached.evaluations, reached.stability, touch.least_gap, middle, began.elapsed() - middle
        );
        assert_eq!(near.stop, Stop::Converged);
        assert!(Crossings::of(&model.mesh, &reached.state.positions).is_empty(), "{name}");
    }
}
