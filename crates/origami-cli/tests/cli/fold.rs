//! `origami fold` with one input: results, formats, exit codes.

use serde_json::{Value, json};

use crate::place::Place;

/// The fold angle reached at edge 4, in degrees.
fn angle(document: &Value) -> f64 {
    document["edges_foldAngle"][4].as_f64().unwrap()
}

#[test]
fn folds_to_the_angle_asked_for() {
    let place = Place::new();
    let ran = place.run("fold square.fold -o a.fold");
    let line = ran.succeeds();
    assert!(line.starts_with("square.fold: folded to 100 % in "), "{line}");
    assert!(line.contains(" steps, converged (distance ") && line.contains("strain mean "), "{line}");
    let folded = place.json("a.fold");
    // One crease folds without strain: nothing is left but the distance from the equilibrium.
    assert!((angle(&folded) - 90.0).abs() < 1e-3, "{}", angle(&folded));
    assert_eq!(folded["origami:converged"], json!(true));
    assert!(folded["origami:distance"].as_f64().unwrap() < 1e-4);
    assert_eq!(folded["origami:percent"].as_f64(), Some(100.0));
    assert_eq!(folded["edges_vertices"], place.json("square.fold")["edges_vertices"]);

    place.run("fold square.fold -o a.fold --percent -50").succeeds();
    assert!((angle(&place.json("a.fold")) + 45.0).abs() < 1e-3);
}

#[test]
fn both_solvers_agree() {
    let place = Place::new();
    place.run("fold square.fold -o a.fold --solver dynamics --quiet").succeeds();
    assert!((angle(&place.json("a.fold")) - 90.0).abs() < 0.05);
    place.run("fold square.fold -o a.fold --solver dynamics --integrator verlet --time-step safe --quiet").succeeds();
    assert!((angle(&place.json("a.fold")) - 90.0).abs() < 0.05);
}

#[test]
fn one_run_writes_several_formats() {
    let place = Place::new();
    place.run("fold square.fold -o a.fold -o a.OBJ -o a.stl").succeeds();
    let obj = place.text("a.OBJ");
    assert_eq!(obj.lines().filter(|line| line.starts_with("v ")).count(), 4);
    assert_eq!(obj.lines().filter(|line| line.starts_with("f ")).count(), 2);
    let stl = std::fs::read(place.path("a.stl")).unwrap();
    assert_eq!(stl.len(), 84 + 2 * 50, "two triangles");
}

#[test]
fn the_input_is_not_replaced_under_any_name() {
    let place = Place::new();
    std::fs::hard_link(place.path("square.fold"), place.path("hard.fold")).unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink("square.fold", place.path("link.obj")).unwrap();
    std::fs::create_dir(place.path("sub")).unwrap();
    for words in [
        "fold square.fold -o square.fold",
        "fold square.fold -o ./sub/../square.fold",
        "fold hard.fold -o square.fold",
        "fold square.fold -o a.obj -o link.obj",
        "fold square.fold hard.fold -o ./",
        "render square.fold -o a.svg -o link.obj",
    ] {
        let ran = place.run(words);
        assert_eq!(ran.code, 1, "{words}");
        let refused = "would be replaced by what is made from it; expected another file or folder";
        assert!(ran.stderr.contains(refused) || ran.stderr.contains("ending in .png"), "{words}: {}", ran.stderr);
        assert!(!place.has("a.obj") && !place.has("a.svg"));
    }
    place
        .run("fold square.fold -o a.obj --report hard.fold")
        .fails(1, "hard.fold: the report would overwrite an input");
    assert_eq!(place.text("square.fold"), crate::place::SQUARE);
    place.run("fold square.fold -o sub/square.fold --quiet").succeeds();
}

