//! The flat-folded state by reflection: lengths, angles and equilibrium are checked by what knows nothing of reflections.

use std::f64::consts::PI;
use std::path::Path;

use origami_core::generate::catalog;
use origami_core::ids::NodeId;
use origami_core::measure::{Strain, align};
use origami_core::scene::{Load, NotFlat, Refusal};
use origami_core::solve::{Failed, Reflect, Stop, unwatched};
use origami_core::{CreasePattern, Folded, Material, Model, Relax, Scene, Solver, State, glam::DVec3};

/// Generated patterns that fold flat, some with other parameters than the generator's own.
const FLAT: [(&str, &[(&str, f64)]); 9] = [
    ("single-crease", &[]),
    ("strip", &[]),
    ("degree-4", &[("angle", 180.0)]),
    ("miura", &[]),
    ("miura", &[("columns", 40.0), ("rows", 40.0)]),
    ("waterbomb", &[]),
    ("square-twist", &[]),
    ("square-twist", &[("columns", 3.0), ("rows", 3.0)]),
    ("bird-base", &[]),
];

fn generated(name: &str, parameters: &[(&str, f64)]) -> (CreasePattern, Model) {
    let parameters: Vec<(String, f64)> = parameters.iter().map(|&(name, value)| (name.into(), value)).collect();
    let pattern = catalog::generate(name, &parameters).expect(name);
    let model = Model::new(&pattern, &Material::default()).expect(name);
    (pattern, model)
}

fn reflected(model: &Model, percent: f64) -> Folded {
    Reflect::default().fold_from_rest(model, percent).expect("it folds flat")
}

fn refused(model: &Model, scene: &Scene) -> Refusal {
    match Reflect::default().fold(model, &State::at_rest(model), scene, &mut unwatched) {
        Err(Failed::Refused { refusal, .. }) => refusal,
        other => panic!("{other:?}"),
    }
}

/// Lengths of all beams off those at rest, and whether each crease has the angle asked of it.
fn is_exact(model: &Model, folded: &Folded, lengths: f64) -> bool {
    let at = |n: NodeId| folded.state.positions[n.index()];
    let isometric =
        model.beams.iter().all(|b| (at(b.nodes[0]).distance(at(b.nodes[1])) - b.rest_length).abs() < lengths);
    let angles = folded.state.fold_angles.iter().zip(&folded.state.targets);
    isometric && angles.into_iter().all(|(angle, target)| (angle - target).abs() < 1e-9)
}

#[test]
fn lengths_stay_and_creases_fold_as_their_letters_say() {
    for (name, parameters) in FLAT {
        let (_, model) = generated(name, parameters);
        for percent in [100.0, -100.0] {
            let folded = reflected(&model, percent);
            assert!(is_exact(&model, &folded, 1e-12), "{name} {parameters:?} at {percent} %");
            let folds = model.creases.iter().zip(&folded.state.fold_angles).filter(|(c, _)| c.full_target != 0.0);
            for (crease, angle) in folds {
                assert!((angle - PI.copysign(crease.full_target * percent)).abs() < 1e-9, "{name}: {angle}");
            }
            assert!(
                folded.distance < 1e-12 && folded.residual < 1e-9,
                "{name}: {} {}",
                folded.distance,
                folded.residual
            );
            assert_eq!((folded.stop, folded.steps), (Stop::Converged, 0));
        }
    }
}

#[test]
fn one_that_is_off_is_not_exact() {
    let (_, model) = generated("bird-base", &[]);
    let mut folded = reflected(&model, 100.0);
    folded.state.fold_angles[3] += 1e-6;
    assert!(!is_exact(&model, &folded, 1e-12));
    let mut folded = reflected(&model, 100.0);
    folded.state.positions[3].x += 1e-9;
    assert!(!is_exact(&model, &folded, 1e-12));
}

#[test]
fn shipped_files_that_fold_flat_do() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/patterns");
    let mut flat = Vec::new();
    for entry in std::fs::read_dir(folder).expect("the examples") {
        let path = entry.expect("an entry").path();
        let Ok(pattern) = CreasePattern::read(&path) else { continue };
        let model = Model::new(&pattern, &Material::default()).expect("a model");
        if let Ok(folded) = Reflect::default().fold_from_rest(&model, 100.0) {
            assert!(is_exact(&model, &folded, 1e-9), "{}", path.display());
            flat.push(path.file_stem().expect("a name").to_string_lossy().into_owned());
        }
    }
    flat.sort();
    let expected = ["bird-base", "miura", "single-crease", "square-twist", "strip", "waterbomb"].map(String::from);
    assert_eq!(flat, expected);
}

