//! Sweeps in parts, and the tables that are made of theirs.

use serde_json::{Value, json};

use crate::place::Place;

/// Two materials that do not need the same springs: two scenes.
const WORDS: &str = "sweep square.fold --percent 0:100:10 --k-face 0,0.2 -o out --quiet";

/// Both tables, without the times.
fn tables(place: &Place, folder: &str) -> (Value, String) {
    let mut table = place.json(&format!("{folder}/sweep.json"));
    assert!(table["seconds"]["solve"].is_f64());
    table.as_object_mut().unwrap().remove("seconds").unwrap();
    (table, place.text(&format!("{folder}/sweep.csv")))
}

/// The text of a table up to its times.
fn before_seconds(place: &Place, file: &str) -> String {
    place.text(file).split("\"seconds\"").next().unwrap().to_owned()
}

#[test]
fn parts_come_to_the_same_bytes_whatever_their_number_and_order() {
    let place = Place::new();
    place.run(WORDS).succeeds();
    let whole = tables(&place, "out");
    let text = before_seconds(&place, "out/sweep.json");
    assert_eq!(whole.0["scenes"].as_array().unwrap().len(), 2);
    for of in [1_usize, 2, 3, 7, 30] {
        std::fs::remove_dir_all(place.path("out")).unwrap();
        // Every third first, so that parts are not made in their order.
        let (some, others): (Vec<_>, Vec<_>) = (1..=of).partition(|i| i % 3 == 0);
        for i in some.into_iter().chain(others) {
            place.run(&format!("{WORDS} --shard {i}/{of}")).succeeds();
        }
        assert!(!place.has("out/sweep.json"), "no part is the whole");
        let said = place.run("merge out -o out");
        assert!(said.succeeds().starts_with("square.fold: 22 sheets, 22 converged"), "{}", said.stdout);
        assert!(tables(&place, "out") == whole, "in {of} parts");
        assert!(before_seconds(&place, "out/sweep.json") == text, "in {of} parts");
    }
}

#[test]
fn parts_are_named_in_any_order_and_go_on_where_a_part_ended_early() {
    let place = Place::new();
    place.run(WORDS).succeeds();
    let whole = tables(&place, "out");
    let ran = |i| place.run(&format!("{WORDS} --shard {i}/3 -o part{i}").replace("-o out ", ""));
    for i in [3, 1, 2] {
        ran(i).succeeds();
    }
    let merge = |parts: &str| place.run(&format!("merge {parts} -o whole"));
    merge("part3/sweep.3-of-3.json part1 part2").succeeds();
    assert!(tables(&place, "whole") == whole);
    std::fs::remove_dir_all(place.path("whole")).unwrap();

    // As a part that was killed leaves it.
    let path = place.path("part2/sweep.2-of-3.json");
    let mut table: Value = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    let rows = table["instances"].as_array_mut().unwrap();
    assert_eq!((rows.len(), &rows[0]["index"]), (7, &json!(7)));
    rows.truncate(3);
    table["complete"] = json!(false);
    place.put("part2/sweep.2-of-3.json", &table.to_string());
    merge("part1 part2 part3").fails(1, "row 10 is missing, 18 of 22 are there; expected all parts, complete");
    assert!(!place.has("whole"));
    let resumed = place.run(&WORDS.replace("-o out --quiet", "-o part2 --shard 2/3 --resume"));
    assert_eq!((resumed.code, resumed.stderr.as_str()), (0, "3 of 7 rows are taken from before\n"));
    assert!(resumed.stdout.starts_with("square.fold, part 2 of 3: 7 sheets"), "{}", resumed.stdout);
    merge("part1 part2 part3").succeeds();
    assert!(tables(&place, "whole") == whole);
}

#[test]
fn what_is_not_of_one_sweep_is_not_put_together() {
    let place = Place::new();
    let part = |i, percents: &str, folder| {
        place.run(&format!("sweep square.fold --percent {percents} -o {folder} --shard {i}/2 --quiet")).succeeds();
    };
    part(1, "0,50,100", "a");
    part(2, "0,50,99", "b");
    let merge = |parts: &str| place.run(&format!("merge {parts} -o whole"));
    merge("a b").fails(1, "made with percents [0.0,50.0,99.0], a/sweep.1-of-2.json with [0.0,50.0,100.0]");
    merge("a").fails(1, "row 1 is missing, 1 of 3 are there");
    merge("a/none.json").fails(1, "a/none.json: ");
    place.run("sweep square.fold -o c --quiet").succeeds();
    merge("c").fails(1, "c: has no table of a part; expected one such as sweep.1-of-2.json");
    merge("c/sweep.json").fails(1, "c/sweep.json: settings.shard: is missing");
    place.put("d.json", "[]");
    merge("d.json").fails(1, "d.json: invalid type");

    // A part twice is no harm as long as both say the same.
    part(2, "0,50,100", "d");
    std::fs::create_dir(place.path("e")).unwrap();
    let copied = place.text("d/sweep.2-of-2.json");
    place.put("e/sweep.2-of-2.json", &copied);
    merge("a d e").succeeds();
    let mut changed = place.json("d/sweep.2-of-2.json");
    changed["instances"][1]["steps"] = json!(3);
    place.put("e/sweep.2-of-2.json", &changed.to_string());
    merge("a d e").fails(1, "is another in another part; expected each once");
    place.put("e/sweep.2-of-2.json", &copied.replacen("\"scene\": 0", "\"scene\": 7", 1));
    merge("a e").fails(1, "instances[0].scene: is not among the 1 scenes");
}

#[test]
fn a_part_that_is_not_there_is_refused_before_any_work() {
    let place = Place::new();
    for (shard, words) in [
        ("0/2", "there is no part 0 of 2"),
        ("3/2", "there is no part 3 of 2"),
        ("x", "expected I/N, such as 2/8"),
        ("slurm", "SLURM_ARRAY_TASK_ID is not set; expected a job of an array"),
    ] {
        place.run(&format!("sweep square.fold -o out --shard {shard}")).fails(1, words);
    }
    assert_eq!(place.names(), ["square.fold"]);
    let mut command = place.command();
    command.args("sweep square.fold --percent 0:100:50 -o out --shard kubernetes/3".split(' '));
    let output = command.env("JOB_COMPLETION_INDEX", "2").output().unwrap();
    assert!(output.status.success());
    assert_eq!(place.json("out/sweep.3-of-3.json")["instances"][0]["percent"], json!(100.0));
}
