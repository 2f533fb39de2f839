//! A session asked as a page would.

use super::*;
use crate::Processor;
use crate::message::MapWish as Map;
use crate::message::{ExportFormat, Own, SolverName, SolverWish, Way};
use origami_core::fold::Document;
use origami_core::generate::catalog::{self, generate};
use origami_core::glam::DVec3;
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

const LETTER: &[u8] = include_bytes!("../../../../examples/sequences/letter-fold.fold");

fn opened(bytes: &[u8]) -> (Session, Value) {
    let mut session = Session::new(Box::new(Processor));
    let answer = session.answer(Request::Open { name: "letter.fold".into() }, bytes);
    let told = head(&answer[0]);
    (session, told)
}

/// Folds all that is recorded; the last picture's head and numbers.
fn recorded(session: &mut Session, way: Way, contact: bool, parts: u32) -> (Value, Vec<f32>) {
    let answer = session.answer(Request::Record { way, contact, parts }, &[]);
    assert!(answer.is_empty(), "{}", answer[0].head);
    let (head, numbers, _) = settle(session);
    (head, numbers)
}

fn places(numbers: &[f32]) -> Vec<DVec3> {
    numbers.chunks_exact(4).map(|n| DVec3::new(f64::from(n[0]), f64::from(n[1]), f64::from(n[2]))).collect()
}