#[test]
fn frames_make_an_animation() {
    let place = Place::new();
    let ran = place.run("fold square.fold -o a.fold -o a.obj --frames 4 --percent 80 --report r.json");
    assert_eq!(ran.code, 0);
    assert_eq!(ran.stderr, "warning: a.obj: holds the last stage only; FOLD files hold all of them\n");
    assert!(ran.stdout.contains("in 5 frames"), "{}", ran.stdout);
    let film = place.json("a.fold");
    assert!(film["file_classes"].as_array().unwrap().contains(&json!("animation")));
    let frames = film["file_frames"].as_array().unwrap();
    assert_eq!(frames.len(), 5, "the flat one and four stages");
    for (i, frame) in frames.iter().enumerate() {
        let percent = 20.0 * i as f64;
        assert_eq!(frame["origami:percent"].as_f64(), Some(percent));
        assert_eq!(frame["origami:converged"], json!(true));
        assert!((angle(frame) - 0.9 * percent).abs() < 1e-3);
    }
    let report = place.json("r.json");
    let steps: Vec<u64> = report["frames"].as_array().unwrap().iter().map(|f| f["steps"].as_u64().unwrap()).collect();
    assert_eq!(steps.len(), 5);
    assert_eq!(report["steps"].as_u64().unwrap(), steps.iter().sum::<u64>());
    // The last stage is what a run without stages gives.
    place.run("fold square.fold -o b.obj --percent 80").succeeds();
    assert_eq!(place.text("a.obj").lines().count(), place.text("b.obj").lines().count());
}

#[test]
fn the_asked_number_of_steps_is_done() {
    let place = Place::new();
    for solver in ["relax", "dynamics"] {
        let ran = place.run(&format!("fold square.fold -o a.fold --steps 7 --solver {solver} --report r.json"));
        assert!(ran.succeeds().contains("in 7 steps, as many as asked"), "{}", ran.stdout);
        let report = place.json("r.json");
        assert_eq!((&report["steps"], &report["stop"]), (&json!(7), &json!("steps_done")));
        assert_eq!(place.json("a.fold")["origami:converged"], json!(false));
    }
    place.run("fold square.fold -o a.fold --steps 7 --frames 2 --report r.json").succeeds();
    assert_eq!(place.json("r.json")["steps"], json!(21), "seven for each of three frames");
}

#[test]
fn the_step_limit_is_3_and_the_output_says_so() {
    let place = Place::new();
    let ran = place.run("fold square.fold -o a.fold --max-steps 100 --report r.json");
    ran.fails(3, "error: square.fold: not converged at 100 % after 100 steps");
    assert!(ran.stdout.contains("not converged"), "{}", ran.stdout);
    let folded = place.json("a.fold");
    assert_eq!(folded["origami:converged"], json!(false));
    assert_eq!(folded["origami:distance"], Value::Null, "nothing is known of it yet");
    let report = place.json("r.json");
    assert_eq!((&report["converged"], &report["stop"]), (&json!(false), &json!("step_limit")));
    let quiet = place.run("fold square.fold -o a.fold --max-steps 100 --quiet");
    quiet.fails(3, "not converged");
    assert_eq!(quiet.stdout, "");
}

#[test]
fn divergence_is_2_and_older_output_stays() {
    let place = Place::new();
    place.put("a.fold", "as it was");
    let words = "fold square.fold -o a.fold -o b.obj --solver dynamics --time-step 1 --report r.json";
    let ran = place.run(words);
    ran.fails(2, "error: square.fold: at 100 %: diverged at step ");
    assert!(ran.stderr.contains("vertex ") && ran.stderr.contains(" radii (expected at most "), "{}", ran.stderr);
    assert_eq!(ran.stdout, "");
    assert_eq!(place.text("a.fold"), "as it was");
    assert!(!place.has("b.obj"));
    let report = place.json("r.json");
    assert!([json!("move"), json!("position")].contains(&report["diverged"]["quantity"]));
    assert!(report["diverged"]["value"].as_f64().unwrap() > 1.0);
    assert_eq!(report["diverged"]["step"], report["steps"]);
    assert!(report["diverged"]["vertex"].as_u64().unwrap() < 4);
    assert_eq!(
        (&report["converged"], &report["strain"], &report["outputs"]),
        (&json!(false), &Value::Null, &json!([]))
    );
    assert_eq!(report["time_step"], json!(1.0));
}

