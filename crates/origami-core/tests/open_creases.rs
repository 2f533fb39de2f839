//! Creases that end inside a face: found before folding, and told of afterwards.

use std::path::Path;

use origami_core::error::{Place, WarningCode};
use origami_core::flat::{FlatFoldability, open_ends};
use origami_core::ids::{EdgeId, FaceId, VertexId};
use origami_core::measure::{Strain, folded_warnings};
use origami_core::{CreasePattern, Material, Model, Relax, Solver};

#[test]
fn a_crease_that_ends_inside_a_face_is_told_with_what_it_is_off() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/cases/spur_valley.fold");
    let pattern = CreasePattern::read(path).expect("a pattern");
    let ends = open_ends(&pattern);
    assert_eq!(ends.len(), 1);
    assert_eq!((ends[0].vertex, ends[0].crease, ends[0].face), (VertexId(6), EdgeId(7), FaceId(0)));
    // Its end (1, 1) is 1 from the lines 0-1, 1-4 and 4-5 around its face.
    assert!(ends[0].nearest.is_some_and(|(_, distance)| (distance - 1.0).abs() < 1e-12), "{ends:?}");
    let flat = FlatFoldability::of(&pattern);
    assert!(flat.applies() && flat.open_ends == ends && flat.faults.is_empty());

    let model = Model::new(&pattern, &Material::default()).expect("a model");
    for (percent, off) in [(100.0, 90.0), (60.0, 54.0)] {
        let folded = Relax::default().fold_from_rest(&model, percent).expect("it folds");
        assert!(folded.converged() && Strain::of(&model, &folded.state.positions).beams.max < 1e-6);
        let warnings = folded_warnings(&pattern, &model, &folded);
        let [warning] = &warnings[..] else { panic!("{warnings:?}") };
        assert_eq!(warning.code, WarningCode::OpenCrease);
        let Place::Creases(creases) = &warning.place else { panic!("{warning}") };
        assert_eq!((creases.len(), creases[0].edge), (1, Some(EdgeId(7))));
        // The crease from the corner and the diagonal beside it share the fold: each gets half of its angle.
        let text = warning.to_string();
        assert!(
            text.contains("ends inside face 0 at vertex 6") && text.contains(&format!("{off:.1} degrees off")),
            "{text}"
        );
        let whole = model
            .creases
            .iter()
            .zip(&folded.state.fold_angles)
            .find(|(crease, _)| model.mesh.sides[crease.side.index()].edge == Some(EdgeId(6)));
        assert!((whole.expect("crease 1-4").1.to_degrees() - 1.8 * percent).abs() < 0.01, "crease 1-4 folds");
    }
}
