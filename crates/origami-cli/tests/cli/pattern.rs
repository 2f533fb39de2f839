//! `origami pattern`.

use serde_json::json;

use crate::place::Place;

#[test]
fn what_is_listed_can_be_made_and_folded() {
    let place = Place::new();
    let list = place.run("pattern --list");
    let names: Vec<&str> = list
        .succeeds()
        .lines()
        .filter(|line| !line.starts_with(' '))
        .filter_map(|l| l.split_once(':'))
        .map(|l| l.0)
        .collect();
    assert!(names.len() >= 11, "{names:?}");
    for name in names {
        let made = place.run(&format!("pattern {name} -o {name}.fold"));
        assert_eq!((made.code, made.stdout.as_str(), made.stderr.as_str()), (0, "", ""), "{name}");
        let folded = place.run(&format!("fold {name}.fold -o out/ --percent 20 --max-steps 200 --quiet"));
        assert!([0, 3].contains(&folded.code), "{name}: {}", folded.stderr);
    }
}

#[test]
fn parameters_are_heard() {
    let place = Place::new();
    place.run("pattern miura --set columns=3 --set rows=2 -o m.fold").succeeds();
    let document = place.json("m.fold");
    assert_eq!(document["faces_vertices"].as_array().unwrap().len(), 6);
    assert_eq!(document["frame_title"], json!("miura, columns 3, rows 2"));
    let piped = place.run("pattern miura --set columns=3 --set rows=2 -o -");
    assert_eq!(piped.succeeds(), place.text("m.fold"));
}

#[test]
fn unknown_names_and_values_out_of_range_are_refused() {
    let place = Place::new();
    place.run("pattern swan -o s.fold").fails(1, "error: swan: is not known; expected single-crease, ");
    place.run("pattern miura --set wings=2 -o s.fold").fails(1, "error: parameter wings: miura has none of this name");
    place.run("pattern miura --set columns=0 -o s.fold").fails(1, "error: parameter columns");
    place.run("pattern miura --set columns=2.5 -o s.fold").fails(1, "error: parameter columns");
    place.run("pattern miura -o s.obj").fails(1, "s.obj: crease patterns are written as FOLD");
    assert_eq!(place.names(), ["square.fold"]);
}
