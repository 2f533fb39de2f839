//! Many sheets of one pattern, and their tables.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::{Value, json};

use crate::place::{Place, SQUARE};

/// The rows of a CSV file, by the names in its first line.
fn rows(text: &str) -> Vec<BTreeMap<&str, &str>> {
    assert!(text.ends_with("\r\n") && !text.contains('"'), "{text}");
    let mut lines = text.trim_end().split("\r\n").map(|line| line.split(',').collect::<Vec<_>>());
    let names = lines.next().unwrap();
    let row = |cells: Vec<_>| {
        assert_eq!(cells.len(), names.len());
        names.iter().copied().zip(cells).collect()
    };
    lines.map(row).collect()
}

/// A JSON file without the times, which differ from run to run.
fn timeless(place: &Place, name: &str) -> Value {
    let mut table = place.json(name);
    table.as_object_mut().unwrap().remove("seconds").unwrap();
    table
}

#[test]
fn every_combination_has_a_row_in_order() {
    let place = Place::new();
    let words = "sweep square.fold --percent 0:100:50 --k-fold 0.7,7 --perturbation 0,0.01 --seeds 2 -o out";
    let ran = place.run(words);
    let line = ran.succeeds();
    assert!(line.starts_with("square.fold: 24 sheets, 24 converged, strain mean 0 % to "), "{line}");
    assert_eq!(std::fs::read_dir(place.path("out")).unwrap().count(), 2, "the tables alone");
    let text = place.text("out/sweep.csv");
    let rows = rows(&text);
    let mut expected = Vec::new();
    for k_fold in ["0.7", "7.0"] {
        for perturbation in ["0.0", "0.01"] {
            for seed in ["0", "1"] {
                for percent in ["0.0", "50.0", "100.0"] {
                    expected.push([k_fold, perturbation, seed, percent]);
                }
            }
        }
    }
    let seen: Vec<_> =
        rows.iter().map(|row| ["k_fold", "perturbation", "seed", "percent"].map(|key| row[key])).collect();
    assert_eq!(seen, expected);
    for (i, row) in rows.iter().enumerate() {
        assert_eq!(row["index"], i.to_string());
        assert_eq!(["ea", "k_facet", "k_face", "zeta"].map(|key| row[key]), ["20.0", "0.7", "0.2", "0.45"]);
        assert_eq!((row["converged"], row["stop"], row["diverged_step"]), ("true", "converged", ""));
        // A single crease reaches its angle without strain.
        assert!(
            row["strain_max"].parse::<f64>().unwrap() < 1e-3
                && row["angle_error_deg_max"].parse::<f64>().unwrap() < 0.1
        );
    }
    assert_ne!(rows[7]["steps"], "0");
}

#[test]
fn a_row_is_what_fold_says_of_the_same_sheet() {
    let place = Place::new();
    place.put("twist.fold", &generated(&place, "square-twist"));
    for solver in ["relax", "dynamics --steps 200"] {
        let words = "--percent 40,80 --ea 20,40 --zeta 0.3 --perturbation 0.001";
        // What fold has for relaxations only.
        let words = if solver == "relax" { words } else { "--percent 40,80 --ea 20,40 --zeta 0.3" };
        place.run(&format!("sweep twist.fold -o out --folded fold,obj --quiet --solver {solver} {words}")).succeeds();
        let table = place.json("out/sweep.json");
        assert_eq!(table["instances"].as_array().unwrap().len(), 4);
        let text = place.text("out/sweep.csv");
        let rows = rows(&text);
        let mut index = 0;
        for ea in ["20", "40"] {
            for percent in ["40", "80"] {
                let words = words.replace("40,80", percent).replace("20,40", ea);
                let words =
                    format!("fold twist.fold -o a.fold -o a.obj --report r.json --quiet --solver {solver} {words}");
                place.run(&words).succeeds();
                let alone = place.json("r.json");
                let row = &table["instances"][index];
                let keys = ["percent", "time_step", "steps", "converged", "stop", "attempts", "residual", "distance"];
                let measured = ["strain", "nodes_strain", "energy", "angle_error_deg", "tangled", "tangled_creases"];
                for key in keys.iter().chain(&measured) {
                    assert_eq!(row[key], alone[key], "{key} of {words}");
                }
                let scene = &table["scenes"][row["scene"].as_u64().unwrap() as usize];
                for key in ["vertices", "beams", "creases", "faces", "triangles", "built", "left_out", "warnings"] {
                    assert_eq!(scene[key], alone[key], "{key} of {words}");
                }
                for key in ["solver", "backend", "adapter", "tolerance"] {
                    assert_eq!(table[key], alone[key], "{key} of {words}");
                }
                assert_eq!(rows[index]["strain_mean"], alone["strain"]["mean"].to_string());
                assert_eq!(rows[index]["energy_total"], alone["energy"]["total"].to_string());
                for extension in ["fold", "obj"] {
                    let sheet = place.text(&format!("out/000{index}.{extension}"));
                    assert!(sheet == place.text(&format!("a.{extension}")), "sheet {index} of {words}");
                }
                index += 1;
            }
        }
        assert_ne!(table["instances"][0]["strain"], table["instances"][3]["strain"], "sheets differ");
    }
}

