//! Sheets that cannot go through themselves: folded under contact, looked at on the whole way by the exact test.
#![expect(clippy::expect_used, reason = "a test may")]

use std::ops::ControlFlow;

use origami_core::contact::Crossings;
use origami_core::fold::Document;
use origami_core::generate::catalog;
use origami_core::glam::DVec3;
use origami_core::ids::EdgeId;
use origami_core::scene::{Refusal, Scene, Targets};
use origami_core::sequence::Sequence;
use origami_core::solve::{ContactRelax, Failed, Folded, Precision, Relax, State, Steps, Stop, Touch};
use origami_core::{CreasePattern, Material, Model, Solver};

fn model(name: &str) -> Model {
    Model::new(&catalog::generate(name, &[]).expect("a pattern"), &Material::default()).expect("a model")
}

/// Folds from rest, and counts the evaluations, of each tenth, that are crossed.
fn watched(model: &Model, solver: &ContactRelax, scene: &Scene) -> (Folded, Touch, usize) {
    let mut crossed = 0;
    let mut look = |evaluation: u64, positions: &[DVec3]| {
        if evaluation.is_multiple_of(10) {
            crossed += usize::from(!Crossings::of(&model.mesh, positions).is_empty());
        }
    };
    let folded = solver.fold_looking(model, &State::at_rest(model), scene, &mut look);
    let (folded, touch) = folded.expect("it folds");
    crossed += usize::from(!Crossings::of(&model.mesh, &folded.state.positions).is_empty());
    (folded, touch, crossed)
}

/// The largest difference between angles and targets, in degrees.
fn off(folded: &Folded) -> f64 {
    let State { fold_angles, targets, .. } = &folded.state;
    fold_angles.iter().zip(targets).map(|(a, t)| (a - t).abs().to_degrees()).fold(0.0, f64::max)
}

#[test]
fn nothing_crosses_on_the_way_to_flat() {
    let mut touched = 0;
    for (name, most_off) in
        [("bird-base", 1.5), ("strip", 1.5), ("square-twist", 2.5), ("miura", 2.5), ("kresling", 1.5)]
    {
        let model = model(name);
        let (folded, touch, crossed) = watched(&model, &ContactRelax::default(), &Scene::percent(100.0));
        assert_eq!(crossed, 0, "{name}");
        assert_eq!(folded.stop, Stop::Converged, "{name}: {touch:?}");
        assert!(off(&folded) < most_off, "{name}: {} degrees off", off(&folded));
        assert!(touch.least_gap > 0.0, "{name}");
        touched += usize::from(touch.least_gap.is_finite());
        // The same sheet without contact, to see that there is something to be prevented.
        let free = Relax::default().fold_from_rest(&model, 100.0).expect("it folds");
        assert!(folded.steps < 8 * free.steps, "{name}: {} evaluations, {} without", folded.steps, free.steps);
    }
    assert!(touched >= 4, "layers touch in {touched} patterns");
}

/// The prototype's fuzz: random targets on random patterns, in random order; `runs` of them.
fn fuzz(runs: u64) -> usize {
    let mut state = 11_u64;
    let mut next = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(state >> 33).expect("31 bits")) / f64::from(1_u32 << 31)
    };
    let names = ["bird-base", "square-twist", "waterbomb-vertex", "kresling", "strip", "degree-4"];
    let models = names.map(model);
    let mut crossed_without = 0;
    for run in 0..runs {
        #[expect(clippy::cast_possible_truncation, reason = "a few")]
        let model = &models[run as usize % models.len()];
        let targets: Vec<f64> = model.creases.iter().map(|_| (2.0 * next() - 1.0) * std::f64::consts::PI).collect();
        let scene = Scene::new(Targets::angles(targets));
        let gap = 10.0_f64.powf(-2.0 - 1.5 * next());
        let relax = Relax { ramp: Some(200), steps: Some(500), ..Relax::default() };
        let mut solver = ContactRelax { relax, ..ContactRelax::default() };
        solver.contact.gap = gap;
        let (folded, touch, crossed) = watched(model, &solver, &scene);
        assert_eq!(crossed, 0, "run {run}, gap {gap}");
        assert!(folded.state.positions.iter().all(|p| p.is_finite()) && touch.least_gap > 0.0, "run {run}");
        let free = Relax { retry: false, ..solver.relax.clone() };
        let free = free.fold(model, &State::at_rest(model), &scene, &mut |_| ControlFlow::Continue(()));
        crossed_without += usize::from(free.is_ok_and(|f| !Crossings::of(&model.mesh, &f.state.positions).is_empty()));
    }
    crossed_without
}

#[test]
fn random_folds_do_not_cross() {
    let without = fuzz(12);
    assert!(without >= 3, "only {without} cross without contact: this shows little");
}

#[test]
#[ignore = "a thousand runs take minutes"]
fn a_thousand_random_folds_do_not_cross() {
    assert!(fuzz(1000) > 200);
}

