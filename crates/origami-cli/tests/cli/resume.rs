//! Sweeps that end early, and go on.

use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::place::Place;

const WORDS: &str = "sweep miura.fold --percent 0:100:2 --k-fold 0.7,7 -o out --folded obj";

fn place() -> Place {
    let place = Place::new();
    place.run("pattern miura -o miura.fold").succeeds();
    place
}

/// All of a finished sweep but its times.
fn finished(place: &Place) -> (Value, String, Vec<String>) {
    let mut table = place.json("out/sweep.json");
    table.as_object_mut().unwrap().remove("seconds").unwrap();
    assert_eq!(table["complete"], json!(true));
    let sheets = table["instances"].as_array().unwrap();
    let text = |row: &Value| place.text(row["outputs"][0].as_str().unwrap());
    let sheets = sheets.iter().map(text).collect();
    (table, place.text("out/sweep.csv"), sheets)
}

#[test]
fn a_sweep_that_is_killed_keeps_its_rows_and_goes_on_where_it_stopped() {
    let place = place();
    place.run(&format!("{WORDS} --quiet")).succeeds();
    let whole = finished(&place);
    std::fs::remove_dir_all(place.path("out")).unwrap();

    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("origami"));
    command.current_dir(place.path("")).args(WORDS.split(' ')).stdout(Stdio::null());
    let mut child = command.spawn().unwrap();
    let begun = Instant::now();
    // Some rows, and not the last.
    let rows = || std::fs::read_to_string(place.path("out/sweep.csv")).map_or(0, |text| text.lines().count());
    while rows() < 5 && begun.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let table = place.json("out/sweep.json");
    let kept = table["instances"].as_array().unwrap().len();
    assert!(kept >= 3, "{kept}");
    for row in table["instances"].as_array().unwrap() {
        assert!(place.has(row["outputs"][0].as_str().unwrap()));
    }

    let ran = place.run(&format!("{WORDS} --resume"));
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    assert!(ran.stderr.contains(&format!("{kept} of 102 rows are taken from before\n")), "{}", ran.stderr);
    assert!(ran.stdout.contains("102 sheets"), "{}", ran.stdout);
    assert!(finished(&place) == whole, "a sweep in two parts is the sweep");

    // A folded sheet that is gone is made again, and so are those after it.
    std::fs::remove_file(place.path("out/0040.obj")).unwrap();
    let ran = place.run(&format!("{WORDS} --resume"));
    assert!(ran.stderr.contains("40 of 102 rows are taken from before"), "{}", ran.stderr);
    assert!(finished(&place) == whole);
}

#[test]
fn other_settings_or_patterns_are_not_gone_on_with() {
    let place = Place::new();
    let words = "sweep square.fold --percent 0,50,100 -o out";
    let ran = place.run(&format!("{words} --resume"));
    assert_eq!((ran.code, ran.stderr.as_str()), (0, "there are no rows to go on from: all are made\n"));
    let made = place.text("out/sweep.json");
    place.put("other.fold", &crate::place::SQUARE.replace("[1, 1]", "[1, 1.5]"));
    for (words, setting) in [
        ("sweep square.fold --percent 0,50,99 -o out", "percents [0.0,50.0,100.0], not [0.0,50.0,99.0]"),
        ("sweep square.fold --percent 0,50,100 --k-fold 1 -o out", "k_fold [0.7], not [1.0]"),
        ("sweep square.fold --percent 0,50,100 --tolerance 1e-3 -o out", "tolerance 0.0001, not 0.001"),
        ("sweep square.fold --percent 0,50,100 --solver dynamics -o out", "solver \"relax\", not \"dynamics\""),
        ("sweep square.fold --percent 0,50,100 --folded stl -o out", "folded [], not [\"stl\"]"),
        ("sweep other.fold --percent 0,50,100 -o out", "pattern "),
    ] {
        let ran = place.run(&format!("{words} --resume"));
        ran.fails(1, &format!("out/sweep.json: was made with {setting}"));
        assert!(
            ran.stderr.ends_with("expected the same settings and pattern, or none of --resume\n"),
            "{}",
            ran.stderr
        );
        assert_eq!(place.text("out/sweep.json"), made);
    }
    // The same pattern by another name will do.
    place.run("info square.fold").succeeds();
    std::fs::copy(place.path("square.fold"), place.path("copy.fold")).unwrap();
    let ran = place.run("sweep copy.fold --percent 0,50,100 -o out --resume");
    assert_eq!((ran.code, ran.stderr.as_str()), (0, "3 of 3 rows are taken from before\n"));

    place.put("out/sweep.json", "{");
    place.run(&format!("{words} --resume")).fails(1, "out/sweep.json: EOF while parsing");
    place.put("out/sweep.json", "{}");
    place.run(&format!("{words} --resume")).fails(1, "was made with solver nothing, not \"relax\"");
}

#[test]
fn a_sheet_that_cannot_be_written_takes_no_other_with_it() {
    let place = Place::new();
    std::fs::create_dir_all(place.path("out")).unwrap();
    let words = "sweep square.fold --percent 0:100:10 -o out --folded obj --threads 1";
    place.run(&format!("{words} --quiet")).succeeds();
    let whole = finished(&place);
    std::fs::remove_file(place.path("out/0007.obj")).unwrap();
    // Nothing is written through a link that leads in a circle.
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("0007.obj", place.path("out/0007.obj")).unwrap();
        let ran = place.run(words);
        ran.fails(1, "error: out/0007.obj: ");
        assert!(
            ran.stderr.contains("7 of 11 rows are in the tables, and --resume goes on from there"),
            "{}",
            ran.stderr
        );
        let table = place.json("out/sweep.json");
        assert_eq!((table["instances"].as_array().unwrap().len(), &table["complete"]), (7, &json!(false)));
        assert_eq!(place.text("out/sweep.csv").lines().count(), 8);
        std::fs::remove_file(place.path("out/0007.obj")).unwrap();
        place.run(&format!("{words} --resume --quiet")).succeeds();
    }
    assert!(cfg!(not(unix)) || finished(&place) == whole);
}

#[test]
fn rows_that_diverged_are_told_again() {
    let place = Place::new();
    let words = "sweep square.fold --solver dynamics --time-step 0.05 --steps 300 --ea 20,1e6 -o out";
    let first = place.run(words);
    let again = place.run(&format!("{words} --resume"));
    assert_eq!((first.code, again.code), (2, 2));
    let told = "error: square.fold: 1 of 2 diverged; the first is 1 at 100 %: ";
    assert!(first.stderr.contains(told) && again.stderr.contains(told), "{}", again.stderr);
    assert!(again.stderr.contains("2 of 2 rows are taken from before"), "{}", again.stderr);
}