fn generated(place: &Place, name: &str) -> String {
    place.run(&format!("pattern {name} -o -")).succeeds().to_owned()
}

#[test]
fn nothing_depends_on_the_number_of_threads() {
    let place = Place::new();
    let mut seen = Vec::new();
    for threads in [1, 4] {
        let words = format!("sweep square.fold --percent 10:90:20 --k-face 0,0.2 -o out --threads {threads} --quiet");
        assert_eq!(place.run(&words).succeeds(), "");
        seen.push((timeless(&place, "out/sweep.json"), place.text("out/sweep.csv")));
    }
    assert!(seen[0] == seen[1]);
    let table = &seen[0].0;
    // Without k_face there are no corner angles.
    let scenes: Vec<u64> =
        { table["instances"].as_array().unwrap().iter() }.map(|r| r["scene"].as_u64().unwrap()).collect();
    assert_eq!(scenes, [0, 0, 0, 0, 0, 1, 1, 1, 1, 1]);
    let what =
        |scene: usize| table["scenes"][scene]["built"].as_array().unwrap().iter().any(|b| b["what"] == "corner angles");
    assert_eq!([0, 1].map(what), [false, true]);
}

#[test]
fn more_sheets_than_are_held_at_once_are_folded_too() {
    let place = Place::new();
    // 4 vertices each: a batch has 65 536 of them.
    let words = "sweep square.fold --percent 0,10 --ea 1:33000:1 --steps 1 -o out";
    let ran = place.run(words);
    assert!(ran.succeeds().starts_with("square.fold: 66 000 sheets, 66 000 with the asked number of steps, "));
    let text = place.text("out/sweep.csv");
    let rows = rows(&text);
    assert!(rows.iter().enumerate().all(|(i, row)| row["index"] == i.to_string() && row["steps"] == "1"));
    assert!(rows.iter().enumerate().all(|(i, row)| row["ea"] == format!("{}.0", i / 2 + 1)));
    assert!(rows.iter().enumerate().all(|(i, row)| row["percent"] == ["0.0", "10.0"][i % 2]));
}

#[test]
fn seeds_make_a_difference_where_there_is_something_to_fold() {
    let place = Place::new();
    place.run("sweep square.fold --percent 0,50 --seeds 3 --steps 30 --folded stl -o out").succeeds();
    let sheets: Vec<Vec<u8>> = (0..6).map(|i| std::fs::read(place.path(&format!("out/000{i}.stl"))).unwrap()).collect();
    assert!(sheets[0] == sheets[2] && sheets[0] == sheets[4], "flat ones stay flat");
    assert!(sheets[1] != sheets[3] && sheets[3] != sheets[5] && sheets[1] != sheets[5]);
}

