//! `origami convert`.
#![cfg(feature = "formats")]

use serde_json::Value;

use crate::place::Place;

#[test]
fn a_pattern_goes_round_through_all_formats() {
    let place = Place::new();
    place.run("pattern miura -o miura.fold").succeeds();
    let line = place.run("convert miura.fold -o a.cp -o a.svg -o a.dxf -o a.fold");
    assert!(
        line.succeeds().starts_with("miura.fold: 220 edges written as a.cp, a.svg, a.dxf, a.fold, "),
        "{}",
        line.stdout
    );
    let edges = |file: &str| place.json(file)["edges_vertices"].as_array().unwrap().len();
    for file in ["a.cp", "a.svg", "a.dxf", "a.fold"] {
        let ran = place.run(&format!("convert {file} -o b.fold"));
        assert_eq!(ran.code, 0, "{file}: {}", ran.stderr);
        assert_eq!(edges("b.fold"), edges("miura.fold"), "{file}");
    }
    // What was there besides the pattern stays.
    assert_eq!(place.json("a.fold")["frame_title"], place.json("miura.fold")["frame_title"]);
    assert_eq!(place.json("a.fold")["frame_classes"], serde_json::json!(["creasePattern"]));
}

#[test]
fn angles_that_cp_cannot_hold_are_counted() {
    let place = Place::new();
    let ran = place.run("convert square.fold -o a.cp");
    ran.fails(0, "warning: CP: 1 line loses its fold angle");
    assert_eq!(place.text("a.cp"), "1 0 0 1 0\n1 1 0 1 1\n1 1 1 0 1\n1 0 1 0 0\n3 0 0 1 1\n");
    place.run("convert square.fold -o a.svg").succeeds();
    assert!(place.text("a.svg").contains("stroke-opacity=\"0.5\""));
    place.run("convert a.svg -o b.fold --quiet").succeeds();
    let angles: Vec<Value> = serde_json::from_value(place.json("b.fold")["edges_foldAngle"].clone()).unwrap();
    assert_eq!(angles.iter().filter(|angle| **angle == 90.0).count(), 1, "{angles:?}");
}

#[test]
fn plotters_get_whole_lines_of_a_real_length() {
    let place = Place::new();
    place.run("pattern miura -o miura.fold").succeeds();
    let lines = |words: &str| {
        place.run(&format!("convert miura.fold -o a.svg {words}")).succeeds();
        place.text("a.svg").matches("<line").count()
    };
    assert_eq!(lines("--lines pieces"), 220);
    assert!(lines("") < 210, "two sides of the sheet are straight, in pieces");
    lines("--width 20cm");
    assert!(place.text("a.svg").contains("cm\" height=\""));
}

#[test]
fn what_cannot_be_done_is_refused_before_anything_is_written() {
    let place = Place::new();
    for (words, problem) in [
        ("-o a.obj", "patterns are not written as .obj, `origami fold` does; expected .fold, .cp, .svg or .dxf"),
        ("-o a.opx", "patterns are not written as .opx; expected .fold"),
        ("-o a", "no extension tells the format"),
        ("-o a.cp -o ./a.cp", "named twice"),
        ("-o square.fold", "would be replaced"),
        ("-o new/a.cp", "there is no folder new"),
        ("-o a.svg --width 3", "is no length on paper; expected a number above 0 with mm, cm or in"),
        ("-o a.svg --straight 2", "expected a number from 0 to 1"),
    ] {
        place.run(&format!("convert square.fold {words}")).fails(1, problem);
        assert_eq!(place.names(), ["square.fold"]);
    }
    place.put("bent.fold", &place.text("square.fold").replace("[1, 0]", "[1, 0, 1]"));
    place.run("convert bent.fold -o a.cp").fails(1, "the sheet is not flat, and this format holds flat patterns only");
    assert!(!place.has("a.cp"));
}

#[test]
fn standard_output_takes_fold() {
    let place = Place::new();
    let ran = place.run_with("convert - -o -", "1 0 0 1 0\n1 1 0 1 1\n1 1 1 0 1\n1 0 1 0 0\n3 0 0 1 1\n");
    let document: Value = serde_json::from_str(&ran.stdout).unwrap();
    assert_eq!(document["faces_vertices"].as_array().unwrap().len(), 2);
}
