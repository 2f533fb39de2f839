//! Jobs: from files to structures, and what is wrong with them told by key.

use std::ops::ControlFlow;

use origami_core::analysis::job::{Job, Setup};
use origami_core::analysis::{Event, Start};
use origami_core::fold::Document;
use origami_core::{CreasePattern, Material, Model};
use serde_json::{Value, json};

/// MERLIN's Kresling as a FOLD file: two octagons, the upper one turned by an eighth of a turn, in units of `scale`.
fn kresling(scale: f64) -> Value {
    let ring = |height: f64, turn: f64| {
        (0..8).map(move |i| {
            let angle = turn + std::f64::consts::TAU * f64::from(i) / 8.0;
            json!([scale * angle.cos(), scale * angle.sin(), scale * height])
        })
    };
    let faces = (0..8).flat_map(|i| {
        let (next, above) = ((i + 1) % 8, 8 + (i + 1) % 8);
        [json!([i, 8 + i, above]), json!([i, next, above])]
    });
    json!({
        "vertices_coords": ring(0.0, 0.0).chain(ring(1.0, std::f64::consts::FRAC_PI_4)).collect::<Vec<_>>(),
        "faces_vertices": faces.collect::<Vec<_>>(),
    })
}

fn job() -> Value {
    json!({
        "units": {"length": "unit", "force": "unit"},
        "bar": {"law": "ogden", "ea": 500.0},
        "crease": {"law": "stiffened", "k": 0.001},
        "facet": {"k": 0.001},
        "supports": [{"on": {"box": [[null, null, null], [null, null, 0.01]]}, "fixed": true}],
        "loads": [{"on": {"box": [[null, null, 0.99], [null, null, null]]}, "force": [0, 0, -1]}],
        "path": {"to": null, "ends": [[8, "z", -0.7]]}
    })
}

fn read(file: &Value) -> (Document, CreasePattern, Model) {
    let document = Document::from_slice(file.to_string().as_bytes()).expect("FOLD");
    let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    (document, pattern, model)
}

fn setup(file: &Value, job: &Value) -> Result<Setup, String> {
    let (document, pattern, model) = read(file);
    let job = Job::from_slice(job.to_string().as_bytes()).map_err(|error| error.to_string())?;
    job.setup(&document.key_frame, &pattern, &model).map_err(|error| error.to_string())
}

fn limits(setup: &Setup) -> Vec<f64> {
    let path = setup.structure.trace(&Start::default(), &setup.path, &mut |_| ControlFlow::Continue(()));
    let path = path.expect("a path");
    let limits = path.events().filter(|point| matches!(point.event, Event::LimitPoint { .. }));
    limits.map(|point| point.load_factor).collect()
}

#[test]
fn a_job_makes_merlins_kresling_of_a_file() {
    let setup = setup(&kresling(1.0), &job()).expect("a job");
    assert_eq!(setup.monitors.iter().map(|(vertex, _)| *vertex).collect::<Vec<_>>(), [8]);
    let limits = limits(&setup);
    assert!((limits[0] - 0.432297769).abs() < 1e-8 && (limits[1] + 0.102125919).abs() < 1e-8, "{limits:?}");
}

#[test]
fn supports_and_loads_may_be_in_the_file() {
    let (mut file, mut whole) = (kresling(1.0), job());
    let each = |below: Value, above: Value| [vec![below; 8], vec![above; 8]].concat();
    file["vertices_origami:fixed"] = json!(each(json!("xyz"), json!(false)));
    file["vertices_origami:load"] = json!(each(Value::Null, json!([0, 0, -1])));
    for key in ["supports", "loads"] {
        whole.as_object_mut().expect("an object").remove(key);
    }
    file["origami:analysis"] = whole;
    let (document, pattern, model) = read(&file);
    let own = Job::in_frame(&document.key_frame).expect("a job").setup(&document.key_frame, &pattern, &model);
    let (own, beside) = (own.expect("a job"), setup(&kresling(1.0), &job()).expect("a job"));
    assert_eq!(own.structure.bars, beside.structure.bars);
    assert_eq!(own.structure.loads, beside.structure.loads);
    let held = |setup: &Setup| {
        let mut held = setup.structure.supports.fixed.clone();
        held.sort();
        held.dedup();
        held
    };
    assert_eq!(held(&own), held(&beside));
    assert_eq!(held(&own).len(), 24);

    // Along some axes only: the pattern itself holds none of them.
    file["vertices_origami:fixed"] = json!(each(json!([true, false, true]), json!("")));
    let (document, pattern, model) = read(&file);
    assert!(pattern.fixed.is_empty());
    let own = Job::in_frame(&document.key_frame).expect("a job").setup(&document.key_frame, &pattern, &model);
    assert_eq!(held(&own.expect("a job")).len(), 16);
}