#[test]
fn a_sheet_that_diverges_has_its_row_and_takes_no_other_with_it() {
    let place = Place::new();
    std::fs::create_dir(place.path("out")).unwrap();
    place.put("out/0001.obj", "as it was");
    let words = "sweep square.fold --solver dynamics --time-step 0.05 --steps 300 --ea 20,1e6 --folded obj -o out";
    let ran = place.run(words);
    ran.fails(2, "error: square.fold: 1 of 2 diverged; the first is 1 at 100 %: diverged at step ");
    assert!(ran.stderr.ends_with("; --time-step safe or a smaller one may hold\n"), "{}", ran.stderr);
    assert!(ran.stdout.contains("2 sheets, 1 with the asked number of steps, 1 diverged, strain"), "{}", ran.stdout);
    assert_eq!(place.text("out/0001.obj"), "as it was");
    assert!(place.text("out/0000.obj").contains("v "));
    let table = place.json("out/sweep.json");
    let [held, lost] = [0, 1].map(|i| &table["instances"][i]);
    assert_eq!(
        (&held["stop"], held.get("diverged"), &held["outputs"]),
        (&json!("steps_done"), None, &json!(["out/0000.obj"]))
    );
    assert_eq!((&lost["stop"], &lost["converged"], lost.get("outputs")), (&json!("diverged"), &json!(false), None));
    assert_eq!((&lost["strain"], &lost["steps"]), (&Value::Null, &lost["diverged"]["step"]));
    let text = place.text("out/sweep.csv");
    let rows = rows(&text);
    assert_eq!(rows[0]["diverged_vertex"], "");
    for key in ["vertex", "step", "value"] {
        assert_eq!(rows[1][format!("diverged_{key}").as_str()], lost["diverged"][key].to_string());
    }
    assert_eq!(json!(rows[1]["diverged_quantity"]), lost["diverged"]["quantity"]);
    assert_eq!((rows[1]["strain_mean"], rows[1]["residual"]), ("", ""));

    let words = "sweep square.fold --percent 0,100 --max-steps 300 -o out";
    let ran = place.run(words);
    ran.fails(3, "error: square.fold: 1 of 2 not converged; the first is 1 at 100 %: an unknown distance from the equilibrium after 300 steps");
    assert!(ran.stdout.contains("2 sheets, 1 converged, 1 not converged"), "{}", ran.stdout);
}

#[test]
fn what_cannot_be_done_is_refused_before_any_work() {
    let place = Place::new();
    place.put("file", "");
    for (words, expected) in [
        ("sweep", "<INPUT>"),
        ("sweep square.fold", "--output"),
        ("sweep square.fold -o out --percent 0:100", "`0:100`: expected a number or a range FROM:TO:STEP"),
        ("sweep square.fold -o out --percent 0:100:-5", "the step leads away from 100; expected a positive one"),
        ("sweep square.fold -o out --percent 0:100:0", "the step is 0"),
        ("sweep square.fold -o out --percent -5:x:1", "expected a finite number"),
        ("sweep square.fold -o out --k-fold 1,-1", "`-1`: expected a finite number of at least 0"),
        ("sweep square.fold -o out --ea 0:10:1", "`0:10:1`: expected a finite number greater than 0"),
        ("sweep square.fold -o out --perturbation 0.1,2", "`2`: expected a number from 0 to 1"),
        ("sweep square.fold -o out --seeds 0", "expected a whole number from 1 to 1000000"),
        ("sweep square.fold -o out --backend tpu", "auto, cpu or gpu"),
        ("sweep square.fold -o out --folded jpg", "jpg"),
        ("sweep square.fold -o out --folded obj,obj", "obj is named twice"),
        ("sweep square.fold -o out --frames 3", "--frames"),
        ("sweep square.fold square.fold -o out", "square.fold"),
        (
            "sweep square.fold -o out --ea 1:1000:1 --k-fold 1:1000:1 --percent 0,1",
            "the lists combine to too many sheets, 2 000 000; expected at most 1 000 000",
        ),
        (
            "sweep square.fold -o out --ea 1:1e5:1 --k-fold 1:1e5:1 --k-face 1:1e5:1 --zeta 1:1e5:1",
            "too many sheets, more than can be counted",
        ),
        ("sweep square.fold -o file", "file: is no folder; expected one"),
        ("sweep square.fold -o -", "-: is no folder; expected one"),
        ("sweep square.fold -o file/out", "file/out/sweep.csv: file is no folder; expected one"),
        ("sweep missing.fold -o out", "error: missing.fold: No such file"),
        ("sweep file -o out", "error: file: line 1: the file is empty"),
        ("sweep square.fold -o out --frame 3", "error: square.fold: frame 3: there is no such frame"),
    ] {
        let ran = place.run(words);
        ran.fails(1, expected);
        assert_eq!(ran.stdout, "", "{words}");
        assert_eq!(place.names(), ["file", "square.fold"], "{words} leaves nothing behind");
    }
}

