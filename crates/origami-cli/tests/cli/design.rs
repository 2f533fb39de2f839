//! `origami design`, in builds with it and without.

use crate::place::Place;

#[cfg(not(feature = "analysis"))]
#[test]
fn a_build_without_it_says_so() {
    let place = Place::new();
    place.run("design square.fold -o out").fails(1, "origami design: this build is without it (feature `analysis`)");
}

#[cfg(feature = "analysis")]
mod present {
    use super::*;

    /// A copy of the example of a tube.
    fn tube() -> Place {
        let place = Place::new();
        let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/analysis/");
        for (from, to) in [("kresling-tube.fold", "tube.fold"), ("kresling-height.json", "height.json")] {
            place.put(to, &std::fs::read_to_string(format!("{examples}{from}")).unwrap());
        }
        place
    }

    #[test]
    fn a_tube_is_found_whose_second_state_has_the_height_wanted() {
        let place = tube();
        let line = place.run("design tube.fold height.json -o out").stdout;
        assert!(
            line.starts_with("out/design.json and design.fold beside it: height from 1.03519 to 0.9 by 2"),
            "{line}"
        );
        let report = place.json("out/design.json");
        assert_eq!((&report["goals"][0]["goal"], &report["goals"][0]["reached"]), (&"height".into(), &true.into()));
        let history = report["history"].as_array().unwrap();
        assert!(history.windows(2).all(|pair| pair[1]["value"].as_f64() < pair[0]["value"].as_f64()), "{history:?}");
        for variable in report["variables"].as_array().unwrap() {
            let [value, low, high] =
                [&variable["value"], &variable["bounds"][0], &variable["bounds"][1]].map(|x| x.as_f64().unwrap());
            assert!(low <= value && value <= high, "{variable}");
        }
        // The file that is written has it, when it is read and analysed anew.
        place.run("analyse equilibria out/design.fold height.json -q -o again").succeeds();
        let states = place.json("again/equilibria.fold");
        let second = &states["file_frames"].as_array().unwrap()[2];
        let height = second["vertices_coords"][6][2].as_f64().unwrap();
        assert!((height - 0.9).abs() < 1e-6, "{height}");
    }

    #[test]
    fn single_edges_are_written_with_their_new_numbers() {
        let place = tube();
        let job = place.text("height.json");
        let start = job.find("\"variables\"").unwrap();
        let changed = format!(
            "{}\"variables\": [{{\"rest_lengths\": [2, 6, 10, 14, 18, 22], \"together\": true, \"bounds\": [1.2, 2]}},\n\
             {{\"rest_angles\": [2], \"bounds\": [-170, 170]}}, {{\"stiffnesses\": [3], \"bounds\": [1e-5, 1e-3]}}]}}}}",
            &job[..start]
        );
        place.put("height.json", &changed);
        place.run("design tube.fold height.json -q -o out").succeeds();
        let variables = place.json("out/design.json")["variables"].clone();
        let sheet = place.json("out/design.fold");
        for (key, edge, i) in
            [("edges_origami:rest_length", 6, 0), ("edges_origami:rest_angle", 2, 1), ("edges_origami:k_crease", 3, 2)]
        {
            let (written, value) = (sheet[key][edge].as_f64(), variables[i]["value"].as_f64());
            let apart = (written.unwrap() - value.unwrap()).abs();
            assert!(apart < 1e-9, "{key}: {written:?} {value:?}");
            assert!(sheet[key][0].is_null(), "{key}: {}", sheet[key]);
        }
        place.run("analyse equilibria out/design.fold height.json -q -o again").succeeds();
        let states = place.json("again/equilibria.fold");
        let second = &states["file_frames"].as_array().unwrap()[2];
        let heights = (6..12).map(|i| second["vertices_coords"][i][2].as_f64().unwrap());
        assert!((heights.sum::<f64>() / 6.0 - 0.9).abs() < 1e-6, "{second}");
    }

    #[test]
    fn what_cannot_be_designed_is_refused_and_what_is_not_reached_told() {
        let place = tube();
        let job = place.text("height.json");
        for (old, new, told) in [
            ("\"state\": 2", "\"state\": 7", "tube.fold: design.state: state 7 of 3 without load"),
            ("\"wanted\": 0.9", "\"wanted\": \"low\"", "bad.json: design.goals[0].height.wanted: invalid type"),
            ("\"bounds\": [-10, 10]", "\"bounds\": [10, -10]", "bad.json: design.variables[1].bounds: is [10, -10]"),
        ] {
            place.put("bad.json", &job.replacen(old, new, 1));
            place.run("design tube.fold bad.json -o out").fails(1, told);
            assert!(!place.has("out/design.json"), "{told}");
        }
        let narrow = job.replacen("[-0.3, 0.3]", "[-0.01, 0.01]", 1).replacen("[-10, 10]", "[-0.1, 0.1]", 1);
        place.put("low.json", &narrow);
        let ran = place.run("design tube.fold low.json -o out");
        assert_eq!(ran.code, 3, "{}", ran.stderr);
        assert_eq!(place.json("out/design.json")["goals"][0]["reached"], false);
    }
}
