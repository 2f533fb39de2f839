//! Warnings of scenes that are known to go wrong, where a person and where a program reads them.

use serde_json::{Value, json};

use crate::place::{Place, SQUARE};

/// The places of a report's warnings.
fn warned(report: &Value) -> Vec<&str> {
    report["warnings"].as_array().unwrap().iter().map(|warning| warning["place"].as_str().unwrap()).collect()
}

#[test]
fn over_folding_is_told_once() {
    let place = Place::new();
    place.run("pattern single-crease -o a.fold").succeeds();
    let ran = place.run("fold a.fold --percent 120 --report r.json -o b.fold");
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    assert!(ran.stderr.contains("asked to fold past 180 degrees at 120 %, up to 216.0"), "{}", ran.stderr);
    assert!(matches!(warned(&place.json("r.json"))[..], [crease] if crease.starts_with("crease ")));
    let warning = &place.json("r.json")["warnings"][0];
    let pattern = place.json("a.fold");
    let edge = pattern["edges_assignment"].as_array().unwrap().iter().position(|letter| letter == "V").unwrap();
    assert_eq!((&warning["code"], &warning["at"]["creases"][0]["edge"]), (&json!("over-folding"), &json!(edge)));
    let mut ends: Vec<u64> =
        warning["at"]["creases"][0]["vertices"].as_array().unwrap().iter().map(|v| v.as_u64().unwrap()).collect();
    ends.sort_unstable();
    let mut written = pattern["edges_vertices"][edge].as_array().unwrap().clone();
    written.sort_by_key(Value::as_u64);
    assert_eq!(json!(ends), Value::from(written));
    assert_eq!(place.run("fold a.fold --percent 120 --quiet -o b.fold").stderr, "");
    let ran = place.run("sweep a.fold --percent 0,90,-120 --k-fold 0.7,7 -o out");
    assert_eq!(ran.stderr.matches("past 180 degrees").count(), 1, "{}", ran.stderr);
    assert_eq!(warned(&place.json("out/sweep.json")["scenes"][0]).len(), 1);
    place.run("fold square.fold --percent 100 -o b.fold").succeeds();
}

#[test]
fn what_cannot_fold_is_told_at_the_end() {
    let place = Place::new();
    place.run("pattern hypar -o a.fold").succeeds();
    let ran = place.run("fold a.fold --report r.json -o b.fold");
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    let strained = "warning: the sheet at 100 %: comes to rest strained, ";
    assert!(ran.stderr.starts_with(strained) && ran.stderr.lines().count() == 1, "{}", ran.stderr);
    let report = place.json("r.json");
    assert_eq!(warned(&report), ["the sheet at 100 %"]);
    assert_eq!(report["warnings"][0]["at"], json!({ "percent": 100.0 }));
    place.run("fold a.fold --percent 60 -o b.fold").succeeds();
}

#[test]
fn slivers_are_told_without_folding() {
    let place = Place::new();
    let thin = SQUARE.replace("[1, 0]", "[0.501, 0.5]");
    assert_ne!(thin, SQUARE);
    place.put("thin.fold", &thin);
    let told = |name: &str| {
        let ran = place.run(&format!("info {name}"));
        assert_eq!(ran.code, 0, "{}", ran.stderr);
        ran.stdout + &ran.stderr
    };
    let text = told("thin.fold");
    assert!(text.contains("triangle 0-1-2: height of the thinnest ") && text.contains("of its longest side"), "{text}");
    assert!(!told("square.fold").contains("thinnest"));
}