#[test]
fn the_input_is_not_replaced_nor_is_a_folder() {
    let place = Place::new();
    std::fs::create_dir_all(place.path("out/sweep.csv")).unwrap();
    place.run("sweep square.fold -o out").fails(1, "out/sweep.csv: is a folder; expected a file or nothing there");
    std::fs::remove_dir(place.path("out/sweep.csv")).unwrap();
    place.put("out/0001.fold", SQUARE);
    let words = "sweep out/0001.fold --folded fold -o ./out --percent";
    place
        .run(&format!("{words} 0,1"))
        .fails(1, "out/0001.fold: would be replaced by the sweep; expected another folder");
    place.put("out/sweep.json", SQUARE);
    place.run("sweep out/sweep.json -o out").fails(1, "out/sweep.json: would be replaced");
    assert_eq!((place.text("out/0001.fold"), place.text("out/sweep.json")), (SQUARE.to_owned(), SQUARE.to_owned()));
    // One sheet is 0000.fold.
    place.run(&format!("{words} 50")).succeeds();
    assert_eq!(place.text("out/0001.fold"), SQUARE);
    assert!(place.has("out/0000.fold"));
}

#[test]
fn options_without_effect_are_told() {
    let place = Place::new();
    let ran = place.run("sweep square.fold -o out --zeta 0.1,0.2 --time-step safe --percent 10,-120 --steps 1");
    assert_eq!(ran.code, 0);
    for expected in [
        "warning: --percent -120: folds past the pattern's own angles",
        "warning: --time-step has no effect with --solver relax",
        "warning: --zeta has no effect with --solver relax",
    ] {
        assert!(ran.stderr.contains(expected), "{}", ran.stderr);
    }
    let dynamics = "sweep square.fold -o out --solver dynamics --zeta 0.1,0.2 --perturbation 0,0.1 --steps 50";
    place.run(dynamics).succeeds();
    let text = place.text("out/sweep.csv");
    let energies: Vec<_> = rows(&text).iter().map(|row| row["energy_total"].to_owned()).collect();
    assert_ne!(energies[0], energies[1], "dynamics takes the perturbation too");
    assert_ne!(energies[0], energies[2]);
}

#[test]
fn standard_input_is_swept_too() {
    let place = Place::new();
    let ran = place.run_with("sweep - -o made/on/the/way --percent 0:20:10", SQUARE);
    assert!(ran.succeeds().starts_with("-: 3 sheets, 3 converged"), "{}", ran.stdout);
    assert_eq!(place.json("made/on/the/way/sweep.json")["input"], json!("-"));
}

#[test]
fn the_document_names_every_key_and_column() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/REPORT.md");
    let text = std::fs::read_to_string(path).unwrap();
    let (_, text) = text.split_once("## `origami sweep`").unwrap();
    let text = text.split("\n## ").next().unwrap();
    let place = Place::new();
    place.run(
        "sweep square.fold --solver dynamics --time-step 0.05 --steps 300 --ea 20,1e6 --folded obj -o out --quiet",
    );
    let table = place.json("out/sweep.json");
    let rows = table["instances"].as_array().unwrap();
    let mut keys: Vec<&String> = table.as_object().unwrap().keys().collect();
    rows.iter().for_each(|row| keys.extend(row.as_object().unwrap().keys()));
    assert!(keys.len() > 50, "{keys:?}");
    for key in keys {
        assert!(text.contains(&format!("| `{key}` |")), "{key} is not documented");
    }
    // Columns are keys, or two of them joined.
    let csv = place.text("out/sweep.csv");
    let names = csv.lines().next().unwrap().split(',');
    let has = |name: &str| rows.iter().any(|row| row.get(name).is_some() || nested(row, name));
    let unknown: Vec<&str> = names.filter(|name| !has(name)).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
}

/// Whether `a_b` is the key `b` in the object at the key `a`.
fn nested(row: &Value, name: &str) -> bool {
    name.match_indices('_').any(|(i, _)| row.get(&name[..i]).is_some_and(|inner| inner.get(&name[i + 1..]).is_some()))
}
