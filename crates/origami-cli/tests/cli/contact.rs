//! `--check`: paper that goes through paper.

use serde_json::{Value, json};

use crate::place::Place;

/// Two triangles that share a corner, one through the other, and a frame in which they do not cross.
const CROSSED: &str = r#"{"file_spec": 1.2,
    "vertices_coords": [[0,0,0], [1,-1,0], [1,1,0], [0.5,0,-0.5], [0.5,0,0.5]],
    "edges_vertices": [[0,1], [1,2], [2,0], [0,3], [3,4], [4,0]], "edges_assignment": ["B","B","B","B","B","B"],
    "faces_vertices": [[0,1,2], [0,3,4]],
    "file_frames": [
        {"frame_parent": 0, "frame_inherit": true, "vertices_coords": [[0,0,0], [1,-1,0], [1,1,0], [-1,0,-1], [-1,0,1]]},
        {"frame_parent": 0, "frame_inherit": true, "vertices_coords": [[0,0,0], [1,-1,0], [1,1,0]]}]}"#;

#[test]
fn info_tells_which_frames_cross() {
    let place = Place::new();
    place.put("crossed.fold", CROSSED);
    let text = place.run("info crossed.fold --check").succeeds().to_owned();
    assert!(text.contains("crossings   frame 0: 1 crossing of 1 pair of faces (0 with 1), the deepest 0."), "{text}");
    assert!(text.contains("crossings   frame 1: no crossing"), "{text}");
    assert!(text.contains("crossings   frame 2 not tested: the pattern was read with"), "{text}");
    assert!(!place.run("info crossed.fold").succeeds().contains("crossings"), "only where it is asked for");
    let facts: Value = serde_json::from_str(place.run("info crossed.fold --check --json").succeeds()).unwrap();
    assert_eq!(facts["check"][0]["crossings"]["faces"], json!([[0, 1]]));
    assert_eq!(facts["check"][1]["crossings"], json!({"count": 0, "deepest": 0.0, "pairs": 0, "faces": []}));
    assert_eq!((&facts["check"][2]["crossings"], &facts["check"][2]["frame"]), (&Value::Null, &json!(2)));
}

#[test]
fn fold_tells_it_of_every_state() {
    let place = Place::new();
    place.put("crossed.fold", CROSSED);
    let line = place.run("fold crossed.fold --percent 0 --check --report r.json").succeeds().to_owned();
    assert!(line.contains(", 1 crossing of 1 pair of faces (0 with 1), the deepest 0."), "{line}");
    let report = place.json("r.json");
    assert_eq!((&report["crossings"]["count"], &report["crossings"]["pairs"]), (&json!(1), &json!(1)));
    let line = place.run("fold square.fold --frames 2 --check --report r.json").succeeds().to_owned();
    assert!(line.contains(", no crossing"), "{line}");
    assert!(
        place.json("r.json")["frames"].as_array().unwrap().iter().all(|frame| frame["crossings"]["count"] == json!(0))
    );
    place.run("fold square.fold --report r.json").succeeds();
    assert_eq!(place.json("r.json").get("crossings"), None, "only where it is asked for");
}

/// A strip of three panels with a sequence of its own.
const LETTER: &str = r#"{"file_spec": 1.2, "vertices_coords": [[0,0],[1,0],[2,0],[3,0],[3,2],[2,2],[1,2],[0,2]],
    "edges_vertices": [[0,1],[1,2],[2,3],[3,4],[4,5],[5,6],[6,7],[7,0],[1,6],[2,5]],
    "edges_assignment": ["B","B","B","B","B","B","B","B","V","V"],
    "edges_foldAngle": [null,null,null,null,null,null,null,null,180,180],
    "faces_vertices": [[0,1,6,7],[1,2,5,6],[2,3,4,5]],
    "origami:sequence": {"version": 1, "steps": [
        {"name": "left", "creases": {"edges": [8]}, "to": 70}, {"name": "right", "creases": {"edges": [9]}, "to": 50}]}}"#;

