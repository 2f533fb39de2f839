//! What is in the files of folded sheets: lengths, places, layers.

use std::path::Path;

use serde_json::{Value, json};

use crate::place::Place;

/// A place with a file of `tests/cases`.
fn with_case(name: &str) -> Place {
    let place = Place::new();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/cases").join(name);
    place.put(name, &std::fs::read_to_string(path).unwrap());
    place
}

/// The triangles of a binary STL file.
fn stl(bytes: &[u8]) -> Vec<[[f64; 3]; 3]> {
    let number = |bytes: &[u8]| f64::from(f32::from_le_bytes(bytes.try_into().unwrap()));
    let corner = |bytes: &[u8]| [0, 4, 8].map(|at| number(&bytes[at..at + 4]));
    bytes[84..].chunks(50).map(|one| [12, 24, 36].map(|at| corner(&one[at..at + 12]))).collect()
}

fn area([a, b, c]: &[[f64; 3]; 3]) -> f64 {
    let side = |p: &[f64; 3], q: &[f64; 3]| [0, 1, 2].map(|i| q[i] - p[i]);
    let ([u, v, w], [x, y, z]) = (side(a, b), side(a, c));
    let normal = [v * z - w * y, w * x - u * z, u * y - v * x];
    0.5 * normal.iter().map(|n| n * n).sum::<f64>().sqrt()
}

fn bytes(place: &Place, name: &str) -> Vec<u8> {
    std::fs::read(place.path(name)).unwrap()
}

#[test]
fn lengths_are_the_input_s_in_every_format() {
    let place = with_case("svgtest.fold");
    let formats = if cfg!(feature = "render") { "-o u.glb -o u.obj -o u.stl" } else { "-o u.obj -o u.stl" };
    assert_eq!(place.run(&format!("fold svgtest.fold --percent 0 {formats}")).code, 0);
    let corners: Vec<[f64; 3]> = stl(&bytes(&place, "u.stl")).into_iter().flatten().collect();
    let extent = |points: &[[f64; 3]], axis: usize| {
        let all = || points.iter().map(|p| p[axis]);
        all().fold(f64::MIN, f64::max) - all().fold(f64::MAX, f64::min)
    };
    assert_eq!([0, 1, 2].map(|axis| extent(&corners, axis)), [10.0, 20.0, 0.0]);
    let numbers = |line: &str| line.split(' ').skip(1).map(|n| n.parse().unwrap()).collect::<Vec<f64>>();
    let obj = place.text("u.obj");
    let obj = obj.lines().filter(|line| line.starts_with("v "));
    let obj: Vec<[f64; 3]> = obj.map(|line| numbers(line).try_into().unwrap()).collect();
    assert_eq!([0, 1, 2].map(|axis| extent(&obj, axis)), [10.0, 20.0, 0.0]);
    if cfg!(feature = "render") {
        let glb = bytes(&place, "u.glb");
        let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
        let document: Value = serde_json::from_slice(&glb[20..20 + length]).unwrap();
        let position = document["meshes"][0]["primitives"][0]["attributes"]["POSITION"].as_u64().unwrap() as usize;
        let bound =
            |name: &str| -> [f64; 3] { serde_json::from_value(document["accessors"][position][name].clone()).unwrap() };
        let (low, high) = (bound("min"), bound("max"));
        assert!(
            [10.0, 0.0, 20.0].iter().enumerate().all(|(i, e)| (high[i] - low[i] - e).abs() < 1e-5),
            "{low:?} {high:?}"
        );
        assert_eq!(document["nodes"][0]["translation"], json!([5.0, 0.0, -10.0]));
        assert!(document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"].is_u64());
    }
}

#[test]
fn stl_of_a_sheet_far_off_has_its_area_and_says_where_it_went() {
    let place = with_case("offset9.fold");
    let ran = place.run("fold offset9.fold -o a.stl --report r.json");
    ran.fails(0, "warning: STL: the sheet lies around 1000000001 1000000000.5 0, which its 32 bits cannot hold");
    assert!(ran.stderr.contains("32 bits cannot hold: it was moved to the origin"), "{}", ran.stderr);
    let whole: f64 = stl(&bytes(&place, "a.stl")).iter().map(area).sum();
    assert!((whole - 2.0).abs() < 5e-4, "{whole}");
    let warnings = place.json("r.json")["warnings"].clone();
    assert!(warnings.as_array().unwrap().iter().any(|warning| warning["code"] == "fallback"), "{warnings}");
    let ran = place.run("sweep offset9.fold --percent 10,20,30 --folded stl -o s");
    assert_eq!(ran.stderr.matches("moved to the origin").count(), 1, "{}", ran.stderr);
}

/// What a solver leaves is no fold past 180 degrees: a flat-folded file is read again without a word of it.
#[test]
fn a_folded_file_is_read_again_in_silence() {
    let place = Place::new();
    place.run("pattern miura -o miura.fold").succeeds();
    place.run("fold miura.fold -o a.fold").succeeds();
    assert!(place.json("a.fold").get("edges_origami:foldAngle").is_none());
    let ran = place.run("fold a.fold -o b.fold");
    assert!(ran.code == 0 && !ran.stderr.contains("180"), "{}", ran.stderr);
}

#[cfg(feature = "render")]
#[test]
fn a_flat_folded_file_says_which_face_lies_upon_which() {
    let place = Place::new();
    place.put("valley.fold", &place.text("square.fold").replace("90", "180"));
    place.run("fold valley.fold -o a.fold").succeeds();
    // The fronts lie upon each other.
    assert_eq!(place.json("a.fold")["faceOrders"], json!([[0, 1, 1]]));
    place.run("fold valley.fold --frames 2 -o b.fold").succeeds();
    let frames = place.json("b.fold")["file_frames"].clone();
    let orders: Vec<&Value> = frames.as_array().unwrap().iter().map(|frame| &frame["faceOrders"]).collect();
    assert_eq!(orders, [&Value::Null, &Value::Null, &json!([[0, 1, 1]])]);
    place.run("fold valley.fold --percent -100 -o c.fold").succeeds();
    assert_eq!(place.json("c.fold")["faceOrders"], json!([[0, 1, -1]]));
    // That of another state is not kept.
    place.run("fold valley.fold --percent 50 -o d.fold").succeeds();
    assert!(place.json("d.fold").get("faceOrders").is_none());
}
