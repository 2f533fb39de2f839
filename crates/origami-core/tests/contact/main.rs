//! Sheets that cannot go through themselves: folded under contact, looked at on the whole way by the exact test.
#![expect(clippy::expect_used, reason = "a test may")]

mod catalog;
mod dynamics;
mod held_up;
mod layers;
mod narrowed;
#[cfg(feature = "newton")]
mod newton;
mod orders;
mod thickness;

use std::ops::ControlFlow;

use origami_core::contact::Crossings;
use origami_core::fold::Document;
use origami_core::generate::catalog::generate;
use origami_core::glam::DVec3;
use origami_core::ids::VertexId;
use origami_core::scene::{Refusal, Scene};
use origami_core::sequence::Sequence;
use origami_core::solve::{ContactRelax, Failed, Folded, Precision, Reached, Relax, State, Steps, Touch};
use origami_core::{CreasePattern, Material, Model, Solver};

fn model(name: &str) -> Model {
    Model::new(&generate(name, &[]).expect("a pattern"), &Material::default()).expect("a model")
}

fn model_of(pattern: &CreasePattern) -> Model {
    Model::new(pattern, &Material::default()).expect("a model")
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

/// Folds step by step as a document and steps in JSON say.
fn in_steps(text: &str, steps: &serde_json::Value, contact: ContactRelax) -> (Model, Vec<Reached>) {
    let document = Document::from_slice(text.as_bytes()).expect("a document");
    let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
    let model = model_of(&pattern);
    let frame = document.frame(0).expect("a frame");
    let text = serde_json::json!({ "origami:sequence": { "version": 1, "steps": steps } }).to_string();
    let sequence = Sequence::from_slice(text.as_bytes()).expect("a sequence");
    let stages = sequence.stages(&frame, &pattern, &model).expect("stages");
    let mut steps = Steps::new(&model, &contact.relax, &State::at_rest(&model)).with_contact(contact.contact);
    for (number, stage) in stages.iter().enumerate() {
        steps.fold(stage, (number, 1), &mut |_| ControlFlow::Continue(())).expect("it folds");
    }
    let reached = steps.states().to_vec();
    for reached in &reached {
        assert!(Crossings::of(&model.mesh, &reached.folded.state.positions).is_empty(), "stage {}", reached.stage);
    }
    (model, reached)
}

/// Where a vertex of the file is.
fn place(model: &Model, state: &State, vertex: u32) -> DVec3 {
    state.positions[model.node(VertexId(vertex)).expect("a node").index()]
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