#[test]
fn one_sheet_in_two_units_is_the_same() {
    let mut file = kresling(50.0);
    file["frame_unit"] = json!("mm");
    let in_units = |length: &str, force: &str, metres: f64, newtons: f64| {
        let mut job = job();
        job["units"] = json!({"length": length, "force": force});
        job["bar"] = json!({"law": "green"});
        let pressure = metres * metres / newtons;
        job["sheet"] = json!({"E": 4e9 * pressure, "nu": 0.3, "t": 0.25e-3 / metres});
        job["crease"] = json!({"law": "stiffened", "length_scale": 20e-3 / metres});
        job["supports"][0]["on"]["box"][1][2] = json!(0.5);
        job["loads"][0]["on"]["box"][0][2] = json!(49.5);
        job["loads"][0]["force"] = json!([0.0, 0.0, -1.0 / newtons]);
        job["path"] = json!({"to": null, "ends": [[8, "z", -0.015 / metres]]});
        setup(&file, &job).expect("a job")
    };
    let (metres, millimetres) = (in_units("m", "N", 1.0, 1.0), in_units("mm", "mN", 1e-3, 1e-3));
    let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
    for (a, b) in metres.structure.bars.iter().zip(&millimetres.structure.bars) {
        assert!(close(b.rigidity, 1e3 * a.rigidity) && close(b.rest_length, 1e3 * a.rest_length), "{a:?} {b:?}");
    }
    for (a, b) in metres.structure.hinges.iter().zip(&millimetres.structure.hinges) {
        assert!(close(b.stiffness, 1e6 * a.stiffness), "{a:?} {b:?}");
    }
    let limits = [limits(&metres), limits(&millimetres)];
    assert!(!limits[0].is_empty());
    assert!(limits[0].iter().zip(&limits[1]).all(|(a, b)| (a / b - 1.0).abs() < 1e-12), "{limits:?}");
}