#[test]
#[ignore = "minutes: all patterns, percentages and perturbations"]
fn nothing_crosses_in_any_pattern() {
    for name in catalog::names() {
        let model = model(name);
        for percent in [60.0, 90.0, 99.0, 100.0] {
            for perturbation in [1e-2, 5e-3, 2e-3] {
                let relax = Relax { perturbation, max_steps: 8000, ..Relax::default() };
                let solver = ContactRelax { relax, ..ContactRelax::default() };
                let (folded, touch, crossed) = watched(&model, &solver, &Scene::percent(percent));
                assert_eq!(crossed, 0, "{name} at {percent} %, {perturbation}");
                assert!(matches!(folded.stop, Stop::Converged | Stop::Blocked | Stop::StepLimit), "{name}: {touch:?}");
            }
        }
    }
}

/// Three equal panels; both creases are valleys, asked to lie flat.
const LETTER: &str = include_str!("../../../examples/sequences/letter-fold.fold");

fn letter() -> (Document, CreasePattern, Model) {
    let document = Document::from_slice(LETTER.as_bytes()).expect("a document");
    let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    (document, pattern, model)
}

#[test]
fn a_letter_closes_in_order_and_is_blocked_at_once() {
    let (document, pattern, model) = letter();
    let frame = document.frame(0).expect("a frame");
    let sequence = Sequence::in_frame(&frame).expect("a sequence").expect("one");
    let stages = sequence.stages(&frame, &pattern, &model).expect("stages");
    let solver = ContactRelax::default();
    let mut steps = Steps::new(&model, &solver.relax, &State::at_rest(&model)).with_contact(solver.contact);
    for (number, stage) in stages.iter().enumerate() {
        steps.fold(stage, (number, 1), &mut |_| ControlFlow::Continue(())).expect("it folds");
    }
    let last = steps.states().last().expect("two states");
    assert_eq!(last.folded.stop, Stop::Converged, "{:?}", last.touch);
    assert!(off(&last.folded) < 5.0, "{} degrees off", off(&last.folded));
    assert!(Crossings::of(&model.mesh, &last.folded.state.positions).is_empty());
    let (at_once, touch, crossed) = watched(&model, &solver, &Scene::percent(100.0));
    assert_eq!((at_once.stop, crossed), (Stop::Blocked, 0), "{touch:?}");
    let hardest = touch.pressing.first().expect("something presses");
    assert_eq!(hardest.faces.map(|face| face.0), [0, 2], "the outer panels: {:?}", touch.pressing);
    assert!(touch.first_limited.is_some() && touch.farthest.is_some_and(|(_, off)| off > 0.3), "{touch:?}");
    let creases = [8, 9].map(|edge| model.crease_of(EdgeId(edge)).expect("a crease"));
    assert!(touch.farthest.is_some_and(|(crease, _)| creases.contains(&crease)));
}

#[test]
fn where_nothing_touches_the_state_is_the_same() {
    for (name, percent) in [("miura", 60.0), ("degree-4", 70.0), ("hypar", 100.0)] {
        let model = model(name);
        let scene = Scene::percent(percent);
        let relax = Relax { softening: None, tolerance: 1e-7, ..Relax::default() };
        let solver = ContactRelax { relax: relax.clone(), ..ContactRelax::default() };
        let (with, touch, crossed) = watched(&model, &solver, &scene);
        let without =
            relax.fold(&model, &State::at_rest(&model), &scene, &mut |_| ControlFlow::Continue(())).expect("folds");
        assert_eq!((touch.limited, crossed), (0, 0), "{name}");
        let apart = with.state.positions.iter().zip(&without.state.positions).map(|(a, b)| (*a - *b).length());
        let apart = apart.fold(0.0, f64::max);
        assert!(apart < 1e-5, "{name}: {apart}");
        assert!(with.steps as f64 <= 1.3 * without.steps as f64, "{name}: {} and {}", with.steps, without.steps);
    }
}

#[test]
fn equal_bits_for_any_number_of_threads() {
    let model = model("miura");
    let fold = |threads: usize| {
        let threads = std::num::NonZeroUsize::new(threads);
        let relax = Relax { threads, ramp: Some(150), steps: Some(200), ..Relax::default() };
        ContactRelax { relax, ..ContactRelax::default() }.fold_from_rest(&model, 100.0).expect("it folds").state
    };
    assert_eq!(fold(1), fold(3));
}

