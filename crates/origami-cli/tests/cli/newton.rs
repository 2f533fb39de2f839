//! `--solver newton`, in builds with it and without.

use crate::place::Place;

#[cfg(not(feature = "newton"))]
#[test]
fn a_build_without_it_says_so() {
    let place = Place::new();
    for words in ["fold square.fold -o a.fold --solver newton", "sweep square.fold -o out --solver newton"] {
        place.run(words).fails(1, "--solver newton: this build is without it (feature `newton`)");
        assert_eq!(place.names(), ["square.fold"]);
    }
}

#[cfg(feature = "newton")]
mod present {
    use super::*;
    use serde_json::{Value, json};

    fn report(place: &Place, words: &str) -> Value {
        place.run(&format!("fold square.fold -o a.fold --report r.json --quiet {words}")).succeeds();
        place.json("r.json")
    }

    #[test]
    fn it_goes_on_from_relax_to_the_equilibrium() {
        let place = Place::new();
        place.run("pattern miura -o square.fold").succeeds();
        let loose = report(&place, "--percent 60 --tolerance 1e-3");
        let exact = report(&place, "--percent 60 --tolerance 1e-3 --solver newton");
        assert_eq!((&exact["solver"], &exact["backend"]), (&json!("newton"), &json!("cpu")));
        assert_eq!(exact["stop"], json!("converged"));
        let number = |report: &Value, key: &str| report[key].as_f64().unwrap();
        assert!(number(&exact, "residual") <= 1e-10 && number(&loose, "residual") > 1e-8);
        assert!(number(&exact, "distance") < 1e-9, "{}", exact["distance"]);
        assert!(number(&exact, "steps") > number(&loose, "steps"));
        let left_out = exact["left_out"].as_array().unwrap();
        assert!(left_out.iter().any(|group| group["what"] == json!("damping")));
        let weaker = report(&place, "--percent 60 --tolerance 1e-3 --solver newton --residual 1e-2");
        assert!(number(&weaker, "steps") < number(&exact, "steps"));
    }

    #[test]
    fn frames_and_sweeps_take_it_too() {
        let place = Place::new();
        let frames = report(&place, "--frames 3 --solver newton");
        assert!(frames["frames"].as_array().unwrap().iter().all(|frame| frame["residual"].as_f64().unwrap() <= 1e-10));
        place.run("sweep square.fold -o out --percent 0:100:50 --solver newton --quiet").succeeds();
        let table: Value = place.json("out/sweep.json");
        assert_eq!(table["solver"], json!("newton"));
        let rows = table["instances"].as_array().unwrap();
        assert!(rows.len() == 3 && rows.iter().all(|row| row["residual"].as_f64().unwrap() <= 1e-10));
        // As in `fold`, to the bit.
        let one = report(&place, "--percent 50 --solver newton");
        assert_eq!(rows[1]["energy"], one["energy"]);
    }

    #[test]
    fn the_step_limit_holds_for_it_too() {
        let place = Place::new();
        place.run("pattern miura -o square.fold").succeeds();
        for limit in [0, 1, 100] {
            let words = format!("fold square.fold --solver newton --max-steps {limit} -o a.obj --report r.json");
            let ran = place.run(&words);
            ran.fails(3, &format!("not converged at 100 % after {limit} steps: the largest force is "));
            assert_eq!(place.json("r.json")["steps"], json!(limit));
        }
    }

    #[test]
    fn what_it_does_not_take_is_told() {
        let place = Place::new();
        let ran = place.run("fold square.fold -o a.fold --solver newton --steps 5 --zeta 0.1 --adapter llvmpipe");
        assert_eq!(ran.code, 0);
        let expected = [
            "warning: --zeta has no effect with --solver newton",
            "warning: --steps has no effect with --solver newton",
            "warning: --adapter has no effect with --solver newton",
        ];
        assert_eq!(ran.stderr.lines().collect::<Vec<_>>(), expected);
        assert_eq!(place.run("fold square.fold -o a.fold --solver newton --perturbation 0.1 --ramp 0").stderr, "");
        place.run("fold square.fold -o b.fold --solver newton --backend gpu").fails(1, "newton runs on the processor");
    }
}
