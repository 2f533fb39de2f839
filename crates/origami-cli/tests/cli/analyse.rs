//! `origami analyse`, in builds with it and without.

use crate::place::Place;

#[cfg(not(feature = "analysis"))]
#[test]
fn a_build_without_it_says_so() {
    let place = Place::new();
    place
        .run("analyse path square.fold -o out")
        .fails(1, "origami analyse: this build is without it (feature `analysis`)");
    assert_eq!(place.names(), ["square.fold"]);
}

#[cfg(feature = "analysis")]
mod present {
    use super::*;

    /// A low pyramid over a square with a free apex, and what presses it through.
    fn pyramid() -> Place {
        let place = Place::new();
        place.put(
            "pyramid.fold",
            r#"{"vertices_coords": [[1, 1, 0], [-1, 1, 0], [-1, -1, 0], [1, -1, 0], [0, 0, 0.4]],
                "faces_vertices": [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]], "frame_unit": "mm"}"#,
        );
        place.put(
            "press.json",
            r#"{"units": {"length": "mm", "force": "N"}, "bar": {"ea": 20}, "crease": {"k": 0.01}, "facet": {"k": 0.01},
                "supports": [{"on": {"box": [[null, null, null], [null, null, 0]]}, "fixed": true}],
                "loads": [{"on": {"at": [0, 0, 0.4]}, "force": [0, 0, -1]}],
                "path": {"to": null, "ends": [[4, "z", -0.9]]}}"#,
        );
        place
    }

    #[test]
    fn a_path_is_written() {
        let place = pyramid();
        let ran = place.run("analyse path pyramid.fold press.json -o out");
        // What is odd about the pattern is told: it has no letters.
        assert!(ran.code == 0 && ran.stderr.contains("edges_assignment"), "{}", ran.stderr);
        let line = ran.stdout;
        assert!(line.starts_with("out/path.json and 3 files beside it: "), "{line}");
        assert!(line.contains("2 limit points") && line.contains("reached its end"), "{line}");
        let report = place.json("out/path.json");
        assert_eq!((&report["units"]["length"], &report["laws"]["bars"]), (&"mm".into(), &"linear".into()));
        assert_eq!((&report["ended"], &report["unknowns"]), (&"reached".into(), &3.into()));
        let events = report["events"].as_array().unwrap();
        let limits: Vec<f64> =
            events.iter().filter(|e| e["event"] == "limit").map(|e| e["load_factor"].as_f64().unwrap()).collect();
        assert!(limits.len() == 2 && limits[0] > 0.0 && limits[1] < 0.0, "{limits:?}");
        assert!((events.last().unwrap()["displacements"][0].as_f64().unwrap() + 0.9).abs() < 1e-9);
        let mut table = csv::Reader::from_path(place.path("out/curve.csv")).unwrap();
        let keys = table.headers().unwrap().clone();
        assert_eq!(keys.iter().take(4).collect::<Vec<_>>(), ["step", "event", "load_factor", "u_4_z"]);
        let rows: Vec<_> = table.records().collect::<Result<_, _>>().unwrap();
        assert_eq!(report["points"], rows.len());
        assert!(place.text("out/curve.svg").ends_with("</svg>\n"));
        // The frames are sheets of the file's size.
        let frames = place.json("out/frames.fold");
        let last = frames["file_frames"].as_array().unwrap().last().unwrap();
        assert!((last["vertices_coords"][4][2].as_f64().unwrap() + 0.5).abs() < 1e-9, "{last}");
    }

    #[test]
    fn a_path_is_taken_up_again() {
        let place = pyramid();
        let job = place.text("press.json");
        place.put("half.json", &job.replace("-0.9", "-0.5"));
        place.run("analyse path pyramid.fold press.json -q -o whole").succeeds();
        place.run("analyse path pyramid.fold half.json -q -o half").succeeds();
        place.run("analyse path pyramid.fold press.json --restart half/path.json -q -o rest").succeeds();
        let end = |folder: &str| {
            let report = place.json(&format!("{folder}/path.json"));
            report["events"].as_array().unwrap().last().unwrap()["load_factor"].as_f64().unwrap()
        };
        assert!((end("whole") - end("rest")).abs() < 1e-10);
        place
            .run("analyse path pyramid.fold press.json --restart half/path.json --branch 7 -o aside")
            .fails(1, "--branch 7: half/path.json has");
        place
            .run("analyse path pyramid.fold press.json --restart press.json -o aside")
            .fails(1, "press.json: `last` is missing; expected where the path ended");
    }

    #[test]
    fn states_stiffness_and_modes_are_written() {
        let place = pyramid();
        let line = place.run("analyse equilibria pyramid.fold press.json -o out").stdout;
        assert!(line.starts_with("out/equilibria.json: 3 states without load, 2 of them stable"), "{line}");
        let states = place.json("out/equilibria.json");
        let barrier = states["equilibria"][0]["barrier"].as_f64().unwrap();
        assert!((barrier - states["equilibria"][1]["energy"].as_f64().unwrap()).abs() < 1e-12 && barrier > 0.0);
        assert_eq!(place.json("out/equilibria.fold")["file_frames"].as_array().unwrap().len(), 3);

        place.run("analyse stiffness pyramid.fold press.json -q -o out").succeeds();
        let stiffness = place.json("out/stiffness.json");
        let sunk = stiffness["displacements"][4][2].as_f64().unwrap();
        assert!((stiffness["compliance"].as_f64().unwrap() + sunk).abs() < 1e-12 && sunk < 0.0);
        let forces = stiffness["reactions"].as_array().unwrap().iter().filter(|r| r["axis"] == "z");
        assert!((forces.map(|r| r["force"].as_f64().unwrap()).sum::<f64>() - 1.0).abs() < 1e-9);

        place.run("analyse buckling pyramid.fold press.json -n 1 -q -o out").succeeds();
        let critical = &place.json("out/buckling.json")["load_factors"];
        assert!(critical[0].as_f64().is_some_and(|factor| factor > 0.0), "{critical}");

        let job = place.text("press.json");
        let heavy = job.replace("\"force\": \"N\"", "\"force\": \"N\", \"mass\": \"g\"").replacen(
            "\"supports\"",
            "\"masses\": [{\"on\": {\"vertices\": [0, 1, 2, 3, 4]}, \"mass\": 2}], \"supports\"",
            1,
        );
        place.put("heavy.json", &heavy);
        place.run("analyse modes pyramid.fold heavy.json -n 3 -q -o out").succeeds();
        let modes = place.json("out/modes.json");
        let lowest = &modes["modes"][0];
        // Of 2 g on springs in N/mm.
        let wanted = (lowest["eigenvalue"].as_f64().unwrap() * 1e6).sqrt() / std::f64::consts::TAU;
        assert!((lowest["frequency"].as_f64().unwrap() / wanted - 1.0).abs() < 1e-12, "{modes}");
        assert_eq!(modes["modes"].as_array().unwrap().len(), 3);
        place.run("analyse modes square.fold -n 8 -q -o out").succeeds();
        assert_eq!(place.json("out/modes.json")["counts"][0], serde_json::json!(["free", 6]));
    }

    #[test]
    fn a_loaded_state_vibrates_otherwise_and_is_filmed() {
        let place = pyramid();
        place.run("analyse path pyramid.fold press.json --frames 5 --animate out/path.gif -q -o out").succeeds();
        assert!(cfg!(not(feature = "render")) || place.has("out/path.gif"));
        let frames = place.json("out/frames.fold");
        let frames = frames["file_frames"].as_array().unwrap();
        assert_eq!(frames.len(), 5);
        let job = place.text("press.json").replace("\"force\": \"N\"", "\"force\": \"N\", \"mass\": \"g\"");
        let heavy = "\"masses\": [{\"on\": {\"vertices\": [0, 1, 2, 3, 4]}, \"mass\": 2}], \"supports\"";
        place.put("heavy.json", &job.replacen("\"supports\"", heavy, 1));
        let lowest = |options: &str| {
            place.run(&format!("analyse modes pyramid.fold heavy.json -n 1 -q -o out {options}")).succeeds();
            place.json("out/modes.json")
        };
        let value = |report: &serde_json::Value| report["modes"][0]["eigenvalue"].as_f64().unwrap();
        let drawn = lowest("");
        assert_eq!(drawn["load_factor"], 0.0);
        // The first frame is as drawn; on the way through one direction is unstable.
        let first = lowest("--at out/frames.fold --at-frame 1 --animate out/modes.apng");
        assert!((value(&first) / value(&drawn) - 1.0).abs() < 1e-9, "{first}");
        let unstable = (1..=5).filter(|i| value(&lowest(&format!("--at out/frames.fold --at-frame {i}"))) < 0.0);
        assert!(unstable.count() > 0);
        let last = lowest("--at out/frames.fold");
        assert_eq!(last["load_factor"], frames[4]["origami:loadFactor"]);
        place
            .run("analyse modes pyramid.fold heavy.json --at square.fold -o out")
            .fails(1, "square.fold: vertices_coords: has 4; expected the sheet's 5");
        place
            .run("analyse path pyramid.fold press.json --animate film.mp4 -o out")
            .fails(1, "film.mp4: no film is written as this");
    }

    #[test]
    fn tables_name_the_vertices_of_the_file() {
        let place = pyramid();
        // An unused vertex comes first: nodes are numbered otherwise.
        let file = place.text("pyramid.fold").replace("[[1, 1, 0],", "[[9, 9, 9], [1, 1, 0],");
        let file =
            file.replace("[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]", "[1, 2, 5], [2, 3, 5], [3, 4, 5], [4, 1, 5]");
        place.put("pyramid.fold", &file);
        let job = place.text("press.json");
        let moved = "\"supports\": [{\"on\": {\"vertices\": [5]}, \"displacement\": [null, null, -0.9]}, ";
        let job = job.replacen("\"supports\": [", moved, 1);
        let start = job.find("\"loads\"").unwrap();
        place.put("press.json", &format!("{}\"path\": {{}}}}", &job[..start]));
        place.run("analyse path pyramid.fold press.json -q -o out").succeeds();
        let table = place.text("out/curve.csv");
        assert!(table.starts_with("step,event,load_factor,u_5_z,reaction_5_z,energy_bars"), "{table}");
    }

    #[test]
    fn bad_jobs_are_refused_by_key_and_write_nothing() {
        let place = pyramid();
        let job = place.text("press.json");
        for (old, new, told) in [
            ("\"fixed\": true", "\"fixed\": \"z\"", "pyramid.fold: supports: they leave 3 rigid motions free"),
            ("\"at\": [0, 0, 0.4]", "\"vertices\": [5]", "bad.json: loads[0].on.vertices[0]: is vertex 5; expected"),
            ("\"mm\"", "\"ell\"", "bad.json: units.length: is `ell`"),
            ("\"mm\"", "\"unit\"", "bad.json: units.length: is `unit`; expected a length: the file's is `mm`"),
            (
                "\"supports\": [",
                "\"supports\": [{\"on\": {\"vertices\": [0]}, \"displacement\": [null, 1, null]}, ",
                "bad.json: supports[1]: vertex 0 is held at 0 and at 1 along y; expected one displacement",
            ),
            ("\"ea\"", "\"eb\"", "bad.json: bar.eb: unknown field `eb`"),
        ] {
            place.put("bad.json", &job.replacen(old, new, 1));
            place.run("analyse path pyramid.fold bad.json -o out").fails(1, told);
            assert!(!place.has("out/path.json"), "{told}");
        }
        place.run("analyse path pyramid.fold none.json -o out").fails(1, "none.json: ");
        let (start, end) = (job.find("\"supports\"").unwrap(), job.find("\"loads\"").unwrap());
        place.put("bad.json", &format!("{}{}", &job[..start], &job[end..]));
        place
            .run("analyse path pyramid.fold bad.json -o out")
            .fails(1, "pyramid.fold: supports: they leave 6 rigid motions free; expected none");
    }
}
