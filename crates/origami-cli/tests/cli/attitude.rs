//! `--hold`: how results lie.

use serde_json::{Value, json};

use crate::place::Place;

/// Of the key frame, or of the last one of an animation.
fn vertices(place: &Place, file: &str) -> Vec<[f64; 3]> {
    let document = place.json(file);
    let frames = document["file_frames"].as_array().and_then(|frames| frames.last());
    let coords = frames.unwrap_or(&document)["vertices_coords"].clone();
    serde_json::from_value(coords).unwrap()
}

fn apart(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let distance = |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt();
    a.iter().zip(b).map(|(a, b)| distance(a, b)).fold(0.0, f64::max)
}

/// Both of its faces lean alike; the middle stays.
#[test]
fn a_square_folded_by_its_diagonal_leans_to_both_sides() {
    let place = Place::new();
    place.run("fold square.fold -o a.fold --report a.json").fails(0, "");
    let [a, b, c, d] = vertices(&place, "a.fold")[..] else { panic!("four vertices") };
    let half = 45.0_f64.to_radians();
    let expected = |x: f64, y: f64, height: f64| [x, y, height * 0.5_f64.sqrt() * half.sin()];
    let reach = 0.5 - 0.5 * half.cos();
    let all = [
        expected(0.0, 0.0, -1.0 / 3.0),
        expected(1.0 - reach, reach, 2.0 / 3.0),
        expected(1.0, 1.0, -1.0 / 3.0),
        expected(reach, 1.0 - reach, 2.0 / 3.0),
    ];
    assert!(apart(&[a, b, c, d], &all) < 1e-3, "{:?} for {all:?}", [a, b, c, d]);
    assert_eq!(place.json("a.json")["attitude"], "sheet");
}

#[test]
fn a_face_that_is_named_stays_and_one_that_is_not_there_is_refused() {
    let place = Place::new();
    place.run("fold square.fold -o a.fold --hold 1 --report a.json").fails(0, "");
    let held = vertices(&place, "a.fold");
    let before = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    assert!(apart(&[held[0], held[2], held[3]], &before) < 1e-3, "{held:?}");
    // A quarter turn about the diagonal.
    assert!(apart(&[held[1]], &[[0.5, 0.5, 0.5_f64.sqrt()]]) < 1e-3, "{held:?}");
    assert_eq!(place.json("a.json")["attitude"], "face 1");
    place.run("fold square.fold -o b.fold --hold 2").fails(1, "there is no face 2; expected 0 to 1");
    place.run("sweep square.fold -o s --hold 2").fails(1, "there is no face 2; expected 0 to 1");
    assert!(!place.has("b.fold") && !place.has("s"));
    place.run("fold square.fold -o b.fold --hold paper").fails(1, "expected `sheet`, `none` or the number of a face");
}

#[test]
fn stages_sweeps_and_single_results_lie_alike() {
    let place = Place::new();
    for hold in ["sheet", "0"] {
        place.run(&format!("fold square.fold -o one.fold -o one.obj --hold {hold}")).fails(0, "");
        place.run(&format!("fold square.fold -o many.fold --frames 5 --hold {hold}")).fails(0, "");
        place.run(&format!("sweep square.fold -o s --folded fold --hold {hold}")).fails(0, "");
        let one = vertices(&place, "one.fold");
        for other in ["many.fold", "s/0000.fold"] {
            assert!(apart(&one, &vertices(&place, other)) < 1e-3, "{hold}: {other}");
        }
        let line = |line: &str| line.strip_prefix("v ").map(|rest| format!("[{}]", rest.replace(' ', ",")));
        let obj: Vec<[f64; 3]> =
            place.text("one.obj").lines().filter_map(line).map(|v| serde_json::from_str(&v).unwrap()).collect();
        assert_eq!(one, obj);
    }
    assert_eq!(place.json("s/sweep.json")["attitude"], "face 0");
}

#[test]
fn fixed_vertices_hold_the_sheet() {
    let place = Place::new();
    let mut square: Value = place.json("square.fold");
    square["vertices_origami:fixed"] = json!([true, false, true, true]);
    place.put("fixed.fold", &square.to_string());
    place.run("fold fixed.fold -o a.fold --report a.json").fails(0, "");
    let held = vertices(&place, "a.fold");
    assert_eq!([held[0], held[2], held[3]], [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
    assert_eq!(place.json("a.json")["attitude"], "fixed vertices");
}