/// The largest distance between nodes of two states, where they are.
fn apart(one: &[DVec3], other: &[DVec3]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

#[test]
fn steps_of_a_file_are_those_of_the_library() {
    let (mut session, told) = opened(LETTER);
    assert_eq!(told["steps"], serde_json::json!(["left third over", "right third over it"]), "{told}");
    let (head, numbers) = recorded(&mut session, Way::Steps, false, 4);
    assert_eq!((&head["recorded"]["states"], &head["recorded"]["of"]), (&9.into(), &9.into()), "{head}");
    assert_eq!(head["recorded"]["label"], "right third over it");

    let document = Document::from_slice(LETTER).expect("FOLD");
    let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a sheet");
    let frame = document.frame(0).expect("the first");
    let sequence = origami_core::sequence::Sequence::in_frame(&frame).expect("right").expect("one");
    let stages = sequence.stages(&frame, &pattern, &model).expect("right");
    let rest = origami_core::State::at_rest(&model);
    let relax = Relax::default();
    let states = origami_core::solve::fold_sequence(&model, (&relax, None), &rest, (&stages, 4), &mut |_, _| {
        std::ops::ControlFlow::Continue(())
    });
    let states = states.expect("folds");
    let end = &states.last().expect("the end").folded.state.positions;
    assert!(apart(&places(&numbers), end) < 1e-6);

    // Between two states vertices go straight; the test can fail, as the states are elsewhere.
    session.answer(Request::Show { at: 4.5 }, &[]);
    session.answer(Request::Frame { map: Map::Strain }, &[]);
    let frame = session.take_frame().expect("another state");
    let numbers: Vec<f32> = frame.body.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
    let [a, b] = [3, 4].map(|i| &states[i].folded.state.positions);
    let middle: Vec<DVec3> = a.iter().zip(b).map(|(a, b)| a.midpoint(*b)).collect();
    assert!(apart(&places(&numbers), &middle) < 1e-6 && apart(a, &middle) > 0.01);

    let film = session.answer(Request::Film, &[]);
    let told = self::head(&film[0]);
    assert_eq!((&told["is"], &told["name"]), (&"file".into(), &"letter.html".into()));
    let page = std::str::from_utf8(&film[0].body).expect("text");
    assert!(page.contains("data-engine=\"film\"") && page.ends_with("</html>\n"), "{}", page.len());
    let saved = session.answer(Request::Export { format: ExportFormat::Fold }, &[]);
    let text = String::from_utf8(saved[0].body.clone()).expect("text");
    assert!(text.contains("\"origami:step\": \"right third over it\""), "{text}");

    session.answer(Request::Fold { percent: 0.0 }, &[]);
    assert!(settle(&mut session).0["recorded"].is_null(), "a hand on the sheet ends it");
    assert!(!error(&session.answer(Request::Show { at: 1.0 }, &[])).is_empty());
}

#[test]
fn a_way_to_a_percentage_ends_where_the_command_line_does() {
    let mut session = session("miura");
    session.answer(Request::Fold { percent: 60.0 }, &[]);
    let (head, numbers) = recorded(&mut session, Way::Percent(60.0), false, 6);
    assert_eq!((&head["percent"], &head["recorded"]["label"]), (&60.0.into(), &"60 %".into()), "{head}");
    let model = Model::new(&generate("miura", &[]).expect("the default"), &Material::default()).expect("a sheet");
    let percents = [10.0, 20.0, 30.0, 40.0, 50.0, 60.0];
    let states = origami_core::solve::fold_path(&model, &Relax::default(), &percents, &mut |_, _| {
        std::ops::ControlFlow::Continue(())
    });
    let states = states.expect("folds");
    assert!(apart(&places(&numbers), &states[5].state.positions) < 1e-4);
    assert!(apart(&places(&numbers), &states[4].state.positions) > 0.01);
    for parts in [0, 1001] {
        let request = Request::Record { way: Way::Percent(60.0), contact: false, parts };
        assert!(error(&session.answer(request, &[])).contains("parts"), "{parts}");
    }
    assert!(error(&session.answer(Request::Show { at: f64::NAN }, &[])).contains("number"));
}

#[test]
fn what_contact_holds_up_says_so_and_does_not_cross() {
    let (mut session, _) = opened(LETTER);
    // Both flaps at once lie on each other.
    let (head, _) = recorded(&mut session, Way::Percent(100.0), true, 5);
    let ended = head["recorded"]["ended"].as_str().unwrap_or_default();
    assert!(ended.contains("press on each other") && ended.contains("edge"), "{head}");
    assert_eq!(head["crossings"]["count"], 0, "{head}");
    // One after the other they close.
    let (head, _) = recorded(&mut session, Way::Steps, true, 1);
    assert!(head["recorded"]["ended"].is_null() && head["crossings"]["count"] == 0, "{head}");
    assert!(head["angle_error_max"].as_f64().is_some_and(|error| error < 3.0), "{head}");
}

#[test]
fn crossings_are_those_of_the_exact_test() {
    let mut session = session("crane");
    session.answer(Request::Fold { percent: 60.0 }, &[]);
    let (head, numbers, _) = settle(&mut session);
    let model = Model::new(&generate("crane", &[]).expect("the default"), &Material::default()).expect("a sheet");
    let exact = origami_core::contact::Crossings::of(&model.mesh, &places(&numbers));
    let told = head["crossings"]["count"].as_u64().expect("it has settled");
    // Pictures have 32 bits: what barely touches may differ.
    assert!(told > 0 && told.abs_diff(exact.all.len() as u64) <= 2, "{told} {}", exact.all.len());
    let pairs: Vec<[u32; 2]> = serde_json::from_value(head["crossings"]["faces"].clone()).expect("pairs");
    let faces = generate("crane", &[]).expect("the default").faces.len();
    assert!(!pairs.is_empty() && pairs.iter().flatten().all(|face| (*face as usize) < faces), "{pairs:?}");
    // Half-open it goes through nothing.
    session.answer(Request::Reset, &[]);
    assert_eq!(settle(&mut session).0["crossings"]["count"], 0);
}

#[test]
fn a_sequence_that_is_wrong_is_warned_of_and_the_pattern_opens() {
    let wrong = String::from_utf8(LETTER.to_vec()).expect("text").replace("[8]", "[0]");
    let (mut session, told) = opened(wrong.as_bytes());
    assert_eq!((&told["is"], &told["steps"]), (&"opened".into(), &serde_json::json!([])));
    let texts: Vec<&str> =
        told["warnings"].as_array().expect("a list").iter().filter_map(|w| w["text"].as_str()).collect();
    assert!(texts.iter().any(|text| text.contains("left third over") && text.contains("edge 0")), "{texts:?}");
    let request = Request::Record { way: Way::Steps, contact: false, parts: 1 };
    assert!(error(&session.answer(request, &[])).contains("origami:sequence"));
}