#[test]
fn what_is_wrong_with_a_job_is_told_by_key() {
    let changed = |path: &str, value: Value| {
        let mut job = job();
        *job.pointer_mut(path).expect("a key") = value;
        setup(&kresling(1.0), &job).expect_err("refused")
    };
    for (path, value, told) in [
        ("/units/length", json!("ell"), "units.length: is `ell`; expected `m`, "),
        ("/bar/law", json!("rubber"), "bar.law: unknown variant `rubber`"),
        ("/bar/ea", json!(-1), "bar.ea: is -1; expected a number above 0"),
        ("/bar/ea", Value::Null, "bar.ea: is missing; expected a rigidity, or a `sheet`"),
        ("/crease/k", Value::Null, "crease.k: is missing; expected a stiffness, or a `sheet`"),
        ("/supports/0/on", json!({"vertices": [99]}), "supports[0].on.vertices[0]: is vertex 99; expected one of"),
        (
            "/supports/0/on",
            json!({"at": [0.0, 0.0, 5.0]}),
            "supports[0].on.at: no vertex is at [0, 0, 5]; expected the",
        ),
        ("/supports/0/on", json!({}), "supports[0].on: picks no vertices"),
        ("/supports/0/on", json!({"box": [[9, 9, 9], [9, 9, 9]]}), "supports[0].on.box: no vertex is in it"),
        ("/supports/0/fixed", json!("xw"), "supports[0].fixed: expected true, letters"),
        ("/supports/0", json!({"on": {"vertices": [1]}}), "supports[0]: holds nothing; expected `fixed` or"),
        ("/loads/0/force", json!([0, 0]), "loads[0].force"),
        (
            "/loads/0",
            json!({"faces": [99], "pressure": 1}),
            "loads[0].faces[0]: is face 99; expected one of the pattern's 16",
        ),
        ("/loads/0", json!({"pressure": 1}), "loads[0]: is no load; expected"),
        ("/path/ends", json!([[99, "z", 1]]), "path.ends[0]: is vertex 99"),
        ("/path", json!({"step": 1, "stepss": 2}), "path.stepss: unknown field `stepss`"),
        ("/path", json!({"control": "fast"}), "path.control: data did not match"),
    ] {
        let got = changed(path, value);
        assert!(got.starts_with(told), "{path}: {got}");
    }
    for (path, value, told) in [
        ("/crease", json!({"law": "stiffened", "from": [300, 45], "k": 1}), "crease.from: is from 300 to 45; expected"),
        ("/facet", json!({"law": "stiffened", "from": 190, "k": 1}), "facet.from: is from 190 to 170; expected"),
        (
            "/supports",
            json!([{"on": {"vertices": [0]}, "fixed": true},
            {"on": {"vertices": [0]}, "displacement": [null, null, 1]}]),
            "supports[1]: vertex 0 is held at 0 and at 1 along z; expected one displacement",
        ),
        (
            "/supports",
            json!([{"on": {"vertices": [1]}, "displacement": [2, null, null]},
            {"on": {"vertices": [0, 1]}, "displacement": [3, null, null]}, {"on": {"vertices": [1]}, "fixed": "y"}]),
            "supports[1]: vertex 1 is held at 2 and at 3 along x; expected one displacement",
        ),
    ] {
        let got = changed(path, value);
        assert!(got.starts_with(told), "{path}: {got}");
    }
    let mut heavy = job();
    heavy["masses"] = json!([{"on": {"box": [[null, null, null], [null, null, null]]}, "mass": 2}]);
    let got = setup(&kresling(1.0), &heavy).expect_err("refused");
    assert!(got.starts_with("units.mass: is missing; expected that of the masses"), "{got}");
    let mut file = kresling(1.0);
    file["frame_unit"] = json!("mm");
    let got = setup(&file, &job()).expect_err("refused");
    assert!(got.starts_with("units.length: is `unit`; expected a length: the file's is `mm`"), "{got}");
    let mut file = kresling(1.0);
    file["edges_vertices"] = json!([[0, 8], [0, 1]]);
    for (key, value, told) in [
        (
            "edges_origami:rest_length",
            json!([null, -1]),
            "edges_origami:rest_length[1]: is -1; expected a length above 0",
        ),
        ("edges_origami:rest_angle", json!([30, 20]), "edges_origami:rest_angle[1]: is 20; expected an angle"),
        ("edges_origami:rest_angle", json!(["flat"]), "edges_origami:rest_angle[0]: is \"flat\"; expected an angle"),
    ] {
        let mut file = file.clone();
        file[key] = value;
        let got = setup(&file, &job()).expect_err("refused");
        assert!(got.starts_with(told), "{key}: {got}");
    }
    let mut unknown = job();
    unknown.as_object_mut().expect("an object").remove("units");
    unknown["sheet"] = json!({"E": 1, "nu": 0.3, "t": 1});
    let got = setup(&kresling(1.0), &unknown).expect_err("refused");
    assert!(got.starts_with("units: is missing; expected units"), "{got}");
    let mut file = kresling(1.0);
    file["vertices_origami:load"] = json!([null, [0, 1]]);
    let got = setup(&file, &job()).expect_err("refused");
    assert!(got.starts_with("vertices_origami:load[1]: is [0,1]; expected [fx, fy, fz]"), "{got}");
}

