//! Motions to the flat-folded state that are found from there.

use origami_core::contact::Crossings;
use origami_core::fold::Document;
use origami_core::generate::catalog;
use origami_core::layers::{NoOrder, face_orders};
use origami_core::solve::{Backwards, Motion, NotBackwards, Reflect, unwatched};
use origami_core::{CreasePattern, Material, Model, Relax, Solver};

fn model(name: &str) -> Model {
    Model::new(&catalog::generate(name, &[]).expect("a pattern"), &Material::default()).expect("a model")
}

fn found(model: &Model) -> Motion {
    let motion = Backwards::default().fold(model, 4, &mut unwatched);
    motion.unwrap_or_else(|why| panic!("{why}"))
}

/// From the sheet as it is to the exact flat state, nothing crosses; what is seen of the layers just before is what is told of them.
#[test]
fn sheets_fold_flat_without_crossings_and_tell_their_order() {
    for name in ["bird-base", "square-twist"] {
        let model = model(name);
        let free = Relax::default().fold_from_rest(&model, 100.0).expect("it folds");
        assert!(
            !Crossings::of(&model.mesh, &free.state.positions).is_empty(),
            "{name} crosses itself where nothing keeps it"
        );
        let motion = found(&model);
        for (number, folded) in motion.states.iter().enumerate() {
            let crossings = Crossings::of(&model.mesh, &folded.state.positions);
            assert!(crossings.is_empty(), "{name}, state {number}: {:?}", crossings.faces);
        }
        let [first, .., before, last] = &motion.states[..] else { panic!("{name}: {} states", motion.states.len()) };
        assert_eq!(first.state.positions, model.rest);
        let flat = Reflect::default().fold_from_rest(&model, 100.0).expect("it folds flat");
        assert_eq!(last.state.positions, flat.state.positions);
        assert!(motion.off.to_degrees() < 1.0, "{name}: {} degrees", motion.off.to_degrees());
        // Contact leads from state to state; none is far from the next.
        assert!(motion.touching > 4 && motion.touching < motion.states.len());
        let seen = face_orders(&model, &before.state.positions, &before.state.fold_angles).expect("it is flat");
        assert_eq!(seen, motion.stacking.faces, "{name}");
    }
}

/// Four valleys at one vertex close when they are reflected, and yet no order of layers lets them lie flat.
#[test]
fn what_cannot_lie_flat_is_told() {
    let text = r#"{"file_spec": 1.2,
        "vertices_coords": [[0,0],[1,0],[1,1],[0,1],[-1,1],[-1,0],[-1,-1],[0,-1],[1,-1]],
        "edges_vertices": [[1,2],[2,3],[3,4],[4,5],[5,6],[6,7],[7,8],[8,1],[0,1],[0,3],[0,5],[0,7]],
        "edges_assignment": ["B","B","B","B","B","B","B","B","V","V","V","V"],
        "faces_vertices": [[0,1,2,3],[0,3,4,5],[0,5,6,7],[0,7,8,1]]}"#;
    let document = Document::from_slice(text.as_bytes()).expect("a file");
    let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let why = Backwards::default().fold(&model, 4, &mut unwatched).expect_err("it cannot lie flat");
    assert!(matches!(why, NotBackwards::Order(NoOrder::Contradiction)), "{why}");
    let why = Backwards::default().fold(&self::model("hypar"), 4, &mut unwatched).expect_err("it is not flat");
    assert!(matches!(why, NotBackwards::Failed(_)), "{why}");
}