#[test]
fn a_sequence_is_folded_step_by_step_and_read_back() {
    let place = Place::new();
    place.put("letter.fold", LETTER);
    let line = place.run("fold letter.fold --sequence own -o a.fold --report r.json").succeeds().to_owned();
    assert!(line.starts_with("letter.fold: folded to the end of `right` in 2 frames in "), "{line}");
    let (written, report) = (place.json("a.fold"), place.json("r.json"));
    let angle = |document: &Value, frame: usize, edge: usize| {
        document["file_frames"][frame]["edges_foldAngle"][edge].as_f64().unwrap()
    };
    for (frame, title, angles) in [(0, "left", [70.0, 0.0]), (1, "right", [70.0, 50.0])] {
        assert_eq!(written["file_frames"][frame]["frame_title"], title);
        assert_eq!(
            (&written["file_frames"][frame]["origami:step"], &report["frames"][frame]["step"]),
            (&json!(title), &json!(title))
        );
        assert!(
            (angle(&written, frame, 8) - angles[0]).abs() < 0.01
                && (angle(&written, frame, 9) - angles[1]).abs() < 0.01
        );
    }
    assert_eq!(report["percent"], Value::Null);
    place.run("fold a.fold --sequence frames -o b.fold --quiet").succeeds();
    assert!((angle(&place.json("b.fold"), 1, 9) - 50.0).abs() < 0.02);
    place.put("steps.json", r#"{"version": 1, "steps": [{"creases": {"all": true}, "to": {"percent": 10}}]}"#);
    place.run("fold letter.fold --sequence steps.json --frames 2 -o c.fold --quiet").succeeds();
    assert_eq!(place.json("c.fold")["file_frames"][1]["frame_title"], "step 1, 2/2");
}

#[test]
fn a_sequence_that_cannot_be_is_refused_with_its_place() {
    let place = Place::new();
    place.put("letter.fold", LETTER);
    place.put("steps.json", r#"{"version": 1, "steps": [{"creases": {"edges": [77]}, "to": 9}]}"#);
    let none = place.run("fold square.fold --sequence own -o a.fold");
    none.fails(1, "--sequence own: the file has no sequence");
    place
        .run("fold letter.fold --sequence steps.json -o a.fold")
        .fails(1, "steps.json: origami:sequence.steps[0]: there is no edge 77");
    place.run("fold letter.fold --sequence own --solver dynamics -o a.fold").fails(1, "--solver dynamics");
    place.run("fold letter.fold --sequence own --backend gpu -o a.fold").fails(1, "--backend gpu");
    place.run("fold letter.fold --sequence none.json -o a.fold").fails(1, "none.json");
}

#[test]
fn a_letter_is_blocked_at_once_and_closes_in_order() {
    let place = Place::new();
    place.put("letter.fold", include_str!("../../../../examples/sequences/letter-fold.fold"));
    let ran = place.run("fold letter.fold --contact -o a.fold --report r.json");
    ran.fails(3, "letter.fold: blocked at 100 % after ");
    assert!(ran.stderr.contains("faces 0 and 2 press hardest"), "{}", ran.stderr);
    assert_eq!(place.json("a.fold")["origami:blocked"], json!(true));
    let report = place.json("r.json");
    assert_eq!((&report["stop"], &report["contact"]["blocked"]), (&json!("blocked"), &json!(true)));
    assert_eq!(
        (&report["contact"]["pressing"][0]["faces"], &report["crossings"]["count"]),
        (&json!([0, 2]), &json!(0))
    );
    let first = report["contact"]["first_percent"].as_f64().unwrap();
    assert!(first > 50.0 && first < 100.0, "{first}");
    place.run("fold letter.fold --contact --sequence own -o b.fold --report r.json --quiet").succeeds();
    let report = place.json("r.json");
    assert_eq!((&report["contact"]["blocked"], &report["crossings"]["count"]), (&json!(false), &json!(0)));
    assert_eq!(place.json("b.fold")["file_frames"][1].get("origami:blocked"), None);
    place
        .run("fold letter.fold --contact --solver reflect -o d.fold")
        .fails(1, "--solver reflect: it has no --contact");
    let sequence = "fold letter.fold --contact --sequence own --solver newton -o d.fold";
    place.run(sequence).fails(1, "--solver newton: it has no --sequence; expected relax");
    place.run("fold letter.fold --contact --precision mixed -o d.fold").fails(1, "--precision mixed");
}

#[test]
fn a_motion_is_found_backwards_and_ends_exactly_flat() {
    let place = Place::new();
    place.run("pattern bird-base -o bird.fold").succeeds();
    let line =
        place.run("fold bird.fold --backwards --frames 2 --check -o film.fold --report r.json").succeeds().to_owned();
    assert!(line.contains(", no crossing") && !line.contains("other way round"), "{line}");
    let (film, report) = (place.json("film.fold"), place.json("r.json"));
    let frames = film["file_frames"].as_array().unwrap();
    let told = report["frames"].as_array().unwrap();
    assert!(frames.len() > 4 && frames.len() == told.len(), "{} frames, {} told", frames.len(), told.len());
    assert!(told.iter().all(|frame| frame["crossings"]["count"] == json!(0)));
    // All vertices of the last frame lie in one plane, and each crease is folded by half a turn.
    let last = &frames[frames.len() - 1];
    let coords: Vec<[f64; 3]> = serde_json::from_value(last["vertices_coords"].clone()).unwrap();
    let minus = |p: [f64; 3]| [0, 1, 2].map(|k| p[k] - coords[0][k]);
    let cross = |[a, b, c]: [f64; 3], [d, e, f]: [f64; 3]| [b * f - c * e, c * d - a * f, a * e - b * d];
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let crosses = coords.iter().flat_map(|p| coords.iter().map(|q| cross(minus(*p), minus(*q))));
    let normal = crosses.max_by(|n, m| dot(*n, *n).total_cmp(&dot(*m, *m))).unwrap();
    let off = |p: &[f64; 3]| dot(minus(*p), normal).abs() / dot(normal, normal).sqrt();
    assert!(dot(normal, normal) > 0.01 && coords.iter().all(|p| off(p) < 1e-9), "{coords:?}");
    let angles: Vec<Option<f64>> = serde_json::from_value(last["edges_foldAngle"].clone()).unwrap();
    let creases: Vec<f64> = angles.into_iter().flatten().filter(|angle| angle.abs() > 1.0).collect();
    assert!(creases.len() > 8 && creases.iter().all(|angle| (angle.abs() - 180.0).abs() < 1e-6), "{creases:?}");
    let orders = last["faceOrders"].as_array().unwrap();
    let backwards = &report["backwards"];
    assert_eq!((&backwards["pairs"], &backwards["free"]), (&json!(orders.len()), &json!([])));
    assert!(orders.len() > 10 && orders.iter().all(|order| order[2] != json!(0)), "{orders:?}");
    assert!(backwards["off_deg"].as_f64().unwrap() < 1.0, "{backwards}");
    assert!(backwards["touching"].as_u64().unwrap() < frames.len() as u64, "{backwards}");
}

#[test]
fn what_has_no_flat_state_is_not_folded_backwards() {
    let place = Place::new();
    place.run("pattern hypar -o hypar.fold").succeeds();
    place.run("fold hypar.fold --backwards -o a.fold").fails(1, "hypar.fold: --backwards: ");
    // Four valleys at one vertex fold flat by the angles, and no order of layers lets them.
    place.put(
        "valleys.fold",
        r#"{"file_spec": 1.2, "vertices_coords": [[0,0],[1,0],[1,1],[0,1],[-1,1],[-1,0],[-1,-1],[0,-1],[1,-1]],
        "edges_vertices": [[1,2],[2,3],[3,4],[4,5],[5,6],[6,7],[7,8],[8,1],[0,1],[0,3],[0,5],[0,7]],
        "edges_assignment": ["B","B","B","B","B","B","B","B","V","V","V","V"],
        "faces_vertices": [[0,1,2,3],[0,3,4,5],[0,5,6,7],[0,7,8,1]]}"#,
    );
    let ran = place.run("fold valleys.fold --backwards -o a.fold");
    ran.fails(1, "valleys.fold: --backwards: no order of the layers lets the sheet lie flat");
    assert!(!place.has("a.fold"));
    place
        .run("fold valleys.fold --backwards --solver newton -o a.fold")
        .fails(1, "--solver newton: it has no --backwards");
    place.run("fold valleys.fold --backwards --backend gpu -o a.fold").fails(1, "--backend gpu");
}

#[cfg(feature = "newton")]
#[test]
fn newton_goes_under_contact_too() {
    let place = Place::new();
    place.run("pattern strip -o strip.fold").succeeds();
    place.run("fold strip.fold --contact --solver newton -o a.fold --report r.json --quiet").succeeds();
    let report = place.json("r.json");
    assert_eq!((&report["stop"], &report["crossings"]["count"]), (&json!("converged"), &json!(0)));
    assert!(report["residual"].as_f64().unwrap() < 1e-10 && report["contact"]["least_gap"].as_f64().unwrap() > 0.0);
}

#[test]
fn dynamics_goes_under_contact_too() {
    let place = Place::new();
    place.run("pattern strip -o strip.fold").succeeds();
    let dynamics =
        "fold strip.fold --contact-gap 0.01 --solver dynamics --ramp 500 --steps 1500 -o b.fold --report r.json";
    place.run(dynamics).succeeds();
    let report = place.json("r.json");
    assert_eq!((&report["stop"], &report["crossings"]["count"]), (&json!("steps_done"), &json!(0)));
    assert!(report["contact"]["least_gap"].is_number(), "{report}");
}

#[test]
fn layers_keep_more_of_a_stiffer_gap() {
    let place = Place::new();
    place.run("pattern bird-base -o base.fold").succeeds();
    let least = |options: &str| {
        place.run(&format!("fold base.fold {options} -o b.fold --report r.json")).succeeds();
        let report = place.json("r.json");
        assert_eq!(report["stop"], json!("converged"));
        report["contact"]["least_gap"].as_f64().expect("contact")
    };
    let [softer, usual, stiffer] = ["--contact-stiffness 5", "--contact", "--contact-stiffness 500"].map(least);
    assert!(1.2 * softer < usual && 1.2 * usual < stiffer, "{softer} {usual} {stiffer}");
    place
        .run("fold base.fold --contact-stiffness 0 -o b.fold")
        .fails(1, "--contact-stiffness 0: expected a finite number greater than 0");
}

/// A film of a sequence has its steps; thick paper is a plate for each face, and its order is told though it is not thin.
#[cfg(feature = "render")]
#[test]
fn pictures_and_files_show_what_contact_has_laid() {
    let place = Place::new();
    let letter = include_str!("../../../../examples/sequences/letter-fold.fold");
    // Flaps of whole thirds have no room for their edges in the folds of thick paper.
    let (third, narrower) = (
        "[[0,0],[1,0],[2,0],[3,0],[3,2],[2,2],[1,2],[0,2]]",
        "[[0.2,0],[1,0],[2,0],[2.8,0],[2.8,2],[2,2],[1,2],[0.2,2]]",
    );
    assert!(letter.contains(third));
    place.put("letter.fold", &letter.replace(third, narrower));
    let bytes = |name: &str| std::fs::read(place.path(name)).unwrap();
    place
        .run("fold letter.fold --sequence own --thickness 0.004 -o a.fold -o a.stl --animate f-.png --sheet s.png --size 64x64 --quiet")
        .succeeds();
    assert!(bytes("f-001.png").starts_with(b"\x89PNG"), "the second step is the last picture");
    assert!(bytes("f-000.png") != bytes("f-001.png") && !place.has("f-002.png"));
    // Three plates of two triangles on either side and eight around.
    let stl = bytes("a.stl");
    assert_eq!(u32::from_le_bytes([stl[80], stl[81], stl[82], stl[83]]), 3 * 12);
    let folded = place.json("a.fold");
    let orders = folded["file_frames"][1]["faceOrders"].as_array().unwrap();
    assert_eq!(orders.len(), 3, "each two of three layers: {orders:?}");
    assert_eq!(folded["file_frames"][0]["faceOrders"], json!([[0, 1, 1]]), "the other third still lies beside");
}
