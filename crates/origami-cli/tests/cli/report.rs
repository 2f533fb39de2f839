//! `--report`: every key that docs/REPORT.md promises, of the type that it promises.

use std::path::Path;

use origami::error::WarningCode;
use serde_json::{Value, json};

use crate::place::{Place, SQUARE};

const KEYS: [&str; 37] = [
    "input",
    "solver",
    "from",
    "backend",
    "backend_by",
    "adapter",
    "percent",
    "precision",
    "vertices",
    "beams",
    "paper",
    "creases",
    "faces",
    "triangles",
    "built",
    "left_out",
    "time_step",
    "steps",
    "converged",
    "stop",
    "attempts",
    "saddles",
    "factorisations",
    "attitude",
    "residual",
    "distance",
    "tolerance",
    "strain",
    "nodes_strain",
    "energy",
    "angle_error_deg",
    "tangled",
    "tangled_creases",
    "warnings",
    "outputs",
    "seconds",
    "frames",
];

fn report(place: &Place, words: &str) -> Value {
    place.run(&format!("fold square.fold --report r.json --quiet {words}"));
    place.json("r.json")
}

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

#[test]
fn the_keys_are_those_promised() {
    let place = Place::new();
    let report = report(&place, "--frames 1");
    let mut found = keys(&report);
    found.sort_unstable();
    let mut expected = KEYS.to_vec();
    expected.sort_unstable();
    assert_eq!(found, expected);
    assert_eq!(keys(&report["strain"]), ["mean", "rms", "max"]);
    assert_eq!(keys(&report["nodes_strain"]), ["mean", "rms", "max"]);
    assert_eq!(keys(&report["energy"]), ["beams", "creases", "corner_angles", "areas", "total"]);
    assert_eq!(keys(&report["angle_error_deg"]), ["mean", "max"]);
    assert_eq!(keys(&report["seconds"]), ["read", "build", "solve", "write", "draw"]);
    assert_eq!(keys(&report["built"][0]), ["what", "count"]);
    assert_eq!(keys(&report["left_out"][0]), ["what", "count", "why"]);
}

#[test]
fn the_document_names_every_key() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/REPORT.md");
    let text = std::fs::read_to_string(path).unwrap();
    for key in KEYS.iter().chain(&["diverged", "error", "crossings", "check", "contact", "step"]) {
        assert!(text.contains(&format!("| `{key}` |")), "{key} is not documented");
    }
}

#[test]
fn the_numbers_are_those_of_a_square_with_a_diagonal() {
    let place = Place::new();
    let report = report(&place, "--percent 50 --tolerance 1e-6");
    let counts = ["vertices", "beams", "creases", "faces", "triangles"].map(|key| report[key].as_u64().unwrap());
    assert_eq!(counts, [4, 5, 1, 2, 2]);
    assert_eq!(report["built"][0], json!({"what": "beams", "count": 5}));
    assert_eq!((&report["solver"], &report["backend"]), (&json!("relax"), &json!("cpu")));
    assert_eq!(report["adapter"], Value::Null);
    assert_eq!((&report["percent"], &report["tolerance"]), (&json!(50.0), &json!(1e-6)));
    assert_eq!(
        (&report["converged"], &report["stop"], &report["attempts"]),
        (&json!(true), &json!("converged"), &json!(1))
    );
    assert!(report["distance"].as_f64().unwrap() < 1e-6);
    // A single crease reaches its angle without strain.
    assert!(report["strain"]["max"].as_f64().unwrap() < 1e-6);
    assert!(report["angle_error_deg"]["max"].as_f64().unwrap() < 1e-3);
    assert!(report["energy"]["total"].as_f64().unwrap() < 1e-9);
    assert_eq!((&report["tangled"], &report["tangled_creases"]), (&json!(false), &json!(0)));
    assert_eq!((&report["warnings"], &report["outputs"]), (&json!([]), &json!([])));
    assert_eq!(report.get("frames"), None);
    assert_eq!(report.get("diverged"), None);
}

#[test]
fn a_tangled_sheet_is_said_to_be_so() {
    let place = Place::new();
    place.put("square.fold", &SQUARE.replace("90]", "250]"));
    let report = report(&place, "");
    assert_eq!(
        (&report["tangled"], &report["tangled_creases"], &report["attempts"]),
        (&json!(true), &json!(1), &json!(1))
    );
    let warning = &report["warnings"][0];
    assert_eq!(warning["place"], json!("edges_foldAngle[4]"));
    assert_eq!(warning["at"], json!({ "frame": null, "key": "edges_foldAngle", "index": 4 }));
    assert_eq!(keys(warning), ["code", "place", "message", "at"]);
    let ran = place.run("fold square.fold -o a.fold");
    assert!(ran.stdout.contains("tangled (1 crease folded past 200 degrees), "));
}

#[test]
fn the_paper_s_time_step_is_told() {
    let place = Place::new();
    let report = report(&place, "--solver dynamics --steps 1 --ea 50");
    // Radius sqrt(1/2), shortest beams of length sqrt(2) radii.
    let expected = 0.9 / (2.0 * std::f64::consts::PI * (50.0 / 2.0_f64.sqrt()).sqrt());
    assert!((report["time_step"].as_f64().unwrap() - expected).abs() < 1e-15);
}

#[test]
fn a_report_goes_to_standard_output_too() {
    let place = Place::new();
    let ran = place.run("fold square.fold --report -");
    assert_eq!(ran.code, 0);
    assert!(ran.stderr.starts_with("square.fold: folded"), "the line makes room: {}", ran.stderr);
    let report: Value = serde_json::from_str(&ran.stdout).unwrap();
    assert_eq!(report["input"], json!("square.fold"));
}

#[test]
fn every_code_of_a_warning_is_documented() {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/REPORT.md")).unwrap();
    let told = |name: &str| text.lines().any(|line| line.starts_with(&format!("| `{name}` | ")));
    let untold: Vec<&str> = WarningCode::ALL.iter().map(|code| code.name()).filter(|name| !told(name)).collect();
    assert!(untold.is_empty(), "docs/REPORT.md does not tell of {untold:?}");
    assert!(!told("no-such-code"));
}
