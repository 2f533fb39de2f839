//! A session asked as a page would.

use super::*;
use crate::Processor;
use crate::message::MapWish as Map;
use crate::message::{ExportFormat, Own, SolverName, SolverWish};
use origami_core::fold::Document;
use origami_core::generate::catalog::{self, generate};
use origami_core::{CreasePattern, Material, Model, Relax, Solver};
use serde_json::Value;

fn session(pattern: &str) -> Session {
    let mut session = Session::new(Box::new(Processor));
    let answer = session.answer(Request::Generate { name: pattern.into(), parameters: Vec::new() }, &[]);
    assert_eq!(head(&answer[0])["is"], "opened");
    session
}

fn head(packet: &Packet) -> Value {
    serde_json::from_str(&packet.head).expect("a head is JSON")
}

/// Runs until nothing moves, taking every picture; the last of them, and how many there were.
fn settle(session: &mut Session) -> (Value, Vec<f32>, usize) {
    let (mut last, mut count) = (None, 0);
    for _ in 0..20_000 {
        session.answer(Request::Frame { map: Map::Strain }, &[]);
        session.advance(50);
        if let Some(frame) = session.take_frame() {
            count += 1;
            last = Some(frame);
        }
        if !session.has_work() {
            break;
        }
    }
    let last = last.expect("a picture");
    let numbers = last.body.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
    (head(&last), numbers, count)
}

fn error(packets: &[Packet]) -> String {
    let head = head(&packets[0]);
    assert_eq!(head["is"], "error", "{head}");
    head["text"].as_str().expect("a text").to_owned()
}

#[test]
fn folds_to_what_the_solver_folds_to() {
    let mut session = session("miura");
    session.answer(Request::Fold { percent: 60.0 }, &[]);
    let (head, numbers, frames) = settle(&mut session);
    assert!(head["settled"] == true && frames > 15, "{head} in {frames}");
    let model = Model::new(&generate("miura", &[]).expect("the default"), &Material::default()).expect("a sheet");
    let folded = Relax::default().fold_from_rest(&model, 60.0).expect("folds");
    let strain = origami_core::measure::Strain::of(&model, &folded.state.positions).beams;
    let seen = head["strain_max"].as_f64().expect("a number");
    assert!((seen - strain.max).abs() < 0.02 * strain.max, "{seen} {}", strain.max);
    let drawn: Vec<_> =
        numbers.chunks_exact(4).map(|n| DVec3::new(f64::from(n[0]), f64::from(n[1]), f64::from(n[2]))).collect();
    let apart = origami_core::measure::align(&drawn, &folded.state.positions).max;
    assert!(apart < 5e-4, "{apart}");
    // The test can fail: another percentage is another shape.
    let other = Relax::default().fold_from_rest(&model, 50.0).expect("folds").state;
    assert!(origami_core::measure::align(&drawn, &other.positions).max > 0.02);
}

#[test]
fn pictures_come_when_they_are_asked_for_and_never_else() {
    let mut session = session("miura");
    session.answer(Request::Fold { percent: 100.0 }, &[]);
    while session.has_work() {
        session.advance(1000);
        assert!(session.take_frame().is_none(), "nobody has asked");
    }
    // It waits to be seen: the ramp is not done.
    session.answer(Request::Frame { map: Map::None }, &[]);
    assert!(session.take_frame().is_some() && session.take_frame().is_none());
    assert!(session.has_work());
    let (_, _, frames) = settle(&mut session);
    assert!(frames > 20);
    session.answer(Request::Frame { map: Map::Strain }, &[]);
    assert!(session.take_frame().is_none(), "nothing has changed");
}