#[test]
fn what_begins_crossed_or_has_no_sense_is_refused() {
    let model = model("miura");
    let mut next = 0.0_f64;
    let crumpled = model.rest.iter().map(|p| {
        next += 1.0;
        *p + 0.3 * DVec3::new((12.9 * next).sin(), (78.2 * next).sin(), (37.7 * next).sin())
    });
    let crossed = State::at(&model, crumpled.collect());
    assert!(!Crossings::of(&model.mesh, &crossed.positions).is_empty());
    let fold =
        |solver: ContactRelax, start: &State| match solver
            .fold(&model, start, &Scene::percent(100.0), &mut |_| ControlFlow::Continue(()))
        {
            Err(Failed::Refused { refusal, .. }) => refusal,
            other => panic!("not refused: {other:?}"),
        };
    assert!(matches!(fold(ContactRelax::default(), &crossed), Refusal::Crossed { .. }));
    let mut bad = ContactRelax::default();
    bad.contact.gap = 0.0;
    assert_eq!(fold(bad, &State::at_rest(&model)).to_string(), "contact: gap 0; expected a finite number above 0");
    let mixed = Relax { precision: Precision::Mixed, ..Relax::default() };
    let mixed = ContactRelax { relax: mixed, ..ContactRelax::default() };
    assert!(matches!(fold(mixed, &State::at_rest(&model)), Refusal::Unsupported { .. }));
}

/// An accordion of so many panels of 1 x 1.5, mountains and valleys in turn. Its creases are slanted by a ten thousandth, so
/// that all diagonals by which panels are cut are parallel, or those of neighbours `mirrored`.
fn accordion(panels: u32, mirrored: bool) -> Model {
    let node = |column: u32, row: u32| 2 * column + row;
    let slant = |column: u32| match (mirrored, column.is_multiple_of(2)) {
        (false, _) => 1e-4,
        (true, true) => 1e-4 * f64::from(column),
        (true, false) => -1e-4 * f64::from(column),
    };
    let mut vertices = Vec::new();
    let (mut edges, mut letters, mut faces) = (Vec::new(), Vec::new(), Vec::new());
    for column in 0..=panels {
        vertices.extend([[f64::from(column), 0.0], [f64::from(column) + slant(column), 1.5]]);
        edges.push([node(column, 0), node(column, 1)]);
        let fold = if column.is_multiple_of(2) { "V" } else { "M" };
        letters.push(if column == 0 || column == panels { "B" } else { fold });
    }
    for column in 0..panels {
        let [a, b, c, d] = [node(column, 0), node(column + 1, 0), node(column + 1, 1), node(column, 1)];
        edges.extend([[a, b], [c, d]]);
        letters.extend(["B", "B"]);
        faces.push([a, b, c, d]);
    }
    let text = serde_json::json!({
        "vertices_coords": vertices, "edges_vertices": edges, "edges_assignment": letters, "faces_vertices": faces,
    });
    let document = Document::from_slice(text.to_string().as_bytes()).expect("a document");
    let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    // Which way each diagonal goes, from left to right.
    let diagonals = model.mesh.sides.iter().filter(|side| side.edge.is_none());
    let mut ways: Vec<(u32, bool)> = diagonals
        .map(|side| {
            let mut ends = side.nodes.map(|n| model.mesh.vertex_of_node[n.index()].0);
            ends.sort_unstable();
            (ends[0] / 2, ends[0].is_multiple_of(2))
        })
        .collect();
    ways.sort_unstable();
    assert_eq!(ways.len(), panels as usize);
    assert!(ways.windows(2).all(|pair| (pair[0].1 != pair[1].1) == mirrored), "{ways:?}");
    model
}

/// How far apart the centroids of the first and the last panel are along the stack, as a multiple of what rigid panels of
/// that thickness have.
fn height(panels: u32, mirrored: bool) -> f64 {
    let thickness = 0.004;
    let model = accordion(panels, mirrored);
    let contact = origami_core::contact::Contact::thick(thickness);
    let solver = ContactRelax { contact, ..ContactRelax::default() };
    let (folded, touch, crossed) = watched(&model, &solver, &Scene::percent(100.0));
    assert_eq!((folded.stop, crossed), (Stop::Converged, 0), "{panels} panels: {touch:?}");
    let at = |vertex: u32| {
        let node = model.node(origami_core::ids::VertexId(vertex)).expect("a node");
        folded.state.positions[node.index()]
    };
    let centroid = |panel: u32| (0..4).map(|i| at(2 * panel + i)).sum::<DVec3>() / 4.0;
    // The stack is along the normal of its panels.
    let normal = (at(2) - at(0)).cross(at(1) - at(0)).normalize();
    (centroid(panels - 1) - centroid(0)).dot(normal).abs() / (f64::from(panels - 1) * thickness)
}

#[test]
fn the_height_of_an_accordion_does_not_depend_on_its_cuts() {
    for panels in [4, 8] {
        let [parallel, mirrored] = [false, true].map(|mirrored| height(panels, mirrored));
        for height in [parallel, mirrored] {
            assert!((height - 1.0).abs() < 0.08, "{panels} panels: {height} times (n - 1) t");
        }
        assert!((parallel - mirrored).abs() < 0.02, "{panels} panels: {parallel} and {mirrored}");
    }
}
