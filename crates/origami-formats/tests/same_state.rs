//! One pattern in every format is one pattern: the same sheet, and the same folded state.

mod written;

use origami_core::generate::catalog;
use origami_core::scene::Scene;
use origami_core::solve::{Relax, Solver, State, unwatched};
use origami_core::{CreasePattern, Material, Model};
use origami_formats::{Format, Options, open};

use written::{Segment, in_all_formats};

/// The lines of a generated pattern.
fn segments(name: &str) -> Vec<Segment> {
    let pattern = catalog::generate(name, &[]).expect("it is in the catalogue");
    let at = |vertex: origami_core::ids::VertexId| {
        let point = pattern.vertices[vertex.index()];
        [point.x, point.y]
    };
    let live = pattern.edges.iter().filter(|edge| edge.alias_of.is_none());
    live.map(|edge| Segment { letter: edge.assignment.letter(), ends: edge.vertices.map(at) }).collect()
}

fn folded(pattern: &CreasePattern, percent: f64) -> Vec<[f64; 3]> {
    let model = Model::new(pattern, &Material::default()).expect("a model");
    let folded = Relax::default().fold(&model, &State::at_rest(&model), &Scene::percent(percent), &mut unwatched);
    folded.expect("it folds").state.positions.iter().map(|p| p.to_array()).collect()
}

#[test]
fn one_pattern_in_all_formats_folds_to_one_state() {
    for (name, percent) in [("miura", 60.0), ("bird-base", 90.0), ("square-twist", 50.0)] {
        let segments = segments(name);
        let mut first: Option<(CreasePattern, Vec<[f64; 3]>)> = None;
        for (format, text) in in_all_formats(&segments) {
            let opened = open(text.as_bytes(), None, &Options::default()).unwrap_or_else(|e| panic!("{format}: {e}"));
            assert_eq!(opened.format, format, "{name}");
            let pattern = CreasePattern::from_document(&opened.document, 0).expect("a pattern");
            let state = folded(&pattern, percent);
            let (sheet, expected) = first.get_or_insert_with(|| (pattern.clone(), state.clone()));
            assert_eq!(
                (pattern.vertices.len(), pattern.faces.len()),
                (sheet.vertices.len(), sheet.faces.len()),
                "{format}"
            );
            assert_eq!(pattern.faces, sheet.faces, "{name} {format}");
            let letters =
                |pattern: &CreasePattern| pattern.edges.iter().map(|edge| edge.assignment).collect::<Vec<_>>();
            assert_eq!(letters(&pattern), letters(sheet), "{name} {format}");
            let far = expected.iter().zip(&state).flat_map(|(a, b)| a.iter().zip(b).map(|(a, b)| (a - b).abs()));
            assert!(far.fold(0.0, f64::max) < 1e-9, "{name} {format}");
        }
        assert_eq!(in_all_formats(&segments).len(), Format::ALL.len(), "no format is left out");
    }
}

/// A sheet that is not its own mirror image shows which way y runs.
#[test]
fn handedness_is_kept() {
    let corner = |a: [f64; 2], b: [f64; 2], letter| Segment { letter, ends: [a, b] };
    let hook = [
        corner([0.0, 0.0], [3.0, 0.0], "B"),
        corner([3.0, 0.0], [3.0, 1.0], "B"),
        corner([3.0, 1.0], [1.0, 1.0], "B"),
        corner([1.0, 1.0], [1.0, 2.0], "B"),
        corner([1.0, 2.0], [0.0, 2.0], "B"),
        corner([0.0, 2.0], [0.0, 0.0], "B"),
        corner([0.0, 0.0], [1.0, 1.0], "V"),
    ];
    for (format, text) in in_all_formats(&hook) {
        let document = open(text.as_bytes(), None, &Options::default()).expect("it is read").document;
        let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
        assert!((pattern.vertices[1].x - 3.0).abs() < 1e-12 && pattern.vertices[1].y.abs() < 1e-12, "{format}");
        assert!(pattern.vertices.iter().any(|p| p.distance([1.0, 2.0, 0.0].into()) < 1e-12), "{format}");
        assert_eq!(pattern.faces.len(), 2, "{format}");
    }
}
