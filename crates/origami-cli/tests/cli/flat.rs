//! The flat-folded state: `--solver reflect`, `--from-flat`; and `--max-seconds`.

use serde_json::{Value, json};

use crate::place::Place;

fn report(place: &Place, words: &str) -> Value {
    place.run(&format!("fold p.fold -o a.fold --report r.json --quiet {words}")).succeeds();
    place.json("r.json")
}

#[test]
fn reflect_gives_the_flat_state_without_a_step() {
    let place = Place::new();
    place.run("pattern bird-base -o p.fold").succeeds();
    for percent in [100, -100] {
        let flat = report(&place, &format!("--solver reflect --percent {percent}"));
        assert_eq!(
            (&flat["solver"], &flat["from"], &flat["stop"]),
            (&json!("reflect"), &json!("rest"), &json!("converged"))
        );
        assert_eq!(
            (&flat["steps"], &flat["backend"], &flat["percent"]),
            (&json!(0), &json!("cpu"), &json!(f64::from(percent)))
        );
        assert!(
            flat["strain"]["max"].as_f64().unwrap() < 1e-12 && flat["angle_error_deg"]["max"].as_f64().unwrap() < 1e-9
        );
    }
    let ran = place.run("fold p.fold -o a.fold --solver reflect");
    assert!(ran.stdout.starts_with("p.fold: folded to 100 % by reflection, exact (distance "), "{}", ran.stdout);
}

#[test]
fn what_does_not_fold_flat_is_refused_by_name() {
    let place = Place::new();
    place.run("pattern miura -o p.fold").succeeds();
    let ran = place.run("fold p.fold -o a.fold --solver reflect --percent 60");
    ran.fails(1, "degrees; expected 0 or 180: 100 % or -100 % of a pattern that folds flat");
    assert!(ran.stderr.contains("p.fold: at 60 %: the crease between vertices "), "{}", ran.stderr);
    place.run("fold p.fold -o a.fold --solver reflect --backend gpu").fails(1, "reflect runs on the processor");
    place.run("sweep p.fold -o out --solver reflect --percent 60").fails(1, "expected 0 or 180");
    place.run("pattern hypar -o p.fold").succeeds();
    place.run("fold p.fold -o a.fold --from-flat --percent 60").fails(1, "--from-flat: the crease between vertices ");
    assert!(!place.has("a.fold"));
}

#[test]
fn from_flat_opens_the_sheet_and_says_so() {
    let place = Place::new();
    place.run("pattern bird-base -o p.fold").succeeds();
    let opened = report(&place, "--percent 60 --from-flat");
    assert_eq!((&opened["solver"], &opened["from"]), (&json!("relax"), &json!("flat")));
    assert_eq!((&opened["converged"], &opened["percent"]), (&json!(true), &json!(60.0)));
    let closed = report(&place, "--percent 60");
    assert_eq!(closed["from"], json!("rest"));
    let energy = |report: &Value| report["energy"]["total"].as_f64().unwrap();
    assert!(energy(&opened) <= energy(&closed) * 1.001, "{} {}", energy(&opened), energy(&closed));
    let film = report(&place, "--percent -60 --from-flat --frames 4");
    let percents: Vec<f64> =
        film["frames"].as_array().unwrap().iter().map(|frame| frame["percent"].as_f64().unwrap()).collect();
    assert_eq!(percents, [-100.0, -90.0, -80.0, -70.0, -60.0]);
    let ran = place.run("fold p.fold -o a.fold --percent 60 --from-flat");
    assert!(ran.stdout.contains("folded to 60 % from the flat-folded state in "), "{}", ran.stdout);
}

#[test]
fn a_run_ends_when_its_time_is_over() {
    let place = Place::new();
    place.run("pattern miura --set columns=30 --set rows=30 -o p.fold").succeeds();
    for more in ["", "--solver dynamics", "--frames 3"] {
        let ran = place.run(&format!("fold p.fold -o a.fold --report r.json --max-seconds 1e-9 {more}"));
        ran.fails(3, "when its time was over; the output says so; more --max-seconds");
        let report = place.json("r.json");
        assert_eq!((&report["stop"], &report["converged"]), (&json!("time_limit"), &json!(false)), "{more}");
    }
    place.run("fold p.fold -o a.fold --percent 10 --max-seconds 1e9").succeeds();
}

#[test]
fn what_reflect_does_not_take_is_told() {
    let place = Place::new();
    place.run("pattern bird-base -o p.fold").succeeds();
    let ran = place.run("fold p.fold -o a.fold --solver reflect --ramp 7 --max-steps 7 --from-flat --max-seconds 7");
    assert_eq!(ran.code, 0);
    for option in ["--ramp", "--max-steps", "--from-flat", "--max-seconds"] {
        assert!(ran.stderr.contains(&format!("{option} has no effect with --solver reflect")), "{}", ran.stderr);
    }
}