#[test]
fn what_was_just_asked_has_not_settled() {
    let mut session = session("square-twist");
    settle(&mut session);
    session.answer(Request::Fold { percent: 100.0 }, &[]);
    session.answer(Request::Frame { map: Map::None }, &[]);
    assert!(session.take_frame().is_none(), "it has not moved yet");
    session.advance(1);
    let frame = session.take_frame().expect("it has moved");
    assert_eq!(head(&frame)["settled"], false);
    // What does not run is seen at once.
    session.answer(Request::Run { on: false }, &[]);
    session.answer(Request::Frame { map: Map::None }, &[]);
    assert!(session.take_frame().is_some());
}

#[test]
fn a_crease_of_its_own_goes_its_own_way() {
    let mut session = session("degree-4");
    session.answer(Request::Fold { percent: 0.0 }, &[]);
    let own = Some(Own::Angle(40.0));
    let edge = (0..20).find(|edge| {
        let answer = session.answer(Request::Crease { edges: vec![*edge], own }, &[]);
        answer.is_empty()
    });
    let edge = edge.expect("a crease");
    settle(&mut session);
    let exported = session.answer(Request::Export { format: ExportFormat::Fold }, &[]);
    let document = Document::from_slice(&exported[0].body).expect("FOLD");
    let angles = document.key_frame.edges_fold_angle.expect("angles");
    let angle = angles[edge as usize].expect("an angle");
    assert!(angle > 15.0, "{angle}: springs of the other creases hold it back, but not all the way");
    session.answer(Request::Crease { edges: vec![edge], own: Some(Own::Free) }, &[]);
    session.answer(Request::Crease { edges: vec![edge], own: None }, &[]);
    let (head, ..) = settle(&mut session);
    assert!(head["strain_max"].as_f64().is_some_and(|strain| strain < 1e-4), "{head}");
}

#[test]
fn a_held_node_stays_where_the_hand_puts_it() {
    let mut session = session("miura");
    assert!(error(&session.answer(Request::Drag { node: 0, to: [0.0; 3] }, &[])).contains("grabbed"));
    session.answer(Request::Grab { node: 0 }, &[]);
    session.answer(Request::Drag { node: 0, to: [-0.5, -0.5, 0.4] }, &[]);
    let (_, numbers, _) = settle(&mut session);
    assert_eq!(&numbers[..3], &[-0.5, -0.5, 0.4]);
    session.answer(Request::Release { node: 0 }, &[]);
    let (head, ..) = settle(&mut session);
    assert!(head["settled"] == true);
}

#[test]
fn back_is_where_it_was() {
    let mut session = session("bird-base");
    session.answer(Request::Fold { percent: 40.0 }, &[]);
    let (_, before, _) = settle(&mut session);
    session.answer(Request::Mark, &[]);
    session.answer(Request::Fold { percent: 90.0 }, &[]);
    session.answer(Request::Material(Material { k_fold: 1.0, ..Material::default() }), &[]);
    settle(&mut session);
    let answer = session.answer(Request::Undo, &[]);
    let told = head(&answer[0]);
    assert_eq!((&told["wishes"]["percent"], &told["can_redo"]), (&40.0.into(), &true.into()), "{told}");
    session.answer(Request::Run { on: false }, &[]);
    session.answer(Request::Frame { map: Map::Strain }, &[]);
    let frame = session.take_frame().expect("it has moved");
    let positions = |numbers: &[f32]| numbers.chunks_exact(4).flat_map(|n| n[..3].to_vec()).collect::<Vec<f32>>();
    let now: Vec<f32> = frame.body.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
    assert_eq!(positions(&now), positions(&before));
}

#[test]
fn a_saved_session_goes_on_elsewhere() {
    let mut one = session("kresling");
    one.answer(Request::Fold { percent: 30.0 }, &[]);
    one.answer(Request::Grab { node: 2 }, &[]);
    let (_, before, _) = settle(&mut one);
    let saved = one.answer(Request::Save, &[]);
    let mut other = Session::new(Box::new(Processor));
    let opened = other.answer(Request::Restore, &saved[0].body);
    assert_eq!(head(&opened[0])["wishes"]["percent"], 30.0);
    let (_, after, _) = settle(&mut other);
    let apart = before.iter().zip(&after).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(apart < 1e-3, "{apart}");
    for cut in [0, 1, saved[0].body.len() / 2] {
        assert!(error(&other.answer(Request::Restore, &saved[0].body[..cut])).contains("session"));
    }
}