#[test]
fn what_is_wrong_with_a_design_is_told_by_key() {
    let design = json!({
        "goals": [{"height": {"of": {"vertices": [8]}, "above": {"vertices": [0]}, "wanted": 0.5}}],
        "variables": [{"rest_lengths": [0], "bounds": [0.5, 2]}]
    });
    let mut file = kresling(1.0);
    file["edges_vertices"] = json!([[0, 8], [0, 1], [0, 9], [1, 9], [8, 9]]);
    let told = |design: Value| {
        let mut job = job();
        job["path"]["steps"] = json!(60);
        job["design"] = design;
        let (document, pattern, model) = read(&file);
        let job = match Job::from_slice(job.to_string().as_bytes()) {
            Ok(job) => job,
            Err(error) => return error.to_string(),
        };
        let setup = job.setup(&document.key_frame, &pattern, &model).expect("a job");
        let found = job.design_setup(&setup, &pattern, &model).map_err(|error| error.to_string());
        let watched = found.and_then(|design| design.watched(&setup).map_err(|refused| refused.to_string()));
        watched.map(|all| format!("{} watched", all.len())).unwrap_or_else(|told| told)
    };
    assert_eq!(told(design.clone()), "1 watched");
    assert!(told(Value::Null).starts_with("design: is missing; expected `goals`"));
    for (path, value, wanted) in [
        ("/goals", json!([]), "design.goals: is missing; expected one or more"),
        ("/variables", json!([]), "design.variables: is missing; expected one or more"),
        ("/goals/0", json!({}), "design.goals[0]: has no goal, or several; expected `shape`"),
        ("/goals/0", json!({"barrier": 1, "compliance": true}), "design.goals[0]: has no goal, or several"),
        ("/goals/0/weight", json!(0), "design.goals[0].weight: is 0; expected a number above 0"),
        ("/goals/0", json!({"shape": [[99, [0, 0, 0]]]}), "design.goals[0].shape[0]: is vertex 99"),
        ("/goals/0", json!({"shape": []}), "design.goals[0].shape: is empty"),
        (
            "/goals/0",
            json!({"fold_angle": {"edge": 1, "wanted": 3}}),
            "design.goals[0].fold_angle.edge[0]: is edge 1; expected an edge between two faces",
        ),
        ("/goals/0/height/of", json!({"vertices": [77]}), "design.goals[0].height.of.vertices[0]: is vertex 77"),
        ("/variables/0/bounds", json!([2, 1]), "design.variables[0].bounds: is [2, 1]; expected two numbers in order"),
        ("/variables/0", json!({"bounds": [0, 1]}), "design.variables[0]: changes nothing, or several things"),
        (
            "/variables/0/rest_lengths",
            json!([9]),
            "design.variables[0].rest_lengths[0]: is edge 9; expected an edge, of the file's 5",
        ),
        (
            "/variables/0/rest_lengths",
            json!("facets"),
            "design.variables[0].rest_lengths: no edge of the file is meant",
        ),
        (
            "/variables/0",
            json!({"move": {"vertices": [8]}, "bounds": [0, 1]}),
            "design.variables[0].along: is no direction",
        ),
        (
            "/variables/0",
            json!({"stiffnesses": [0, 2], "together": true, "bounds": [0, 1]}),
            "design.variables[0].stiffnesses: edges 0 and 2 differ in length",
        ),
        ("/state", json!(7), "design.state: state 7 of "),
        ("/goals/0", json!({"barrier": 1}), "design.state: states 0 and 1 have indices 0 and 4; expected 0 and 1"),
        ("/load_factor", json!(1e9), "design.load_factor: 1000000000 is not reached"),
    ] {
        let mut changed = design.clone();
        match changed.pointer_mut(path) {
            Some(own) => *own = value,
            None => {
                let (parent, key) = path.rsplit_once('/').expect("a path");
                changed.pointer_mut(parent).expect("a parent")[key] = value;
            }
        }
        let got = told(changed);
        assert!(got.starts_with(wanted), "{path}: {got}");
    }
}