#[test]
fn it_is_where_a_relaxation_ends_too() {
    for (name, parameters) in [FLAT[3], FLAT[8]] {
        let (_, model) = generated(name, parameters);
        let relaxed = Relax { tolerance: 1e-6, ..Relax::default() }.fold_from_rest(&model, 100.0).expect("it holds");
        let apart = align(&relaxed.state.positions, &reflected(&model, 100.0).state.positions);
        assert!(apart.max < 1e-5, "{name}: {}", apart.max);
    }
}

#[test]
fn disturbed_it_comes_back() {
    let (_, model) = generated("bird-base", &[]);
    let flat = reflected(&model, 100.0).state;
    let mut away = flat.clone();
    for (i, p) in away.positions.iter_mut().enumerate() {
        *p += 1e-3 * DVec3::new((1.7 * i as f64).sin(), (2.9 * i as f64).cos(), (4.3 * i as f64).sin());
    }
    let back = Relax::default().fold(&model, &away, &Scene::percent(100.0), &mut unwatched).expect("it holds");
    assert!(align(&back.state.positions, &flat.positions).max < 1e-4);
}

#[test]
fn what_has_no_flat_state_is_refused_by_name() {
    let (_, miura) = generated("miura", &[]);
    let partly = refused(&miura, &Scene::percent(60.0));
    assert!(
        matches!(partly, Refusal::NotFlat(NotFlat::Angle { degrees, .. }) if (degrees.abs() - 108.0).abs() < 1e-9),
        "{partly}"
    );
    let load = Scene::percent(100.0).with_load(Load { node: NodeId(0), force: DVec3::ZERO });
    assert!(matches!(refused(&miura, &load), Refusal::Unsupported { what: "loads", .. }));

    let (mut pattern, _) = generated("miura", &[]);
    let inner = pattern.vertices.len() / 2;
    pattern.vertices[inner].x += 0.05 * pattern.size();
    let bent = Model::new(&pattern, &Material::default()).expect("a model");
    let open = refused(&bent, &Scene::percent(100.0));
    let Refusal::NotFlat(NotFlat::Open { spread, vertex, .. }) = open else { panic!("{open}") };
    assert!(spread > 1e-3 && vertex.index() < pattern.vertices.len());
    let loose = Reflect { tolerance: 1.0 }.fold_from_rest(&bent, 100.0).expect("taken as it is");
    assert_eq!(loose.distance, spread);
    assert!(Strain::of(&bent, &loose.state.positions).beams.max > 1e-3);

    let (ring, _) = generated("kresling-ring", &[]);
    let ring = Model::new(&ring, &Material::default()).expect("a model");
    assert_eq!(refused(&ring, &Scene::percent(100.0)), NotFlat::Sheet.into());
}

#[test]
fn held_vertices_of_one_face_stay_and_others_are_refused() {
    let (_, mut model) = generated("miura", &[]);
    model.fixed = model.mesh.triangles[5].to_vec();
    model.fixed.sort_unstable();
    let folded = reflected(&model, 100.0);
    for node in &model.fixed {
        assert!(folded.state.positions[node.index()].distance(model.rest[node.index()]) < 1e-12);
    }
    model.fixed = (0..model.node_count()).map(NodeId::new).collect();
    assert!(matches!(refused(&model, &Scene::percent(100.0)), Refusal::NotFlat(NotFlat::Held { .. })));
}

/// Patterns by designers, where the folder that has them is there: each is strained by as much as its own file misses itself.
#[test]
fn designers_patterns_fold_to_what_their_files_allow() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/patterns/designers");
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    let mut folded = 0;
    for path in entries.map(|entry| entry.expect("an entry").path()) {
        let Ok(pattern) = CreasePattern::read(&path) else { continue };
        let Some(closure) = pattern.reflected().map(|reflected| reflected.closure.spread) else { continue };
        let model = Model::new(&pattern, &Material::default()).expect("a model");
        let flat = Reflect { tolerance: 1e-3 }.fold_from_rest(&model, 100.0).expect("it folds flat");
        assert!(is_exact(&model, &flat, 2.0 * flat.distance.max(1e-12)) || flat.distance > 1e-9, "{}", path.display());
        // Other ways lead to a triangle than to a face; the misfit is of the same size.
        assert!(flat.distance <= 20.0 * closure.max(1e-13), "{}: {} {closure}", path.display(), flat.distance);
        folded += 1;
    }
    assert!(folded > 50, "{folded}");
}
