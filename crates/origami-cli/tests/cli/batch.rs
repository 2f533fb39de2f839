//! Several inputs into a folder.

use serde_json::{Value, json};

use crate::place::{Place, SQUARE};

fn place_with(count: usize) -> Place {
    let place = Place::new();
    for i in 0..count {
        place.put(&format!("s{i}.fold"), &SQUARE.replace("0, 90]", &format!("0, {}]", 10 * (i + 1))));
    }
    place
}

#[test]
fn each_input_makes_its_files() {
    let place = place_with(3);
    let ran = place.run("fold s0.fold s1.fold s2.fold -o out/ --format fold,obj --report r.json");
    let lines: Vec<&str> = ran.succeeds().lines().collect();
    assert_eq!(lines.len(), 3);
    let report = place.json("r.json");
    for i in 0..3 {
        assert!(lines[i].starts_with(&format!("s{i}.fold: folded to 100 %")), "{}", lines[i]);
        let angle = place.json(&format!("out/s{i}.fold"))["edges_foldAngle"][4].as_f64().unwrap();
        assert!((angle - 10.0 * (i as f64 + 1.0)).abs() < 1e-3);
        assert!(place.has(&format!("out/s{i}.obj")) && !place.has(&format!("out/s{i}.stl")));
        assert_eq!(report[i]["outputs"], json!([format!("out/s{i}.fold"), format!("out/s{i}.obj")]));
    }
}

#[test]
fn nothing_depends_on_the_number_of_threads() {
    let place = place_with(6);
    let inputs: Vec<String> = (0..6).rev().map(|i| format!("s{i}.fold")).collect();
    let mut seen: Vec<(String, Value)> = Vec::new();
    for threads in [1, 4] {
        let ran = place
            .run(&format!("fold {} -o out{threads}/ --threads {threads} --report r.json --quiet", inputs.join(" ")));
        ran.succeeds();
        let mut report = place.json("r.json");
        for run in report.as_array_mut().unwrap() {
            let run = run.as_object_mut().unwrap();
            run.remove("seconds");
            run.remove("outputs");
        }
        let texts = inputs.iter().map(|input| place.text(&format!("out{threads}/{input}"))).collect();
        seen.push((texts, report));
    }
    assert_eq!(seen[0], seen[1]);
    assert_eq!(seen[0].1[0]["input"], json!("s5.fold"), "in the order of the inputs");
}

#[test]
fn a_sheet_shared_out_is_the_same() {
    let place = Place::new();
    // Of 2 601 nodes: as many threads as are asked for, up to five; and one less than two threads share.
    for (size, nodes) in [("--set columns=50 --set rows=50", 2601), ("--set columns=32 --set rows=30", 1023)] {
        place.run(&format!("pattern miura {size} -o miura.fold")).succeeds();
        for method in ["relax", "dynamics --integrator euler", "dynamics --integrator verlet"] {
            for precision in ["f64", "mixed"] {
                let words = format!("fold miura.fold -o out.fold --solver {method} --precision {precision} --steps 60");
                let [one, others @ ..] = [1, 2, 3, 5].map(|threads| {
                    place.run(&format!("{words} --threads {threads}"));
                    place.text("out.fold")
                });
                assert!(others.iter().all(|other| *other == one), "{nodes} nodes, {method}, {precision}");
            }
        }
    }
}

#[test]
fn one_bad_input_does_not_stop_the_others_and_the_most_severe_counts() {
    let place = place_with(2);
    place.put("bad.fold", "{");
    let ran = place.run("fold s0.fold bad.fold s1.fold -o out/ --report r.json");
    ran.fails(1, "error: bad.fold: line 1");
    assert!(place.has("out/s0.fold") && place.has("out/s1.fold") && !place.has("out/bad.fold"));
    let report = place.json("r.json");
    assert_eq!(report[0]["converged"], json!(true));
    assert_eq!(report[1]["input"], json!("bad.fold"));
    assert!(report[1]["error"].as_str().unwrap().starts_with("line 1"));
    assert_eq!(report[1].as_object().unwrap().len(), 2);

    // A sheet without driven creases has converged before the limit; the other has not.
    place.put("still.fold", &SQUARE.replace("\"V\"", "\"F\"").replace("90]", "0]"));
    place.run("fold still.fold s0.fold -o out/ --max-steps 100").fails(3, "s0.fold: not converged");
    place.run("fold bad.fold s0.fold -o out/ --max-steps 100").fails(1, "s0.fold: not converged");
    place
        .run("fold still.fold s0.fold -o out/ --solver dynamics --time-step 10")
        .fails(2, "s0.fold: at 100 %: diverged");
}

#[test]
fn the_report_may_lie_in_the_folder_that_is_made() {
    let place = place_with(1);
    place.run("fold s0.fold square.fold -o out/ --report out/r.json --quiet").succeeds();
    assert_eq!(place.json("out/r.json").as_array().unwrap().len(), 2);
    place.put("bad.fold", "{");
    place.run("fold bad.fold -o away/ --report away/r.json").fails(1, "error: bad.fold");
    assert!(place.json("away/r.json")["error"].is_string());
}

#[test]
fn warnings_name_their_input() {
    let place = Place::new();
    place.put("lower.fold", &SQUARE.replace("\"V\"", "\"v\""));
    let many = place.run("fold lower.fold square.fold -o out/");
    assert!(many.stderr.starts_with("warning: lower.fold: edges_assignment[4]: "), "{}", many.stderr);
    let one = place.run("fold lower.fold -o out/");
    assert!(one.stderr.starts_with("warning: edges_assignment[4]: "), "{}", one.stderr);
    place.run("fold lower.fold -o out/ --quiet").succeeds();
}