#[test]
fn wrong_files_get_the_error_of_the_library() {
    let mut session = Session::new(Box::new(Processor));
    let text = error(&session.answer(Request::Open { name: "odd.fold".into() }, b"{\"vertices_coords\": 3}"));
    let expected = Document::from_slice(b"{\"vertices_coords\": 3}").expect_err("no list");
    assert_eq!(text, format!("odd.fold: {expected}"));
    assert!(error(&session.answer(Request::Fold { percent: 1.0 }, &[])).contains("no pattern"));
}

#[test]
fn numbers_that_make_no_sense_change_nothing() {
    let mut session = session("miura");
    for request in [
        Request::Fold { percent: f64::NAN },
        Request::Crease { edges: vec![1_000_000], own: Some(Own::Free) },
        Request::Crease { edges: vec![5], own: Some(Own::Angle(f64::INFINITY)) },
        Request::Grab { node: u32::MAX },
        Request::Release { node: 9999 },
        Request::Material(Material { ea: -1.0, ..Material::default() }),
        Request::Solver(SolverWish { tolerance: 0.0, ..SolverWish::default() }),
    ] {
        let answer = session.answer(request.clone(), &[]);
        assert!(!answer.is_empty() && !error(&answer).is_empty(), "{request:?}");
    }
    session.answer(Request::Grab { node: 3 }, &[]);
    assert!(!error(&session.answer(Request::Drag { node: 3, to: [f64::NAN, 0.0, 0.0] }, &[])).is_empty());
    session.answer(Request::Release { node: 3 }, &[]);
    let (head, ..) = settle(&mut session);
    assert!(head["settled"] == true && head["strain_max"].as_f64().is_some_and(|strain| strain < 1e-6), "{head}");
}

#[test]
fn dynamics_comes_to_rest_too() {
    let mut session = session("single-crease");
    session.answer(Request::Solver(SolverWish { name: SolverName::Dynamics, ..SolverWish::default() }), &[]);
    session.answer(Request::Fold { percent: 50.0 }, &[]);
    let (head, ..) = settle(&mut session);
    assert!(head["settled"] == true && head["angle_error_max"].as_f64().is_some_and(|error| error < 1.0), "{head}");
}

#[test]
fn what_a_page_says_is_read_and_what_it_should_not_say_refused() {
    let read = |text: &str| serde_json::from_str::<Request>(text);
    assert_eq!(read(r#"{"do":"fold","percent":60}"#).ok(), Some(Request::Fold { percent: 60.0 }));
    let crease = Request::Crease { edges: vec![3], own: Some(Own::Angle(-90.0)) };
    assert_eq!(read(r#"{"do":"crease","edges":[3],"own":{"angle":-90}}"#).ok(), Some(crease));
    assert_eq!(read(r#"{"do":"crease","edges":[3],"own":"free"}"#).map(|_| ()).map_err(|e| e.to_string()), Ok(()));
    for wrong in [r#"{"do":"explode"}"#, r#"{"do":"fold"}"#, "[]", r#"{"do":"fold","percent":"1"}"#] {
        assert!(read(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn every_generator_opens_and_is_exported() {
    for entry in catalog::entries() {
        let mut session = session(entry.name);
        for format in [ExportFormat::Fold, ExportFormat::Obj, ExportFormat::Stl] {
            let file = session.answer(Request::Export { format }, &[]);
            assert!(head(&file[0])["name"].as_str().is_some_and(|name| name.starts_with(entry.name)), "{}", entry.name);
        }
        let fold = session.answer(Request::Export { format: ExportFormat::Fold }, &[]);
        let document = Document::from_slice(&fold[0].body).expect("FOLD");
        CreasePattern::from_document(&document, 0).expect("a pattern");
    }
}