#[test]
fn divergence_comes_with_advice_for_its_solver() {
    let place = Place::new();
    for (words, advice) in [
        ("--solver dynamics --time-step 1e300", "; --time-step safe or a smaller one may hold\n"),
        ("--solver dynamics --time-step safe --k-fold 1e308", "; a smaller --time-step may hold\n"),
        ("--k-fold 1e308", "; stiffnesses nearer to the defaults or a longer --ramp may hold\n"),
    ] {
        let ran = place.run(&format!("fold square.fold -o a.fold {words}"));
        ran.fails(2, advice);
        assert!(ran.stderr.len() < 300, "huge numbers are short: {}", ran.stderr);
    }
}

#[test]
fn stages_before_a_divergence_are_reported() {
    let place = Place::new();
    place.put("strip.fold", &crate::place::SQUARE.replace("90]", "179]"));
    // Holds while the sheet lies flat, for nothing moves there.
    place
        .run("fold strip.fold -o a.fold --frames 2 --solver dynamics --time-step 1 --report r.json")
        .fails(2, "at 50 %");
    let report = place.json("r.json");
    let frames = report["frames"].as_array().unwrap();
    assert_eq!((frames.len(), &frames[0]["converged"]), (1, &json!(true)));
    assert!(report["steps"].as_u64() > frames[0]["steps"].as_u64());
    assert!(!place.has("a.fold"));
}

#[test]
fn the_perturbation_is_that_asked_for() {
    let place = Place::new();
    place.run("fold square.fold -o a.fold --perturbation 0").succeeds();
    place.run("fold square.fold -o b.fold --perturbation 0.01").succeeds();
    place.run("fold square.fold -o c.fold").succeeds();
    assert_eq!(place.text("b.fold"), place.text("c.fold"), "it is the default");
    assert_ne!(place.text("a.fold"), place.text("c.fold"));
}

#[test]
fn bad_input_is_1_and_older_output_stays() {
    let place = Place::new();
    place.put("a.fold", "as it was");
    place.put("bad.fold", &crate::place::SQUARE.replace("[0, 2]]", "[0, 9]]"));
    place
        .run("fold bad.fold -o a.fold")
        .fails(1, "error: bad.fold: edges_vertices[4]: vertex 9 does not exist; expected");
    place.run("fold missing.fold -o a.fold").fails(1, "error: missing.fold: No such file");
    place.run("fold . -o a.fold").fails(1, "error: .: Is a directory");
    place.run("fold square.fold -o a.fold --frame 3").fails(1, "error: square.fold: frame 3: there is no such frame");
    assert_eq!(place.text("a.fold"), "as it was");
}

#[test]
fn a_place_that_cannot_be_written_is_1() {
    let place = Place::new();
    std::fs::create_dir(place.path("a.fold")).unwrap();
    place.put("file", "");
    // A folder takes the file, whatever its name.
    place.run("fold square.fold -o a.fold").succeeds();
    assert!(place.has("a.fold/square.fold"));
    place.run("fold square.fold -o file/").fails(1, "error: file/");
    place.run("fold square.fold -o file/a.fold").fails(1, "there is no folder file");
}

#[test]
fn the_frame_is_that_asked_for() {
    let place = Place::new();
    let flat = crate::place::SQUARE
        .replace("\n}", ",\n\"file_frames\": [{\"frame_inherit\": true, \"frame_parent\": 0, \"edges_foldAngle\": [0, 0, 0, 0, 40]}]\n}");
    place.put("two.fold", &flat);
    place.run("fold two.fold -o a.fold --frame 1").succeeds();
    assert!((angle(&place.json("a.fold")) - 40.0).abs() < 1e-3);
    place.run("fold two.fold -o a.fold").succeeds();
    assert!((angle(&place.json("a.fold")) - 90.0).abs() < 1e-3);
}

#[test]
fn an_animation_of_a_folded_file_has_no_stale_marks() {
    let place = Place::new();
    place.run("fold square.fold -o a.fold --max-steps 100").fails(3, "");
    place.run("fold a.fold -o b.fold --frames 1 --quiet");
    let film = place.json("b.fold");
    assert_eq!(film.get("origami:converged"), None);
    assert!(film["file_frames"][1].get("origami:converged").is_some());
}
