//! What is said of patterns that cannot fold as they are asked to: by `info`, by `render` and after folding.

use serde_json::{Value, json};

use crate::place::Place;

const VERTEX5: &str = include_str!("../../../../tests/cases/vertex5_cannot_close.fold");
const LOOSE: &str = include_str!("../../../../tests/cases/loose_bar_noise_7gon_1.fold");
const SPUR: &str = include_str!("../../../../tests/cases/spur_valley.fold");

/// A square with one vertex inside and creases from there to its corners and the middle of a side: an odd number.
const ODD: &str = r#"{
"vertices_coords": [[0, 0], [4, 0], [4, 4], [0, 4], [2, 1.5], [2, 0]],
"edges_vertices": [[0, 5], [5, 1], [1, 2], [2, 3], [3, 0], [4, 0], [4, 1], [4, 2], [4, 3], [4, 5]],
"edges_assignment": ["B", "B", "B", "B", "B", "M", "M", "V", "V", "V"]
}"#;

#[test]
fn info_counts_the_faults_and_names_the_worst_places() {
    let place = Place::new();
    place.put("odd.fold", ODD);
    let ran = place.run("info odd.fold");
    let text = ran.succeeds();
    for expected in [
        "flat        1 inner vertex checked, 1 breaks a rule of flat folding",
        "fault       parity: vertex 4 (2, 1.5): 5 creases, an odd number, edges ",
    ] {
        assert!(text.contains(expected), "expected {expected:?} in {text}");
    }
    // Without the fifth crease it is Kawasaki's and Maekawa's rule: two right angles less than they should be.
    let even = ODD.replace(", [4, 5]]", "]").replace(r#""V", "V", "V"]"#, r#""V", "V"]"#);
    place.put("even.fold", &even);
    let facts: Value = serde_json::from_str(place.run("info even.fold --json").succeeds()).unwrap();
    let flat = &facts["flat"];
    assert_eq!((&flat["applies"], &flat["checked"], &flat["folded"]), (&json!(true), &json!(1), &json!(4)));
    let faults = flat["faults"].as_array().unwrap();
    let of = |rule: &str| faults.iter().find(|fault| fault["rule"] == rule).unwrap();
    let maekawa = of("maekawa");
    assert_eq!(
        (&maekawa["mountains"], &maekawa["valleys"], &maekawa["at"]),
        (&json!(2), &json!(2), &json!([2.0, 1.5]))
    );
    // The sectors below and above, seen from (2, 1.5), are twice atan(2 / 1.5) and twice atan(2 / 2.5).
    let off = 180.0 - 2.0 * ((2.0_f64 / 1.5).atan() + (2.0_f64 / 2.5).atan()).to_degrees();
    assert!((of("kawasaki")["off_deg"].as_f64().unwrap() - off.abs()).abs() < 1e-9, "{faults:?}");
    assert!(flat["closure"]["spread"].as_f64().unwrap() > 0.01);
    let text = place.run("info even.fold");
    assert!(text.succeeds().contains("the sheet misses itself by "), "{}", text.stdout);
}

#[test]
fn info_says_where_flat_folding_is_not_asked_for() {
    let place = Place::new();
    let ran = place.run("info square.fold");
    assert!(
        ran.succeeds().contains("flat        not asked for: no crease is asked to fold by 180 degrees"),
        "{}",
        ran.stdout
    );
    place.run("pattern miura -o m.fold").succeeds();
    let ran = place.run("info m.fold");
    let text = ran.succeeds();
    assert!(
        text.contains("all obey the rules of flat folding") && text.contains("face by face, the sheet closes\n"),
        "{text}"
    );
}

#[test]
fn a_crease_that_ends_inside_a_face_is_told_by_all() {
    let place = Place::new();
    place.put("spur.fold", SPUR);
    let ran = place.run("info spur.fold");
    assert!(
        ran.succeeds().contains("open end    edge 7 ends inside face 0 at vertex 6 (1, 1), 1.0 from edge "),
        "{}",
        ran.stdout
    );
    let ran = place.run("fold spur.fold -o a.fold --report r.json");
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    assert!(ran.stderr.contains("crease 0-6: ends inside face 0 at vertex 6"), "{}", ran.stderr);
    assert!(ran.stderr.contains("at rest it is 90.0 degrees off its angle"), "{}", ran.stderr);
    let warning = &place.json("r.json")["warnings"][0];
    assert_eq!((&warning["code"], &warning["at"]["creases"][0]["edge"]), (&json!("open-crease"), &json!(7)));
}

#[test]
fn a_crushed_triangle_is_named_and_more_steps_are_not_advised() {
    let place = Place::new();
    place.put("v.fold", VERTEX5);
    let ran = place.run("fold v.fold --collapse 0 -o a.fold");
    assert_eq!(ran.code, 0, "another way opens it: {}", ran.stderr);
    assert!(ran.stderr.contains("comes to rest strained"), "{}", ran.stderr);
    let solvers: &[&str] = if cfg!(feature = "newton") { &["relax", "newton"] } else { &["relax"] };
    for solver in solvers {
        let ran =
            place.run(&format!("fold v.fold --percent 90 --collapse 0 --solver {solver} -o a.fold --report r.json"));
        assert_eq!(ran.code, 3, "{solver}: {}", ran.stderr);
        assert!(ran.stderr.contains("triangle 0-1-5: crushed to a line"), "{solver}: {}", ran.stderr);
        assert!(!ran.stderr.contains("max-steps"), "{solver}: {}", ran.stderr);
        let warnings = place.json("r.json")["warnings"].clone();
        let crushed = warnings.as_array().unwrap().iter().find(|warning| warning["code"] == "crushed-triangle");
        assert_eq!(crushed.unwrap()["at"]["triangles"], json!([[0, 1, 5]]));
    }
    let ran = place.run("fold v.fold --percent 90 --collapse 0 -o a.fold --report r.json");
    assert_eq!((ran.code, &place.json("r.json")["stop"]), (3, &json!("crushed")));
    let ran = place.run("fold v.fold --percent 90 -o a.fold --report r.json");
    assert_eq!((ran.code, &place.json("r.json")["stop"]), (0, &json!("converged")), "kept open: {}", ran.stderr);
    assert!(ran.stderr.contains("triangle 0-1-5: less than a fifth of its area is left"), "{}", ran.stderr);
    assert!(place.json("r.json")["energy"]["areas"].as_f64().unwrap() > 0.0);
    let ran = place.run("sweep v.fold --percent 60,90 -o out");
    assert_eq!(ran.code, 0, "{}", ran.stderr);
}

#[test]
fn a_loose_line_keeps_nothing_from_coming_to_rest() {
    let place = Place::new();
    place.put("loose.fold", LOOSE);
    for options in ["", "--percent 0", "--tolerance 1e-2", "--solver dynamics", "--precision mixed"] {
        let ran = place.run(&format!("fold loose.fold -o a.fold --report r.json {options}"));
        assert_eq!(ran.code, 0, "{options}: {}", ran.stderr);
        assert!(ran.stderr.contains("edges_vertices[7]: belongs to no face"), "{options}: {}", ran.stderr);
        assert!(place.json("r.json")["steps"].as_u64().unwrap() < 200, "{options}: at once");
    }
}

#[cfg(feature = "render")]
#[test]
fn render_marks_faults_and_draws_lines_that_make_no_sheet() {
    let place = Place::new();
    place.put("odd.fold", ODD);
    place.run("render odd.fold -o a.svg -o a.png --quiet").succeeds();
    let svg = place.text("a.svg");
    assert!(svg.contains("<g id=\"rule\"") && svg.contains("1 vertex that breaks a rule of flat folding"), "{svg}");
    place.run("render odd.fold -o b.svg -o b.png --no-marks --quiet").succeeds();
    assert!(!place.text("b.svg").contains("<circle"));
    let png = |name: &str| std::fs::read(place.path(name)).unwrap();
    assert_ne!(png("a.png"), png("b.png"), "the picture has the marks too");

    // A face without corners enough.
    let bad = r#"{"vertices_coords": [[0, 0], [1, 0], [1, 1], [0, 1]],
        "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0]], "edges_assignment": ["B", "B", "B", "B"],
        "faces_vertices": [[0, 1, 2, 3], [0, 1]]}"#;
    place.put("bad.fold", bad);
    let ran = place.run("render bad.fold -o c.svg -o c.png");
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    assert!(ran.stderr.contains("faces_vertices[1]: has 2 different vertices"), "{}", ran.stderr);
    assert!(ran.stderr.contains("its lines are drawn as they are"), "{}", ran.stderr);
    let svg = place.text("c.svg");
    assert!(svg.contains("<g id=\"refusal\"") && svg.contains("No sheet can be made of this: "), "{svg}");
    place.run("render bad.fold -o c.glb").fails(1, "needs a sheet, .png and .svg show its lines");
    place.run("render bad.fold -o c.png --strain").fails(1, "has 2 different vertices");
    place.put("empty.fold", r#"{"vertices_coords": [[0, 0], [1, 0]]}"#);
    place.run("render empty.fold -o c.png").fails(1, "edges_vertices");
}
