//! `origami info`.

use serde_json::{Value, json};

use crate::place::{Place, SQUARE};

#[test]
fn tells_what_is_in_a_file() {
    let place = Place::new();
    let ran = place.run("info square.fold");
    let text = ran.succeeds();
    for expected in [
        "FOLD 1.2, 1 frame",
        "as written  4 vertices, 5 edges (B 4, V 1), 2 faces",
        "sheet       flat, longest side 1",
        "model       4 vertices, 5 beams, 1 crease, 2 triangles",
        "left out    fixed vertices: the pattern has none",
        "time step   paper ",
    ] {
        assert!(text.contains(expected), "expected {expected:?} in {text}");
    }
}

#[test]
fn tells_it_as_json() {
    let place = Place::new();
    place.put("odd.fold", &SQUARE.replace("\"V\"", "\"v\"").replace("[0, 1]]", "[0, 1, 0.5]]"));
    let facts: Value = serde_json::from_str(place.run("info odd.fold --json --k-face 0").succeeds()).unwrap();
    assert_eq!(facts["file"]["letters"], json!({"B": 4, "v": 1}));
    assert_eq!(facts["pattern"]["letters"], json!({"B": 4, "V": 1}));
    assert_eq!(facts["pattern"]["flat"], json!(false));
    let places: Vec<_> = facts["warnings"].as_array().unwrap().iter().map(|warning| &warning["place"]).collect();
    assert_eq!(places, [&json!("vertices_coords[3]"), &json!("edges_assignment[4]")]);
    assert_eq!(facts["model"]["left_out"][0], json!({"what": "corner angles", "count": 6, "why": "k_face is 0"}));
    let steps = &facts["model"]["time_step"];
    assert!(steps["paper"].as_f64().unwrap() > 0.0 && steps["safe"].as_f64().unwrap() > 0.0);
}

#[test]
fn tells_as_much_as_it_can_of_a_bad_file() {
    let place = Place::new();
    place.put("bad.fold", &SQUARE.replace("[0, 2]]", "[0, 9]]"));
    let ran = place.run("info bad.fold");
    ran.fails(1, "error: bad.fold: edges_vertices[4]: vertex 9");
    assert!(ran.stdout.contains("as written  4 vertices, 5 edges"), "{}", ran.stdout);
    let ran = place.run("info bad.fold --json");
    ran.fails(1, "edges_vertices[4]");
    let facts: Value = serde_json::from_str(&ran.stdout).unwrap();
    assert!(facts["error"].as_str().unwrap().contains("edges_vertices[4]"));
    assert_eq!((&facts["file"]["edges"], facts.get("model")), (&json!(5), None));
}

#[test]
fn text_from_the_file_cannot_steer_the_terminal() {
    let place = Place::new();
    place.put("odd.fold", &SQUARE.replace("\"file_spec\": 1.2", r#""file_spec": 1.2, "file_title": "a\u001b[31mb""#));
    assert!(place.run("info odd.fold").succeeds().contains("title       a\\u{1b}[31mb"));
}
